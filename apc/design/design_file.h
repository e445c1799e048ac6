/// A finished design as it is kept on disk (schema "apc-design/1"): the bed to build, the fleet it was sized for, and
/// what certified it. `apc design` writes it; `apc reliability` and `apc report` start from it.
#pragma once

#include "apc/design/size_bed.h"

namespace apc::design {

struct DesignFile {
  std::string program, command;  ///< what made it
  Objective objective = Objective::length;
  Fleet fleet;
  bed::Bed bed;
  double speed_factor = 1.0;
  std::vector<std::string> methods;  ///< of the certificate
  double difference = 0.0, gradient_error = 0.0, stationarity = 0.0;
  bool agreed = false;
  std::vector<std::string> active;  ///< constraints that hold the optimum, heaviest first
};

/// InputError for anything that is no design of this version.
DesignFile load_design(const std::filesystem::path&);

}  // namespace apc::design
