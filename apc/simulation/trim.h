/// The state in which the aircraft rolls on the pavement without transients: heave, pitch, strokes and bogie pitch at
/// rest while drag, brakes, thrust and aerodynamics decelerate it (a quasi-steady balance, not assumed but solved).
#pragma once

#include <vector>

#include "apc/simulation/equations.h"

namespace apc::simulation {

struct Trim {
  std::vector<double> state;  ///< nose row at bed distance 0, cg at `speed`
  double acceleration = 0.0;  ///< m/s² of the cg along x
  int iterations = 0;
};

/// Newton with the exact Jacobian, steps capped at 5 cm and 0.05 rad. SolveError when no balance exists: what residual
/// is left, and what to try.
Trim trim(const Plant&, double speed);

}  // namespace apc::simulation
