/// The only reader of foam files (`apc-material/1`, designs/materials/*.json).
#pragma once

#include <filesystem>

#include "apc/base/json.h"
#include "sph_backend/foam.h"

namespace apc::sph {

/// What the file says about the foam as a product, beside the law.
struct FoamData {
  Foam foam;
  std::string source;
  double nominal_strength = 0.0;   ///< Pa
  double nominal_density = 0.0;    ///< kg/m³
  double bottoming_strain = 0.85;  ///< where the load curve locks
};

/// Throws InputError (file, place, value, what to do) for a curve that does not increase in strain, a density or
/// modulus that is not positive, a strain outside [0, 1], a strength that is not positive.
FoamData read_foam(const Json&);
FoamData load_foam(const std::filesystem::path&);

}  // namespace apc::sph
