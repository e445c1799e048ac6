/// The course of one run, whatever the solver: steps, events at jumps, ruts, observation, energy.
#pragma once

#include "apc/simulation/energy.h"
#include "apc/simulation/observer.h"

namespace apc::simulation {

/// Where and how the motion ended.
struct Ending {
  bool left_bed = false;
  double time = 0.0;  ///< s after entry, of the last computed state
  std::vector<double> state;
  double acceleration = 0.0;  ///< m/s² of the cg there
  std::array<double, sinks> dissipated{};
  SolverStatistics statistics;
};

/// From `state` (nose at the leading edge, t = 0) to rest or out of the bed.
Ending run_reference(const Plant&, const std::vector<double>& state, double rtol, double time_limit, Observer&);
Ending run_fast(const Plant&, const std::vector<double>& state, double rtol, double time_limit, Observer&);

/// Which rows must be told apart by an event when they enter the bed: there the equations jump.
bool enters_with_a_jump(const Plant&, int row);
/// Rows in the bed at entry: the nose, and all rows that enter smoothly.
Surroundings surroundings_at_entry(const Plant&);
/// The cg's ground speed at a state.
double cg_speed(const Plant&, const double* y);

}  // namespace apc::simulation
