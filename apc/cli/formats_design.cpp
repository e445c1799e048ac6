#include "apc/cli/formats.h"

namespace apc::cli {

FormatNote describe_fleet() {
  return {
      "apc-fleet/1",
      "what a bed must do: aircraft with their cases, limits, and the beds to choose from",
      "JSON. One entry per aircraft with one or more cases; every case is an overrun that the bed must stop within the "
      "limits. Limits that contradict each other are refused.",
      {
          {"schema", "text", "required", "names the format", "\"apc-fleet/1\""},
          {"name", "text", "required", "how reports call it", "\"three aircraft\""},
          {"source", "text", "required", "where the numbers come from", "\"traffic forecast 2030\""},
          {"aircraft[].aircraft", "text", "required", "shipped name or file; each once", "\"B737-800\""},
          {"aircraft[].cases[].name", "text", "optional; \"case 1\"", "how reports call it", "\"take-off weight\""},
          {"aircraft[].cases[].speed", "speed", "required", "to be stopped from, at the bed's edge", "\"70 kt\""},
          {"aircraft[].cases[].mass", "mass", "optional; the aircraft's", "", "\"66 t\""},
          {"aircraft[].cases[].cg_behind_nose_gear", "length", "optional; the aircraft's", "centre of gravity",
           "\"14.8 m\""},
          {"aircraft[].cases[].braking", "number", "optional; 0", "friction coefficient of the braked wheels", "0.25"},
          {"aircraft[].cases[].braking_in_bed", "number", "optional; as before the bed", "the same inside the bed",
           "0.0"},
          {"aircraft[].cases[].thrust", "force", "optional; 0", "net, forward positive", "\"0 kN\""},
          {"aircraft[].cases[].headwind", "speed", "optional; 0", "along the runway", "\"0 kt\""},
          {"floor_speed", "speed", "optional; 0", "every case is stopped from at least this speed", "\"40 kt\""},
          {"limits.criterion", "text", "optional; \"limit\"", "\"limit\" (no damage) or \"ultimate\" (no collapse)",
           "\"limit\""},
          {"limits.deceleration", "acceleration", "optional; none", "peak", "\"1.0 g\""},
          {"limits.deceleration_100ms", "acceleration", "optional; none", "largest mean over 0.1 s", "\"0.9 g\""},
          {"limits.loads", "list of texts", "optional; all known",
           "which gear loads count: nose drag, nose vertical, main drag, main vertical", "[\"nose drag\"]"},
          {"limits.table_range", "true or false", "optional; true", "penetration stays within the load tables", "true"},
          {"bed.material", "text", "required", "a material with load tables (apc list loads)", "\"foam_50psi\""},
          {"bed.flush", "text", "optional; \"top\"", "as in apc-bed/1", "\"top\""},
          {"bed.setback, bed.width", "length", "required", "as in apc-bed/1", "\"50 ft\""},
          {"bed.grade", "number", "optional; 0", "rise over run", "0.0"},
          {"bed.depth.minimum, .maximum", "length", "required", "of the depths to choose", "\"6 in\""},
          {"bed.ramp.minimum, .maximum", "length", "required", "from depth 0 to the first chosen depth", "\"50 ft\""},
          {"bed.maximum_slope", "number", "optional; 0.1", "change of depth per length", "0.05"},
          {"bed.maximum_length", "length", "required", "of the bed", "\"600 ft\""},
          {"bed.nodes", "number", "optional; 4", "depths to choose, 1 to 12", "4"},
          {"bed.blocks.length, .width, .depth_step", "length", "required", "of blocks as built", "\"4 ft\""},
      }};
}

FormatNote describe_site() {
  return {"apc-site/1",
          "the end of a runway behind which a bed shall lie",
          "JSON. \"apc site --airport CODE --runway NAME\" writes one from an installed airport data set.",
          {
              {"schema", "text", "required", "names the format", "\"apc-site/1\""},
              {"name", "text", "required", "how reports call it", "\"runway 09, overrun of the end 27\""},
              {"source", "text", "required", "where the numbers come from", "\"survey 2024\""},
              {"runway_end.latitude", "angle", "required", "of the pavement end, on the centreline, north positive",
               "\"40.6 deg\""},
              {"runway_end.longitude", "angle", "required", "east positive", "\"-73.8 deg\""},
              {"runway_end.true_heading", "angle", "required", "of the aircraft that overrun this end", "\"92.4 deg\""},
              {"runway_end.width", "length", "required", "of the runway", "\"150 ft\""},
              {"safety_area.length", "length", "required", "behind the pavement end", "\"1000 ft\""},
              {"safety_area.width", "length", "required", "across, not below the runway's", "\"500 ft\""},
              {"minimum_setback", "length", "optional; 0", "of a bed from the pavement end", "\"35 ft\""},
              {"grade", "number", "optional; 0", "rise over run", "-0.005"},
              {"elevation", "length", "optional; 0", "of the pavement end above sea level", "\"98 ft\""},
              {"displaced_threshold", "length", "optional; 0",
               "from the pavement end back to where landings the other way may touch down", "\"500 ft\""},
          }};
}

FormatNote describe_scatter() {
  return {
      "apc-scatter/1",
      "what scatters from one overrun to the next, for apc reliability",
      "JSON. Standard deviations are of normal distributions cut at three of them; ranges are uniform. What is left "
      "out keeps this project's estimate.",
      {
          {"schema", "text", "required", "names the format", "\"apc-scatter/1\""},
          {"source", "text", "required", "where the numbers come from", "\"airline's records 2015-2024\""},
          {"mass", "number", "optional; 0.03", "relative standard deviation", "0.03"},
          {"cg", "number", "optional; 0.01", "standard deviation, share of the wheelbase", "0.01"},
          {"braking", "two numbers", "optional; [0, 0.25]", "range of the friction coefficient", "[0, 0.25]"},
          {"strength", "number", "optional; 0.04", "relative standard deviation, of the bed as a whole", "0.04"},
          {"depth", "number", "optional; 0.02", "relative standard deviation, as built", "0.02"},
          {"block_strength", "number", "optional; 0.08", "standard deviation of its logarithm, block to block", "0.08"},
          {"correlation", "length", "optional; 2.4 m", "of block strengths along the runway", "\"2.4 m\""},
          {"temperature", "temperature", "optional; 15 degC", "mean", "\"15 degC\""},
          {"temperature_scatter", "temperature", "optional; 12 K", "standard deviation", "\"12 K\""},
          {"per_kelvin", "number", "optional; 0.0005", "loss of strength above 20 degC", "0.0005"},
          {"years", "two numbers", "optional; [0, 20]", "range of the bed's age", "[0, 20]"},
          {"per_year", "number", "optional; 0.0015", "loss of strength", "0.0015"},
      }};
}

FormatNote describe_design() {
  return {
      "apc-design/1",
      "a finished design: the bed to build, the fleet it was sized for, and what certified it",
      "JSON, written by apc design; apc reliability and apc report start from it. Edit the fleet and design again "
      "instead of editing this.",
      {
          {"schema", "text", "required", "names the format", "\"apc-design/1\""},
          {"feasible", "true or false", "required", "false: no bed keeps the limits, and there is none here", "true"},
          {"objective", "text", "required", "length, volume, minimax or speed", "\"length\""},
          {"criterion", "text", "required", "limit or ultimate", "\"limit\""},
          {"bed", "apc-bed/1", "required", "as built, in blocks", "{...}"},
          {"fleet", "apc-fleet/1", "required", "as it was read", "{...}"},
          {"speed_factor", "number", "optional; 1", "on the speeds of the cases", "1.0"},
          {"certificate", "object", "required",
           "methods, difference, gradient_error, stationarity, agreed, active[].constraint", "{...}"},
          {"provenance", "object", "required", "program and command that made it", "{...}"},
      }};
}

FormatNote describe_model() {
  return {
      "apc-model/1",
      "effects added to the model, with their values: what --model takes",
      "JSON, written by apc add and apc learn; the same by hand is as good. \"apc effects list\" names the effects, "
      "\"apc effects show ID\" their parameters.",
      {
          {"schema", "text", "required", "names the format", "\"apc-model/1\""},
          {"source", "text", "required", "where the values come from", "\"learned from three runs\""},
          {"effects[].id", "text", "required", "an effect of the catalogue", "\"inertial\""},
          {"effects[].parameters", "object", "required",
           "values by name, each with its unit; what is left out keeps its usual value", "{\"C\": 0.3}"},
          {"learned_on.runs", "list of texts", "optional", "the runs it was learned on", "[\"run1\"]"},
          {"learned_on.speed", "two speeds", "required within learned_on",
           "lowest and highest; a warning is given outside", "[\"40 kt\", \"70 kt\"]"},
          {"learned_on.mass", "two masses", "required within learned_on", "lowest and highest", "[\"20 t\", \"22 t\"]"},
          {"verdict", "text", "optional", "of the diagnosis", "\"found\""},
          {"command", "text", "optional", "that wrote it", "\"apc add ...\""},
      }};
}

FormatNote describe_manifest() {
  return {"apc-manifest/1",
          "what a compliance report was made from, and what came out",
          "JSON, written by apc report; \"apc report --manifest FILE\" makes the report again, byte for byte. It holds "
          "for one version of the program and for the files as they were; start in the folder in which it was made.",
          {
              {"schema", "text", "required", "names the format", "\"apc-manifest/1\""},
              {"program", "text", "required", "name and version that made the report", "\"apc 0.1.0\""},
              {"command", "text", "required", "that made it", "\"apc report --design d/design.json\""},
              {"files[].role, .path, .sha256, .source", "text", "required", "every file that was read", "\"design\""},
              {"arguments.design", "text", "required", "the design", "\"d/design.json\""},
              {"arguments.site, .model, .loads, .tires", "text", "optional", "as given to apc report",
               "\"example_runway_end\""},
              {"made[].name, .sha256", "text", "required", "every file that was written", "\"report.html\""},
          }};
}

}  // namespace apc::cli
