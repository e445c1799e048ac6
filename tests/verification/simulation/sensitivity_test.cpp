#include "apc/simulation/sensitivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apc/base/require.h"
#include "tests/support/differences.h"
#include "tests/support/shipped_models.h"

namespace apc::simulation {
namespace {

using testing::braked, testing::differenced;

Overrun at_70() {
  Overrun overrun;
  overrun.entry_speed = 70 * units::kt;
  return overrun;
}

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

/// Every scalar of the result against central differences of whole runs, within `share` of the difference; where two
/// steps of the difference disagree, it knows no better than that.
void expect_all(const Model& model, const Overrun& overrun, const ScalarParameter& parameter, double step, double share,
                double sampling, std::vector<std::string> left_out = {}) {
  // Where a wheel enters the bed the pavement's work ends with a jump, which whole runs integrate without error
  // control.
  left_out.push_back("energy tires");
  const auto carried = testing::scalars(sensitivity(model, overrun, parameter, tight()));
  const auto expected = testing::all_differences(model, overrun, parameter, step, sampling);
  double worst = 0.0;
  std::string where;
  for (const auto& [name, slope] : carried) {
    if (std::find(left_out.begin(), left_out.end(), name) != left_out.end()) continue;
    const double narrow = expected.narrow.at(name), wide = expected.wide.at(name);
    if (std::isnan(narrow)) {
      EXPECT_TRUE(std::isnan(slope)) << name;
      continue;
    }
    // What rounding and the tolerance leave in a difference.
    const double noise = std::abs(narrow - wide) + 1e-8 * std::abs(expected.base.at(name)) / step;
    EXPECT_NEAR(slope, narrow, share * std::abs(narrow) + noise) << name << " by " << parameter.name;
    const double off = std::max(0.0, std::abs(slope - narrow) - noise) / std::max(std::abs(narrow), 1e-300);
    if (off > worst) worst = off, where = name;
  }
  std::printf("sensitivities of %s by %s: %zu scalars, worst %.4f %% (%s)\n", model.aircraft.name.c_str(),
              parameter.name.c_str(), carried.size() - left_out.size(), 100.0 * worst, where.c_str());
}

TEST(CarriedSensitivity, OfEveryScalarAgreesWithDifferencesForEveryParameter) {
  const std::map<std::string, double> steps{{"entry_speed", 5e-3},  {"mass", 50.0},      {"cg_behind_nose_gear", 2e-3},
                                            {"pitch_inertia", 1e4}, {"braking", 1e-3},   {"thrust", 200.0},
                                            {"headwind", 2e-2},     {"bed_depth", 2e-4}, {"bed_strength", 2e-3},
                                            {"grade", 2e-4}};
  for (const auto* name : {"CRJ-200", "B737-800"}) {
    const auto model = testing::foam_model(name, testing::foam_bed(0.3));
    for (const auto& parameter : parameters::all())
      expect_all(model, braked(60), parameter, steps.at(parameter.name), parameter.name == "bed_strength" ? 0.05 : 0.01,
                 1e-4);  // the altered balance is solved to 1e-9 only
  }
}

TEST(CarriedSensitivity, OfEveryScalarWhereBogiesBounceInTheirRuts) {
  // Peaks at the ramp's corner, at the corners of ruts, and where ruts begin to yield. What is left out swings at rest.
  const std::vector<std::string> at_rest{"energy kinetic_left", "energy potential", "energy oleo_gas"};
  for (const auto* bed : {"emas_18in_50psi", "emas_18in_50psi_raised"})
    expect_all(testing::shipped_model("B747-400", bed), at_70(), parameters::entry_speed(), 2e-2, 0.02, 1e-4, at_rest);
}

TEST(CarriedSensitivity, OfAPeakAtTheCornerOfARamp) {
  // A steep ramp up to a short bed: loads, ruts and penetrations rise up to the corner and fall behind it.
  auto bed = testing::foam_bed(0.3, 4.0, 40.0);
  bed.flush = bed::Flush::base;
  const auto model = testing::foam_model("B737-800", bed);
  for (const auto& [parameter, step] : {std::pair{parameters::entry_speed(), 0.2}, {parameters::mass(), 500.0}})
    expect_all(model, braked(60), parameter, step, 0.02, 1e-5);
}

TEST(CarriedSensitivity, OfEnergyAddsUp) {
  // What a parameter brings in at the entry must go somewhere: the slopes of all stores and sinks balance, the jump of
  // work from pavement to bed at every wheel's entry included.
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.3));
  for (const auto& parameter : parameters::all()) {
    auto by = sensitivity(model, braked(60), parameter, tight()).energy;
    double open = by.at("kinetic"), largest = 0.0;
    for (const auto& [name, slope] : by) {
      largest = std::max(largest, std::abs(slope));
      if (name != "kinetic") open -= slope;
    }
    std::printf("energy slopes by %s: open by %.1e of the largest\n", parameter.name.c_str(), std::abs(open) / largest);
    EXPECT_LT(std::abs(open), 1e-3 * largest) << parameter.name;
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
              1e-3 * std::abs(expected.stop));
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
