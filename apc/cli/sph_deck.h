/// One SPH run as a file (`apc-sph/1`): a tire, a material, speed, depth, penetration, spacing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/report/record.h"
#include "sph_backend/tire_rig.h"

namespace apc::cli {

struct SphDeck {
  std::string name, source, material;
  sph::RollingCase rig;
  std::vector<report::InputFile> files;  ///< deck, tires, material
};

/// Throws InputError: file, place, value, what to do. Tires and materials resolve to shipped data; a tires.json and
/// material files beside the deck work too.
SphDeck read_deck(const std::filesystem::path&);

}  // namespace apc::cli
