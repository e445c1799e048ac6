#include "apc/design/windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace apc::design {
namespace {

constexpr double length = 40.0;

struct Curve {
  std::vector<double> place, value;
};

/// sin(x + shift) every 0.07 m, as a history has it.
Curve wave(double shift) {
  Curve curve;
  for (double at = -1.0; at <= length; at += 0.07) {
    curve.place.push_back(at);
    curve.value.push_back(std::sin(at + shift));
  }
  return curve;
}

std::vector<double> peaks(double shift, const std::vector<double>& edges) {
  const auto curve = wave(shift);
  return window_peaks(curve.place, curve.value, edges);
}

TEST(Windows, FindPeaksBetweenSamplesAndAtEdges) {
  const double half = 0.5 * std::numbers::pi;
  const auto found = peaks(0.0, {0.0, 1.0, 2.0, 3.0, 10.0});
  EXPECT_NEAR(found[0], std::sin(1.0), 1e-4);
  EXPECT_NEAR(found[1], 1.0, 1e-6);  // at π/2
  EXPECT_NEAR(found[2], std::sin(2.0), 1e-4);
  EXPECT_NEAR(found[3], 1.0, 1e-6);  // at 5π/2
  EXPECT_GT(half, 1.0);
}

TEST(Windows, AreSmoothWhereAPeakPassesAnEdge) {
  // The peak of sin(x + s) lies at π/2 − s and passes the edge 1 at s = π/2 − 1. The window behind the edge sees 1,
  // then sin(1 + s): value and slope go on.
  const double passes = 0.5 * std::numbers::pi - 1.0;
  const auto behind = [](double shift) { return peaks(shift, {1.0, 3.0})[0]; };
  EXPECT_NEAR(behind(passes - 1e-3), 1.0, 1e-5);
  EXPECT_NEAR(behind(passes + 1e-3), 1.0, 1e-5);
  for (const double after : {0.1, 0.2, 0.4}) EXPECT_NEAR(behind(passes + after), std::cos(after), 1e-4);
}

TEST(Windows, BeyondTheStopHoldNothingAndMoveWithIt) {
  const auto found = peaks(0.0, {0.0, 39.0, 45.0, 60.0, 100.0});
  const double end = wave(0.0).place.back() - 0.05;
  EXPECT_NEAR(found[2], std::sin(end) - 0.02 * (45.0 - end), 1e-4);
  EXPECT_LT(found[3], found[2]);
}

}  // namespace
}  // namespace apc::design
