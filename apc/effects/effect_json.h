/// Effects in files: a user's own law (schema "apc-effect/1") and the overlay that adds effects to a model.
///
///     { "schema": "apc-effect/1", "id": "crumbling", "title": "…", "source": "…",
///       "acts_on": "drag", "formula": "k*b*p*(v/v0)^n",
///       "parameters": { "k": { "unit": "Pa", "low": 0, "high": 4e4, "usual": 1e4 }, … } }
///
/// `acts_on`: drag, vertical (N per tire, added in the bed), strength (a factor: 1 + formula). The first parameter is
/// the amplitude. Names a formula may use: v speed, p penetration, s wheel's bed distance, h bed depth, t time, b and R
/// tire width and radius, rho bed density, W vertical load per tire, T temperature (K), years, x nose distance.
#pragma once

#include <filesystem>

#include "apc/base/json.h"
#include "apc/effects/alterations.h"

namespace apc::effects {

/// InputError with file and place, also for wrong units.
Effect load_own_effect(const std::filesystem::path&);
Effect read_own_effect(const Json&);

/// Reads the "effects" array of an overlay: [{ "id": "seams", "parameters": { "depth": 0.3, "pitch": "1.22 m" } }].
std::vector<Applied> read_applied(const std::vector<Json>&, const std::vector<Effect>& known);

}  // namespace apc::effects
