// Steps with bounds: free inside them, on the bound outside, and then the others at their best for it.
#include "apc/learning/bounded_step.h"

#include <gtest/gtest.h>

#include <limits>

namespace apc::learning {
namespace {

const double none = std::numeric_limits<double>::infinity();

TEST(BoundedStep, IsTheNewtonStepWhereNothingBinds) {
  Eigen::Matrix2d information;
  information << 4.0, 1.0, 1.0, 3.0;
  const Eigen::Vector2d step(0.5, -0.2);
  const Eigen::VectorXd found =
      bounded_step(information, information * step, Eigen::Vector2d(-1.0, -none), Eigen::Vector2d(1.0, none));
  EXPECT_LT((found - step).norm(), 1e-12);
}

TEST(BoundedStep, HoldsAnUnknownOnItsBoundAndSolvesForTheOthers) {
  Eigen::Matrix2d information;
  information << 4.0, 1.0, 1.0, 3.0;
  const Eigen::Vector2d gradient(4.0, 0.0);  // the free step is (12, −4)/11
  const Eigen::VectorXd found =
      bounded_step(information, gradient, Eigen::Vector2d(-none, -none), Eigen::Vector2d(0.5, none));
  EXPECT_NEAR(found[0], 0.5, 1e-6);
  EXPECT_NEAR(found[1], -0.5 / 3.0, 1e-6) << "the minimum of the parabola along the bound";
}

}  // namespace
}  // namespace apc::learning
