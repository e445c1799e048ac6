/// Joints between blocks come every metre or so, but where a run is along the bed is known to a few decimetres only:
/// its clock is late, its speed reads high. Before joints can be weighed, their place is searched run by run.
///
/// Joints of a pitch p are harmonics cos(2πmx/p), sin(2πmx/p) of the strength; the response to each is simulated once.
/// A way that is shifted by δ and stretched by ε turns the harmonics into one another, row by row, by the phase
/// 2πm(o − δ − εx)/p, so every offset, shift, stretch and width is a sum of columns at hand. Amplitudes are small:
/// linear.
#pragma once

#include <array>

#include "apc/learning/background.h"

namespace apc::learning {

/// Joints of one pitch, as they fit best.
struct SeamFit {
  effects::Applied applied;                   ///< amplitude neutral; offset and width the best ones
  std::vector<std::array<double, 2>> places;  ///< per training run: shift (m), stretch
  std::vector<Eigen::VectorXd> columns;       ///< per training run, whitened, for depth 1
  double depth = 0.0;                         ///< likeliest
  double log_weight = 0.0;                    ///< cost of the search over offset, width and places, ln
};

/// One fit per pitch, the length of a block and its double, where the joints are deeper than 0.05. `seams`: the law
/// with parameters depth, pitch, width, offset. Simulates 9 columns per pitch and run.
std::vector<SeamFit> search_seams(const Background&, const effects::Effect& seams);

}  // namespace apc::learning
