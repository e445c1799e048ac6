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

WheelPath pressed_path() {
  WheelPath path;
  path.start_height = 1.2, path.end_height = 0.8, path.press_time = 0.1, path.accelerate_time = 0.05;
  path.speed = 30.0, path.first_spin = 20.0;
  return path;
}

TEST(WheelPath, VelocityIsTheSlopeOfThePosition) {
  WheelPath sinking = pressed_path(), rolled_in = pressed_path();
  sinking.fall = 0.03, sinking.fall_from = 2.0;
  rolled_in.entry = 1.5;
  for (const WheelPath& path : {pressed_path(), sinking, rolled_in})
    for (const double t : {0.02, 0.04, 0.08, 0.11, 0.14, 0.2}) {
      const double d = 1e-6;
      EXPECT_NEAR((path.at(t + d).x - path.at(t - d).x) / (2 * d), path.at(t).vx, 1e-4);
      EXPECT_NEAR((path.at(t + d).z - path.at(t - d).z) / (2 * d), path.at(t).vz, 1e-4);
    }
  const double there =
      0.15 + (2.0 - sinking.at(0.15).x) / 30.0;  // two metres on it is where it would be on a level way
  EXPECT_NEAR(sinking.at(there).z, 0.8, 1e-12);
  EXPECT_NEAR(pressed_path().at(0.15).x, 0.75, 1e-12);
  EXPECT_NEAR(pressed_path().spin(0.15), 20.0, 1e-12);
  EXPECT_NEAR(rolled_in.at(0.05).z, 0.8, 1e-12);  // one and a half metres on
  EXPECT_EQ(rolled_in.at(0.0).vx, 30.0);
}

TEST(WheelPath, OnlyAFreeWheelIsLetGo) {
  WheelPath path = pressed_path();
  EXPECT_TRUE(path.spin_is_prescribed(0.14));
  EXPECT_FALSE(path.spin_is_prescribed(0.16));
  path.mode = WheelSpin::locked;
  EXPECT_TRUE(path.spin_is_prescribed(9.0));
}

}  // namespace
}  // namespace apc::sph
