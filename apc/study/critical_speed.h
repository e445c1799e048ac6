/// The largest exit speed a bed can handle: from which the aircraft still stops within the bed, and from which it does
/// so with every load within its limit.
#pragma once

#include <functional>

#include "apc/study/sweep.h"

namespace apc::study {

struct SpeedRange {
  double low = 5.0, high = 60.0;  ///< m/s; the answer is `high` when even that can be handled, 0 when `low` cannot
  double tolerance = 0.01;        ///< m/s
  double value_tolerance = 0.0;   ///< |excess| up to which a speed counts as the answer
};

/// Root of an increasing `excess(v)` (≤ 0 = can be handled) by regula falsi in v² (Illinois variant): a stop distance
/// is nearly linear in v². `guess` 0 = the middle of the range.
double largest_speed(const std::function<double(double)>& excess, double guess, const SpeedRange&);

/// The largest load over its limit of a run; at or below 1 when all is well.
using Use = std::function<double(const simulation::Result&)>;

struct CriticalSpeed {
  double arrest = 0.0;  ///< m/s: stops with the nose wheel at the bed's far end
  double intact = 0.0;  ///< m/s: stops, and no load passes its limit on the way; ≤ arrest
  int runs = 0;
};

/// `bed_end` is where the nose wheel must be at rest at the latest; the model's bed is continued beyond it at its last
/// depth. `guess` 0 = unknown. Throws SolveError when a run cannot be solved.
CriticalSpeed critical_speed(const simulation::Model&, const simulation::Overrun&, double bed_end, const Use&,
                             const Solve&, const simulation::Options&, const CriticalSpeed& guess = {},
                             const SpeedRange& = {});

/// The bed continued at its last depth, so that a stop distance exists for any speed.
bed::Bed continued(bed::Bed);

}  // namespace apc::study
