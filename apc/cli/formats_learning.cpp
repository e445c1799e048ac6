#include "apc/cli/formats.h"

namespace apc::cli {

FormatNote describe_case() {
  return {
      "apc-case/1",
      "measured runs and the model they are held against, for apc compare, diagnose, next, learn",
      "JSON, in a folder of its own; paths are relative to it.",
      {
          {"schema", "text", "required", "names the format", "\"apc-case/1\""},
          {"title", "text", "optional; the folder's name", "how reports call it", "\"B727, two stops\""},
          {"aircraft", "path", "required", "file of the format apc-aircraft/1", "\"aircraft.json\""},
          {"tires", "path", "required", "file of the format apc-tire/1 with every tire of the aircraft",
           "\"tires.json\""},
          {"bed", "path", "required", "file of the format apc-bed/1", "\"bed.json\""},
          {"loads", "list of paths", "required", "load samples or tables (apc-loads/1), one per tire",
           "[\"loads_main.csv\", \"loads_nose.csv\"]"},
          {"runs", "list of paths", "required", "measured runs (apc-run/1)", "[\"runs/run1.json\"]"},
          {"held_out", "list of paths", "optional", "runs to be predicted: conditions and channels, no data",
           "[\"held/held1.json\"]"},
          {"scatter.block_strength", "number", "optional; 0.08",
           "standard deviation of the logarithm of blocks' strength", "0.05"},
          {"scatter.correlation", "length", "optional; 2.4 m", "of that, exponential along the runway", "\"2.4 m\""},
          {"scatter.bed_strength", "number", "optional; 0.04",
           "standard deviation of the logarithm of the whole bed's strength from its data sheet", "0.3"},
          {"seed", "number", "optional", "kept, not used", "1"},
      }};
}

FormatNote describe_run() {
  return {
      "apc-run/1",
      "one measured run: conditions, instruments, signals, rut survey, where it ended",
      "JSON with CSV beside it. Anything that was not measured is left out; what a run cannot tell is then said by the "
      "diagnosis. Signals: a column time [s], 0 when the nose wheel crosses the bed's edge, and one per channel, empty "
      "cells where it has no sample. Survey: distance [m] from the edge, nose_rut and main_rut.",
      {
          {"schema", "text", "required", "names the format", "\"apc-run/1\""},
          {"id", "text", "optional; the file's", "how reports call the run", "\"run1\""},
          {"mass", "mass", "optional; the aircraft's ± 15 %", "at the run", "\"65000 kg\""},
          {"cg_behind_nose_gear", "length", "optional; the aircraft's", "at the run", "\"14.7 m\""},
          {"pitch_inertia", "inertia", "optional; the aircraft's, scaled with mass", "at the run", "\"3.0e6 kg m^2\""},
          {"entry.speed", "speed", "required", "when the nose wheel crosses the bed's edge", "\"60 kt\""},
          {"braking", "number", "optional; 0", "friction on the braked wheels' vertical load", "0.25"},
          {"thrust", "force", "optional; 0", "net, forward positive", "\"9.3 kN\""},
          {"wind", "speed", "optional; 0", "headwind positive", "\"2 m/s\""},
          {"temperature", "temperature", "optional; 20 degC", "of the bed", "\"5 degC\""},
          {"lane", "text", "optional; a lane of its own", "runs of one lane share part of the blocks' pattern",
           "\"A\""},
          {"date", "text", "optional", "with the bed's \"built\" gives its age", "\"2025-03-01\""},
          {"uncertainty.mass", "mass", "optional; 1 %", "one standard deviation", "\"650 kg\""},
          {"uncertainty.cg_behind_nose_gear", "length", "optional; 0.02 m", "one standard deviation", "\"0.02 m\""},
          {"uncertainty.pitch_inertia", "inertia", "optional; 3 %", "one standard deviation", "\"9e4 kg m^2\""},
          {"uncertainty.entry_speed", "speed", "optional; 0.2 m/s", "one standard deviation", "\"0.3 m/s\""},
          {"uncertainty.wind", "speed", "optional; 0.8 m/s", "one standard deviation", "\"1 m/s\""},
          {"uncertainty.clock", "time", "optional; 0.01 s", "one standard deviation of the time axis' offset",
           "\"0.01 s\""},
          {"signals", "path", "optional", "CSV of the channels", "\"run1.csv\""},
          {"channels.COLUMN.quantity", "text", "required per channel",
           "speed, acceleration_x, acceleration_z, pitch, pitch_rate, nose_stroke, main_stroke, nose_drag, "
           "nose_vertical, "
           "main_drag, main_vertical, nose_spin, main_spin or nose_distance",
           "\"acceleration_x\""},
          {"channels.COLUMN.noise", "in the channel's unit", "required", "one standard deviation of a sample",
           "\"0.03 g\""},
          {"channels.COLUMN.bias", "in the channel's unit", "optional", "standard deviation of a constant error",
           "\"0.02 g\""},
          {"channels.COLUMN.lag", "time", "optional; 0", "root mean square of the delay, never negative", "\"0.1 s\""},
          {"channels.COLUMN.scale", "number", "optional; 0.003", "standard deviation of a constant factor", "0.003"},
          {"channels.COLUMN.lever_arm", "length", "optional; 0",
           "of an accelerometer, forward of the centre of gravity", "\"1.2 m\""},
          {"survey", "path", "optional", "CSV of rut depths", "\"run1_rut.csv\""},
          {"survey_noise", "length", "optional; 0.015 m", "one standard deviation of a reading", "\"0.015 m\""},
          {"stop.value", "length", "optional", "nose wheel at rest, from the bed's edge", "\"420 ft\""},
          {"stop.noise", "length", "optional; 0.3 m", "one standard deviation", "\"3 ft\""},
          {"exit.speed", "speed", "optional", "instead of a stop: when the nose wheel leaves the bed", "\"12 m/s\""},
      }};
}

FormatNote describe_effect() {
  return {
      "apc-effect/1",
      "a law of your own in one line, ranked beside the catalogue by --effect",
      "JSON. The formula knows v speed, p penetration, s distance of the wheel in the bed, h bed depth, t time, b and "
      "R "
      "width and radius of the tire, rho density, W vertical load per tire, T temperature, years, x distance of the "
      "nose "
      "wheel, the parameters, + - * / ^ and exp, ln, sqrt, tanh, sin, cos, abs, min, max, step. Its unit is checked.",
      {
          {"schema", "text", "required", "names the format", "\"apc-effect/1\""},
          {"id", "text", "required", "as reports call it; none of the catalogue's", "\"hump\""},
          {"title", "text", "optional; the id", "one sentence", "\"drag that is highest at one speed\""},
          {"source", "text", "required", "where the law comes from", "\"a guess\""},
          {"acts_on", "text", "required", "drag or vertical (N per tire, added) or strength (a factor: 1 + formula)",
           "\"drag\""},
          {"formula", "text", "required", "the law", "\"k*b*p*exp(-((v-v1)/v2)^2)\""},
          {"parameters.NAME.unit", "text", "optional; none",
           "of the parameter; the first one is the amplitude, 0 changes nothing", "\"kPa\""},
          {"parameters.NAME.low", "number", "required", "lower end of what is possible, in that unit", "0"},
          {"parameters.NAME.high", "number", "required", "upper end", "100"},
          {"parameters.NAME.usual", "number", "optional; the middle", "taken when nobody says otherwise", "40"},
      }};
}

}  // namespace apc::cli
