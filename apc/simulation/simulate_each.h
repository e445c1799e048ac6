/// Many overruns at once, on several threads and in the lanes of vectors. Every result has the bits of simulate()
/// alone, whatever the neighbours, the order, the number of threads and the processor (SolverStatistics::wall_s apart).
#pragma once

#include <span>

#include "apc/simulation/convoy.h"

namespace apc::simulation {

/// In the order of the errands. `threads` = 0: all. Runs that lanes do not carry (fits_lanes) go through simulate().
std::vector<Outturn> simulate_each(std::span<const Errand>, unsigned threads = 1);

}  // namespace apc::simulation
