/// One overrun with everything a reader needs to judge and to repeat it: what existed, what was asked, how it was
/// solved, what came out, and where every input came from. Reports only read it.
#pragma once

#include <string>
#include <vector>

#include "apc/simulation/sensitivity.h"

namespace apc::report {

/// One file the run depended on.
struct InputFile {
  std::string role;    ///< "aircraft", "bed", "tires", "load table"
  std::string path;    ///< as resolved
  std::string sha256;  ///< of its bytes, hexadecimal
  std::string source;  ///< what the file says about where its numbers come from
};

/// What it takes to make the run again.
struct Manifest {
  std::string version;  ///< "apc 0.1.0"
  std::string command;  ///< as typed
  std::string date;     ///< UTC, of the report; the simulation itself knows no clock
  std::vector<InputFile> files;
};

/// Derivatives of the run's results by one of its inputs, asked for beside the run.
struct Derivatives {
  simulation::Sensitivity by;
  std::string unit;  ///< of the input
};

struct OverrunRecord {
  simulation::Model model;
  simulation::Overrun overrun;
  simulation::Options options;
  simulation::Result result;
  Manifest manifest;
  std::vector<Derivatives> sensitivities{};
};

/// The limit that comes nearest to being reached: the smallest margin over all gears and kinds of load.
struct WorstMargin {
  std::string gear;                                              ///< "nose"; empty when no limit is known
  std::string load;                                              ///< "drag" or "vertical"
  std::string rule;                                              ///< "14 CFR 25.509 from ramp weight"
  double margin = 0.0, peak = 0.0, limit = 0.0, distance = 0.0;  ///< limit/peak − 1; N per strut; m
};
WorstMargin worst_margin(const simulation::Result&);

/// Rows of the history at about `count` places, evenly spread in distance, always with the first and last row and the
/// rows where any gear load peaks, so that a thinned plot shows the same peaks as the table.
std::vector<std::size_t> thinned_rows(const simulation::History&, std::size_t count);

}  // namespace apc::report
