#include "apc/cli/formats.h"

namespace apc::cli {

FormatNote describe_bed() {
  return {
      "apc-bed/1",
      "an arrestor bed: where it starts, its depth along the runway, its material",
      "JSON. The depth is piecewise linear from the leading edge; the last distance is the bed's length.",
      {
          {"schema", "text", "required", "names the format", "\"apc-bed/1\""},
          {"name", "text", "required", "how reports call it", "\"18 in, 400 ft\""},
          {"source", "text", "required", "where the numbers come from", "\"design drawing 7, 2019\""},
          {"setback", "length", "required", "from the pavement end to the leading edge", "\"50 ft\""},
          {"width", "length", "required", "across the runway", "\"150 ft\""},
          {"material", "text", "required", "a material with load tables (apc list loads)", "\"foam_50psi\""},
          {"flush", "text", "optional; \"top\"",
           "\"top\": surface level with the pavement, base falls away; \"base\": base level, surface rises", "\"top\""},
          {"profile.distance", "list of lengths", "required", "from the leading edge: 0 first, then increasing",
           "{\"unit\": \"ft\", \"values\": [0, 50, 400]}"},
          {"profile.depth", "list of lengths", "required", "of crushable material, one per distance, 0 or more",
           "{\"unit\": \"in\", \"values\": [0, 18, 18]}"},
          {"blocks.length", "length", "optional", "of one block along the runway", "\"4 ft\""},
          {"blocks.width", "length", "with blocks.length", "of one block across", "\"4 ft\""},
          {"grade", "number", "optional; 0", "rise over run of the whole site", "0.0"},
          {"nominal.strength", "pressure", "optional", "data-sheet crushing strength", "\"50 psi\""},
          {"nominal.density", "density", "optional", "data-sheet density", "\"320 kg/m^3\""},
          {"nominal.bottoming_strain", "number", "optional", "volumetric strain when fully compacted", "0.85"},
          {"built", "text", "optional", "date of installation, for the bed's age", "\"2019-03-01\""},
      }};
}

FormatNote describe_loads() {
  return {
      "apc-loads/1",
      "loads of one tire in one material: samples (CSV) or a table (HDF5)",
      "CSV: UTF-8, comma, \"# key: value\" lines first, then one header row \"name [unit]\", then numbers; columns in "
      "any order and unit, unknown ones are ignored. Rows are samples and need not fill a grid. Steady state, "
      "free-rolling, unbraked, per tire. HDF5 tables are made from them by \"apc loads fit\" or \"apc loads import\".",
      {
          {"# schema", "text", "required", "names the format", "apc-loads/1"},
          {"# material", "text", "required", "as beds name it", "foam_50psi"},
          {"# tire", "text", "required", "as gears name it", "H29x9.0-15"},
          {"# source", "text", "required", "who made the samples and how", "single-wheel simulations"},
          {"# drag_rms", "number", "optional", "relative error of the drag", "0.03"},
          {"# vertical_rms", "number", "optional", "relative error of the vertical load", "0.03"},
          {"speed", "speed", "required", "of the axle, forward", "speed [kt]"},
          {"bed_depth", "length", "required", "of the material under the tire", "bed_depth [in]"},
          {"penetration", "length", "required", "undeformed tire's lowest point below the surface", "penetration [in]"},
          {"drag", "force", "required", "opposes motion, 0 or more", "drag [kN]"},
          {"vertical", "force", "required", "pushes the tire up, 0 or more", "vertical [kN]"},
          {"rut_depth", "length", "optional", "of the surface left behind", "rut_depth [in]"},
          {"spin_ratio", "number", "optional", "wheel speed over free rolling, w R / v", "spin_ratio"},
      }};
}

}  // namespace apc::cli
