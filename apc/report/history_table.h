/// The time history as a table of named columns with units, and its two files: CSV and HDF5 (SI both; the sampling is
/// the simulation's).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/csv.h"
#include "apc/report/record.h"

namespace apc::report {

/// Columns "time", "distance", "speed", …, then per gear group "nose_drag", "nose_vertical", "nose_stroke", … in SI.
/// Gear forces are of the whole group.
std::vector<CsvColumn> history_table(const simulation::Result&);

/// CSV with the run's key figures and inputs as `# key: value` lines.
std::string history_csv(const OverrunRecord&);

/// HDF5: /history/NAME with unit attributes; the root carries inputs and outcome as attributes.
void save_history(const OverrunRecord&, const std::filesystem::path&);

}  // namespace apc::report
