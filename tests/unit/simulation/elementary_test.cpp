#include "apc/simulation/elementary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apc::simulation::elementary {
namespace {

constexpr double ulps = 2.3e-16;

TEST(Elementary, AgreesWithTheLibraryWithinThreeRoundings) {
  for (int i = -2000; i <= 2000; ++i) {
    const double x = i / 2000.0;
    const auto at = sine_cosine(1.2 * x);  // beyond π/4 too
    EXPECT_NEAR(at.sine, std::sin(1.2 * x), 2 * ulps);
    EXPECT_NEAR(at.cosine, std::cos(1.2 * x), 2 * ulps);
    EXPECT_NEAR(exponential(50.0 * x) / std::exp(50.0 * x), 1.0, 3 * ulps);
    EXPECT_NEAR(hyperbolic_tangent(25.0 * x), std::tanh(25.0 * x), 3 * ulps);
    EXPECT_NEAR(hyperbolic_tangent(x), std::tanh(x), 3 * ulps * std::abs(x));
  }
  for (int i = 1; i < 2000; ++i) {
    const double x = i / 1000.0;
    EXPECT_NEAR(logarithm(x), std::log(x), 3 * ulps * (1.0 + std::abs(std::log(x))));
    EXPECT_NEAR(power(x, -1.1) / std::pow(x, -1.1), 1.0, 10 * ulps * (1.0 + std::abs(std::log(x))));
  }
}

TEST(Elementary, PowerHasNoValueWhereTheGasHasNoVolume) {
  EXPECT_TRUE(std::isnan(power(0.0, -1.1)));
  EXPECT_TRUE(std::isnan(power(-0.5, -1.1)));
}

}  // namespace
}  // namespace apc::simulation::elementary
