#include "apc/simulation/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

struct Difference {
  double stop, exit, drag, vertical;
};

/// Central difference through whole runs at tight tolerance.
Difference differenced(const Model& model, const Overrun& overrun, const ScalarParameter& parameter, double step) {
  Options options;
  options.rtol = 1e-9;
  options.sampling = 0.0;
  const auto run = [&](double amount) {
    auto changed = model;
    auto other = overrun;
    parameter.shift(changed, other, amount);
    return simulate(changed, other, options);
  };
  const auto up = run(step), down = run(-step);
  return {(up.stop_distance - down.stop_distance) / (2 * step), (up.exit_speed - down.exit_speed) / (2 * step),
          (up.gears[0].peak_drag - down.gears[0].peak_drag) / (2 * step),
          (up.gears[1].peak_vertical - down.gears[1].peak_vertical) / (2 * step)};
}

Overrun braked(double knots) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  overrun.braking = 0.2;
  return overrun;
}

TEST(Sensitivity, OfTheStopAgreesWithDifferences) {
  const auto model = testing::foam_model("CRJ-200", testing::foam_bed(0.3));
  const auto parameter = parameters::entry_speed();
  const auto expected = differenced(model, braked(40), parameter, 1e-3);
  EXPECT_NEAR(sensitivity(model, braked(40), parameter).stop_distance, expected.stop, 5e-3 * expected.stop);
}

TEST(Sensitivity, RefusesAParameterThatMovesNothing) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  EXPECT_THROW(sensitivity(model, braked(60), {"nothing", "1", 0.0, 1.0, {}}), InputError);
}

}  // namespace
}  // namespace apc::simulation
