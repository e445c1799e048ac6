#include "sph_backend/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"
#include "sph_backend/kernel.h"
#include "sph_backend/wheel_path.h"

namespace apc::sph {
namespace {

TEST(Convergence, FindsOrderAndLimitOfAPowerLaw) {
  const std::vector<double> h{4.0, 3.0, 2.0, 1.0};
  std::vector<double> f;
  for (const double x : h) f.push_back(10.0 + 0.3 * std::pow(x, 1.7));
  const PowerFit fit = fit_power(h, f);
  EXPECT_TRUE(fit.valid);
  EXPECT_NEAR(fit.order, 1.7, 0.01);
  EXPECT_NEAR(fit.extrapolated, 10.0, 0.01);
  EXPECT_GT(fit.r2, 0.9999);
}

TEST(Convergence, GridIndexOfThreeUnevenSizes) {
  const std::vector<double> h{3.0, 1.0, 2.0};
  std::vector<double> f;
  for (const double x : h) f.push_back(5.0 - 0.2 * x * x);
  const GridConvergence g = grid_convergence(h, f);
  EXPECT_TRUE(g.valid);
  EXPECT_NEAR(g.order, 2.0, 1e-3);
  EXPECT_NEAR(g.extrapolated, 5.0, 1e-3);
  EXPECT_NEAR(g.index, 1.25 * 0.2 / 4.8, 1e-3);
}

TEST(Convergence, OscillatingValuesAreNotCalledConverged) {
  EXPECT_FALSE(grid_convergence({4.0, 2.0, 1.0}, {1.0, 2.0, 1.5}).valid);
  EXPECT_THROW(fit_power({1.0, 2.0}, {1.0, 2.0}), InputError);
}

TEST(Kernel, IntegratesToOneAndHasItsSlope) {
  const double h = 0.7;
  double volume = 0.0;
  const int pieces = 20000;
  for (int k = 0; k < pieces; ++k) {
    const double r = (k + 0.5) * 2.0 * h / pieces;
    volume += 4.0 * std::numbers::pi * r * r * kernel(r, 1.0 / h) * 2.0 * h / pieces;
  }
  EXPECT_NEAR(volume, 1.0, 1e-6);
  for (const double r : {0.1, 0.5, 1.0, 1.3})
    EXPECT_NEAR((kernel(r + 1e-6, 1.0 / h) - kernel(r - 1e-6, 1.0 / h)) / 2e-6, r * kernel_slope(r, 1.0 / h), 1e-6);
  EXPECT_EQ(kernel(2.0 * h, 1.0 / h), 0.0);
}

TEST(WheelPath, VelocityIsTheSlopeOfThePosition) {
  WheelPath sinking{1.2, 0.8, 0.1, 0.05, 30.0, 20.0, 0.03, 2.0};
  for (const double t : {0.02, 0.08, 0.11, 0.14, 0.2}) {
    const double d = 1e-6;
    EXPECT_NEAR((sinking.at(t + d).z - sinking.at(t - d).z) / (2 * d), sinking.at(t).vz, 1e-4);
  }
  const double there =
      0.15 + (2.0 - sinking.at(0.15).x) / 30.0;  // two metres on it is where it would be on a level way
  EXPECT_NEAR(sinking.at(there).z, 0.8, 1e-12);
  const WheelPath path{1.2, 0.8, 0.1, 0.05, 30.0, 20.0};
  for (const double t : {0.02, 0.08, 0.11, 0.14, 0.2}) {
    const double d = 1e-6;
    EXPECT_NEAR((path.at(t + d).x - path.at(t - d).x) / (2 * d), path.at(t).vx, 1e-4);
    EXPECT_NEAR((path.at(t + d).z - path.at(t - d).z) / (2 * d), path.at(t).vz, 1e-4);
  }
  EXPECT_NEAR(path.at(0.15).x, 0.75, 1e-12);
  EXPECT_NEAR(path.spin(0.15), 20.0, 1e-12);
}

}  // namespace
}  // namespace apc::sph
