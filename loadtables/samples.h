/// Samples of a tire's load: what SPH runs and exchange files hold, before they become a table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "loadtables/load_table.h"

namespace apc::loadtables {

struct Sample {
  TireContact contact;
  TireLoad load;
};

struct SampleSet {
  std::string material, tire, source;
  bool has_rut = false, has_spin = false;     ///< which optional responses the samples carry
  double drag_rms = 0.0, vertical_rms = 0.0;  ///< relative error the maker states; 0 when unknown
  std::vector<Sample> samples;
};

/// Tire and material of an exchange file; empty when the file is of another kind.
TableHead loads_csv_head(const std::filesystem::path&);

/// CSV exchange form "apc-loads/1": remarks schema, material, tire, source; columns speed, bed_depth, penetration,
/// drag, vertical and optionally rut_depth, spin_ratio, in any order and unit. InputError with file and line otherwise.
SampleSet read_loads_csv(const std::filesystem::path&);
void write_loads_csv(const SampleSet&, const std::filesystem::path&);

}  // namespace apc::loadtables
