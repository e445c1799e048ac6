/// The only reader of SPH decks (`apc-sph/1`): one rolling run.
///
///     { "schema": "apc-sph/1", "source": "...", "tire": "H44.5x16.5-21", "material": "foam_50psi",
///       "bed_depth": "24 in", "penetration": "16 in", "speed": "70 kt", "spacing": "2 in", "friction": 0.3 }
/// `tire` is a name, or an object with the keys of apc-tire/1; `material` a name or path, or an object of
/// apc-material/1. Optional: spacing, friction, bed_half_width, outer_wall, ahead, behind, press_speed,
/// accelerate_distance, entry, spin, fall, release_spin_ratio, viscosity {alpha, beta}, cfl, longest, load_tolerance,
/// spin_tolerance.
/// Quantities may be written in lbf-in-s: "3.75e-5 lbf s^2/in^4".
#pragma once

#include <filesystem>
#include <functional>

#include "apc/base/json.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {

/// Where names in a deck lead; the caller knows the shipped data. An empty function refuses names.
struct DeckNames {
  std::function<TireShape(const std::string& name)> tire;
  std::function<std::filesystem::path(const std::string& name)> material;
};

/// Throws InputError (file, place, value, what to do) for a deck that makes no sense.
RollingCase read_deck(const Json&, const DeckNames&);
RollingCase load_deck(const std::filesystem::path&, const DeckNames&);

/// Keys of apc-tire/1.
TireShape read_tire_shape(const Json&);

}  // namespace apc::sph
