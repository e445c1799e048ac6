/// A run in a dozen numbers per instrument: means over segments of the way, and the stop. What free runs of a model
/// can be held against — the bounce of the aircraft, which no model predicts for long, is averaged out — and small
/// enough to weigh hundreds of runs that nobody has made yet.
#pragma once

#include "apc/learning/forward.h"

namespace apc::learning {

/// One number of a run. `slowing`: (v₁² − v₂²) / (2 · length), from the speed; `mean`: of a channel over the time the
/// nose wheel spends in the segment; ruts: of the survey in the segment; `stop` and `exit`: of the whole run.
struct Feature {
  enum class Kind { slowing, mean, nose_rut, main_rut, stop, exit };
  Kind kind = Kind::stop;
  std::size_t channel = 0;  ///< in Run::channels; slowing and mean
  std::size_t segment = 0;  ///< all but stop and exit
};

/// Half the time over which the speed at an edge is read, s.
inline constexpr double edge_window = 0.3;
/// Share of the way that is divided into segments; the rest is rolled at walking speed, below the tables.
inline constexpr double rolled_share = 0.9;

/// Segments and the numbers read in them. `edge`: places of the nose wheel from the leading edge, m; the first segment
/// lies before the bed, where slope, thrust and aerodynamics act alone.
struct Segments {
  std::vector<double> edge;
  std::vector<Feature> features;
  std::size_t count() const { return edge.size() - 1; }
  double length(std::size_t i) const { return edge[i + 1] - edge[i]; }
};

/// Segments of a run that rolls `way` metres into the bed. Without a recorded speed nothing says when the nose wheel
/// was where: then only survey and stop (or exit) are left.
Segments make_segments(const Run&, double way);

/// The numbers as measured; NaN where samples are missing.
Eigen::VectorXd measured_features(const Run&, const Segments&);
/// The numbers of a simulated run.
Eigen::VectorXd simulated_features(const Run&, const Segments&, const Trace&, const aircraft::Aircraft&);

}  // namespace apc::learning
