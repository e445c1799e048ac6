/// A rolling run on disk: everything that changes, neighbour lists included, so that a resumed run gives the same bits
/// as one that was never interrupted.
#pragma once

#include <filesystem>

#include "sph_backend/rolling_run.h"

namespace apc::sph {

void save_checkpoint(const RollingRun&, const std::filesystem::path&);

/// Puts the stored state into a run freely started from the same case; InputError when the file belongs to another
/// case.
void load_checkpoint(RollingRun&, const std::filesystem::path&);

}  // namespace apc::sph
