#include "apc/learning/bounded_step.h"

#include <algorithm>

namespace apc::learning {

Eigen::VectorXd bounded_step(Eigen::MatrixXd information, Eigen::VectorXd gradient, const Eigen::VectorXd& low,
                             const Eigen::VectorXd& high) {
  Eigen::VectorXd step = information.llt().solve(gradient);
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    const double within = std::clamp(step[i], low[i], high[i]);
    if (within == step[i]) continue;
    const double spring = 1e8 * information(i, i);
    information(i, i) += spring, gradient[i] += spring * within;
    step = information.llt().solve(gradient);
  }
  return step;
}

}  // namespace apc::learning
