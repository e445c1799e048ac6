/// The gradients a search used, against derivatives that have nothing in common with them: forward sensitivities
/// carried along the run by another integrator (simulation/sensitivity.h).
#pragma once

#include "apc/design/certificate.h"

namespace apc::design {

/// Largest difference of the gradients of the active constraints of `certificate` at `z`, relative to the largest entry
/// of each: stop distances, and drags and vertical loads of gears in the window of their largest peak. NaN when there
/// is none of these or the problem has no sensitivities.
double sensitivity_difference(Evaluator&, const Aim&, const Program&, const Eigen::VectorXd& z, const Certificate&,
                              const OptimiserOptions&);

}  // namespace apc::design
