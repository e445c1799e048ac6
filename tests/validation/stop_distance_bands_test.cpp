/// The three aircraft from 40 to 70 kt in a long 18 in bed of 50 psi foam on the shipped tables, beside two yardsticks:
///  - the regression of ACRP Report 50 over installed EMAS beds, v = 3.0057 − 6.8329 log₁₀W + 31.1482 log₁₀S (m/s, kg,
///  m;
///    adjusted R² 0.89), as a band of ±35 %: beds differ in depth and strength, and the base of the logarithm is
///    inferred;
///  - plain crush, Σ σ·w·0.85 h over all tires, which knows no side walls, no inertia, no friction and no partial
///  sinking.
/// The figures are printed; the assertions are plausibility, not calibration.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/file.h"
#include "apc/base/units.h"
#include "apc/simulation/simulate.h"

namespace apc::simulation {
namespace {

using units::ft, units::in, units::kt, units::psi;

bed::Bed long_bed() {
  auto bed = bed::load_bed(shipped("designs/beds/emas_18in_50psi.json"));
  bed.distance.back() = 600.0;
  return bed;
}

Model shipped_model(const std::string& name) {
  const auto tires = aircraft::load_tires(shipped("aircraft/data/tires.json"));
  auto plane = aircraft::load_aircraft(shipped("aircraft/data/" + name + ".json"), tires);
  std::vector<loadtables::LoadTable> tables;
  for (const auto& [tire, data] : plane.tires)
    tables.push_back(loadtables::load_table(shipped("loadtables/data/" + tire + "_foam_50psi.h5")));
  return make_model(plane, long_bed(), tables);
}

double regression_distance(double speed, double mass) {
  return std::pow(10.0, (speed - 3.0057 + 6.8329 * std::log10(mass)) / 31.1482);
}

double crush_deceleration(const aircraft::Aircraft& plane) {
  double force = 0.0;
  for (const auto& gear : plane.gears)
    force += gear.wheels() * 50 * psi * plane.tires.at(gear.tire).width * 0.85 * 18 * in;
  return force / plane.mass;
}

class StopDistanceBand : public testing::TestWithParam<const char*> {};

TEST_P(StopDistanceBand, LiesAmongInstalledBedsAndAbovePlainCrush) {
  const auto model = shipped_model(GetParam());
  const double crush = crush_deceleration(model.aircraft);
  fmt::print("{}: plain crush {:.3f} g\n", GetParam(), crush / units::g0);
  for (const double braking : {0.0, 0.25}) {
    for (const double speed : {40.0, 50.0, 60.0, 70.0}) {
      Overrun overrun;
      overrun.entry_speed = speed * kt;
      overrun.braking = braking;
      Options options;
      options.sampling = 0.0;
      const auto run = simulate(model, overrun, options);
      const double regression = regression_distance(speed * kt, model.aircraft.mass);
      const auto& nose = run.gears.front();
      fmt::print(
          "  {:.0f} kt, braking {:.2f}: {:6.1f} ft (regression {:6.1f}, ratio {:.2f}; crush {:6.1f})  mean {:.3f} g  "
          "peak {:.3f} g  nose drag {:6.0f} of {:6.0f} lbf\n",
          speed, braking, run.stop_distance / ft, regression / ft, run.stop_distance / regression,
          std::pow(speed * kt, 2) / (2.0 * crush) / ft, run.mean_deceleration / units::g0,
          run.peak_deceleration / units::g0, nose.peak_drag / units::lbf, nose.drag_limit / units::lbf);
      ASSERT_TRUE(std::isfinite(run.stop_distance));
      EXPECT_LE(run.energy.at("residual"), 1e-5);
      EXPECT_GT(run.stop_distance / regression, 1.0 / 1.7);
      EXPECT_LT(run.stop_distance / regression, 1.7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ShippedAircraft, StopDistanceBand, testing::Values("CRJ-200", "B737-800", "B747-400"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace apc::simulation
