#include "loadtables/bspline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apc::loadtables {
namespace {

double value(const Axis& axis, const Eigen::VectorXd& coefficients, double x) {
  const auto w = weights(axis, x);
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += w.value[k] * coefficients(w.first + k);
  return sum;
}

double slope(const Axis& axis, const Eigen::VectorXd& coefficients, double x) {
  const auto w = weights(axis, x);
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += w.slope[k] * coefficients(w.first + k);
  return sum;
}

Eigen::VectorXd at_nodes(const Axis& axis, double (*function)(double)) {
  Eigen::VectorXd values(axis.nodes);
  for (int i = 0; i < axis.nodes; ++i) values(i) = function(axis.node(i));
  return values;
}

TEST(Bspline, WeightsSumToOneEverywhereAlsoBeyondTheEnds) {
  const auto grid = axis(-1.0, 3.0, 9);
  for (const double x : {-4.0, -1.0, -0.3, 0.0, 1.234, 3.0, 7.5}) {
    const auto w = weights(grid, x);
    EXPECT_NEAR(w.value[0] + w.value[1] + w.value[2] + w.value[3], 1.0, 1e-12) << x;
    EXPECT_NEAR(w.slope[0] + w.slope[1] + w.slope[2] + w.slope[3], 0.0, 1e-12) << x;
  }
}

TEST(Bspline, ReproducesStraightLinesExactlyAndContinuesThem) {
  const auto grid = axis(0.0, 2.0, 6);
  const Eigen::VectorXd c = interpolation(grid, LowerEnd::linear) * at_nodes(
                                                                        grid, +[](double x) { return 3.0 - 2.0 * x; });
  for (const double x : {-5.0, 0.0, 0.77, 2.0, 9.0}) {
    EXPECT_NEAR(value(grid, c, x), 3.0 - 2.0 * x, 1e-11) << x;
    EXPECT_NEAR(slope(grid, c, x), -2.0, 1e-11) << x;
  }
}

TEST(Bspline, PassesThroughItsNodes) {
  const auto grid = axis(0.0, 1.0, 8);
  const auto data = at_nodes(
      grid, +[](double x) { return std::sin(5.0 * x); });
  const Eigen::VectorXd c = interpolation(grid, LowerEnd::linear) * data;
  for (int i = 0; i < grid.nodes; ++i) EXPECT_NEAR(value(grid, c, grid.node(i)), data(i), 1e-12);
}

TEST(Bspline, IsLevelAtALevelEnd) {
  const auto grid = axis(0.0, 1.0, 8);
  const Eigen::VectorXd c = interpolation(grid, LowerEnd::level) * at_nodes(
                                                                       grid, +[](double x) { return std::exp(x); });
  EXPECT_NEAR(slope(grid, c, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(value(grid, c, 0.0), 1.0, 1e-12);
}

TEST(Bspline, RestsAtARestingEnd) {
  const auto grid = axis(0.0, 1.0, 12);
  const Eigen::VectorXd c = interpolation(grid, LowerEnd::rest) * at_nodes(
                                                                      grid, +[](double x) { return x * x * x; });
  EXPECT_NEAR(value(grid, c, 0.0), 0.0, 1e-14);
  EXPECT_NEAR(slope(grid, c, 0.0), 0.0, 1e-14);
  EXPECT_NEAR((slope(grid, c, 1e-6) - slope(grid, c, 0.0)) / 1e-6, 0.0, 1e-4);
  EXPECT_NEAR(value(grid, c, 0.5), 0.125, 2e-3);
}

TEST(Bspline, SlopeMatchesDifferences) {
  const auto grid = axis(0.0, 1.0, 10);
  const Eigen::VectorXd c =
      interpolation(grid, LowerEnd::linear) * at_nodes(
                                                  grid, +[](double x) { return std::sin(7.0 * x); });
  for (const double x : {-0.4, 0.05, 0.5, 0.93, 1.3})
    EXPECT_NEAR(slope(grid, c, x), (value(grid, c, x + 1e-6) - value(grid, c, x - 1e-6)) / 2e-6, 1e-7) << x;
}

TEST(Bspline, SecondDerivativeIsContinuousAcrossKnotsAndEnds) {
  const auto grid = axis(0.0, 1.0, 10);
  const Eigen::VectorXd c =
      interpolation(grid, LowerEnd::linear) * at_nodes(
                                                  grid, +[](double x) { return std::sin(7.0 * x); });
  const auto bend = [&](double x) { return (slope(grid, c, x + 1e-7) - slope(grid, c, x - 1e-7)) / 2e-7; };
  for (int i = 0; i < grid.nodes; ++i)
    EXPECT_NEAR(bend(grid.node(i) - 2e-7), bend(grid.node(i) + 2e-7), 2e-3) << "knot " << i;
  EXPECT_GT(std::abs(bend(0.2)), 10.0);  // there is something to be continuous
}

}  // namespace
}  // namespace apc::loadtables
