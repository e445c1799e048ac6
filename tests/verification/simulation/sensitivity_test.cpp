#include "apc/simulation/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"
#include "tests/support/differences.h"

namespace apc::simulation {
namespace {

using testing::braked, testing::differenced;

Options tight() {
  Options options;
  options.rtol = 1e-8;
  return options;
}

TEST(CarriedSensitivity, OfTheStopAgreesWithDifferencesForEveryParameter) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  const std::map<std::string, double> steps{{"entry_speed", 1e-3},  {"mass", 20.0},      {"cg_behind_nose_gear", 1e-3},
                                            {"pitch_inertia", 3e3}, {"braking", 1e-4},   {"thrust", 100.0},
                                            {"headwind", 1e-2},     {"bed_depth", 1e-4}, {"bed_strength", 2e-3},
                                            {"grade", 1e-4}};
  for (const auto& parameter : parameters::all()) {
    const auto carried = sensitivity(model, braked(60), parameter, tight());
    const auto expected = differenced(model, braked(60), parameter, steps.at(parameter.name));
    const double scale = std::abs(expected.stop) + 1e-4 / steps.at(parameter.name) * 1e-2;
    EXPECT_NEAR(carried.stop_distance, expected.stop, 5e-3 * scale) << parameter.name;
  }
}

TEST(CarriedSensitivity, OfPeakLoadsAgreesWithDifferences) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  for (const auto& parameter : {parameters::mass(), parameters::bed_depth(), parameters::braking()}) {
    const double step = parameter.name == "mass" ? 50.0 : parameter.name == "braking" ? 3e-3 : 1e-4;
    const auto carried = sensitivity(model, braked(60), parameter, tight());
    const auto expected = differenced(model, braked(60), parameter, step);
    EXPECT_NEAR(carried.gears[0].peak_drag, expected.drag, 0.02 * std::abs(expected.drag)) << parameter.name;
    EXPECT_NEAR(carried.gears[1].peak_vertical, expected.vertical, 0.03 * std::abs(expected.vertical))
        << parameter.name;
  }
}

TEST(CarriedSensitivity, PassesTheEntryOfEveryRowOverAStep) {
  auto overrun = braked(50);
  overrun.braking_in_bed = 0.05;
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.3, 0.0));
  for (const auto& parameter : {parameters::entry_speed(), parameters::mass()}) {
    const double step = parameter.name == "mass" ? 20.0 : 1e-3;
    const auto expected = differenced(model, overrun, parameter, step);
    EXPECT_NEAR(sensitivity(model, overrun, parameter, tight()).stop_distance, expected.stop,
                5e-3 * std::abs(expected.stop))
        << parameter.name;
  }
}

TEST(CarriedSensitivity, FollowsTheRutsOfABogie) {
  const auto model = testing::foam_model("B747-400", testing::foam_bed(0.4572, 15.24, 600.0));
  const auto parameter = parameters::bed_depth();
  const auto expected = differenced(model, braked(50), parameter, 1e-4);
  EXPECT_NEAR(sensitivity(model, braked(50), parameter, tight()).stop_distance, expected.stop,
              0.02 * std::abs(expected.stop));
}

TEST(CarriedSensitivity, OfTheExitSpeedWhenTheBedIsTooShort) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572, 15.24, 50.0));
  const auto parameter = parameters::entry_speed();
  const auto carried = sensitivity(model, braked(70), parameter, tight());
  EXPECT_EQ(carried.outcome, Outcome::left_bed);
  const auto expected = differenced(model, braked(70), parameter, 1e-3);
  EXPECT_NEAR(carried.exit_speed, expected.exit, 2e-3 * std::abs(expected.exit));
}

}  // namespace
}  // namespace apc::simulation
