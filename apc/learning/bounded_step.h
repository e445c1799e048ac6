/// One Gauss–Newton step with bounds. SI of the unknowns.
#pragma once

#include <Eigen/Dense>

namespace apc::learning {

/// The step that solves `information` · step = `gradient`. Unknowns that it would carry below `low` or above `high`
/// (bounds of the step; infinite where there is none) are held there, by a stiff spring, one after the other, and the
/// rest is solved for again. `information` (n × n) must be positive definite.
Eigen::VectorXd bounded_step(Eigen::MatrixXd information, Eigen::VectorXd gradient, const Eigen::VectorXd& low,
                             const Eigen::VectorXd& high);

}  // namespace apc::learning
