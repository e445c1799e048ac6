/// What may be traded: the front of length, margin and volume. For each margin asked of every load limit, the shortest
/// bed and the one of smallest volume that keep it; points that another one beats in all three are left out.
#pragma once

#include "apc/design/size_bed.h"

namespace apc::design {

struct FrontPoint {
  double margin = 0.0;                ///< limit/load − 1 kept by every load
  double length = 0.0, volume = 0.0;  ///< m, m³, before rounding to blocks
  Objective objective = Objective::length;
  Profile profile;
};

/// `start`: a finished design to begin from. Margins that no bed can keep are left out.
std::vector<FrontPoint> pareto_front(const Problem&, study::Store&, const Design& start,
                                     const std::vector<double>& margins, const OptimiserOptions&);

}  // namespace apc::design
