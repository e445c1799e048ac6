#include "apc/simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/simulation/observer.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

using ::testing::HasSubstr;

Overrun at(double knots) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  return overrun;
}

const Model& jet_in_foam() {
  static const Model model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  return model;
}

TEST(Peak, IsTheVertexOfTheParabolaThroughItsNeighbours) {
  Peak peak;
  for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0, 1.3}) peak.see(t, 5.0 - std::pow(t - 0.937, 2), 2.0 * t);
  EXPECT_NEAR(peak.value, 5.0, 1e-12);
  EXPECT_NEAR(peak.distance, 2.0 * 0.937, 1e-12);
}

TEST(Overrun, StopsInTheBed) {
  const auto result = simulate(jet_in_foam(), at(70));
  EXPECT_EQ(result.outcome, Outcome::stopped) << result.message;
  EXPECT_GT(result.stop_distance, 60.0);
  EXPECT_LT(result.stop_distance, 600.0);
  EXPECT_NEAR(result.runway_distance - result.stop_distance, 15.24, 1e-9);
  EXPECT_NEAR(result.mean_deceleration * 2.0 * result.stop_distance, std::pow(70 * units::kt, 2), 1e-6);
  EXPECT_GE(result.peak_deceleration, result.peak_deceleration_100ms);
  EXPECT_EQ(result.gears.size(), 2u);
  EXPECT_EQ(result.gears[0].drag_rule, "14 CFR 25.509 from the ramp weight");
  EXPECT_LT(result.energy.at("residual"), 1e-5);
}

TEST(Overrun, EnergyClosesToOneInAMillionAtTightTolerance) {
  Options options;
  options.rtol = 1e-8;
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    auto overrun = at(60);
    overrun.braking = 0.25;
    const auto result = simulate(testing::foam_model(name, testing::foam_bed(0.4572)), overrun, options);
    EXPECT_LT(result.energy.at("residual"), 1e-6) << name;
  }
}

TEST(Overrun, LeavesABedThatIsTooShort) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572, 15.24, 40.0));
  const auto result = simulate(model, at(70));
  EXPECT_EQ(result.outcome, Outcome::left_bed);
  EXPECT_TRUE(std::isnan(result.stop_distance));
  EXPECT_GT(result.exit_speed, 10.0);
  EXPECT_LT(result.exit_speed, 70 * units::kt);
  EXPECT_NEAR(result.history.distance.back(), 40.0, 1e-6);
}

TEST(Overrun, TakesTheGearAsFailedBeyondItsUltimateLoadButKeepsRolling) {
  auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  model.aircraft.gears[0].limits.drag_limit = 5e3;
  model.aircraft.gears[0].limits.drag_ultimate = 7.5e3;
  const auto result = simulate(model, at(60));
  EXPECT_EQ(result.outcome, Outcome::gear_limit);
  EXPECT_THAT(result.message, HasSubstr("nose gear: drag passed its ultimate load"));
  EXPECT_FALSE(std::isnan(result.stop_distance));
  EXPECT_LT(result.gears[0].ultimate_margin, 0.0);
}

TEST(Overrun, MeetsItsEntrySpeedAndRollsInWithoutTransients) {
  auto overrun = at(60);
  overrun.braking = 0.25;
  const auto history = simulate(jet_in_foam(), overrun).history;
  ASSERT_LE(history.time.front(), -1.0 + 1e-9);
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    if (history.time[i] < 0.0) {
      EXPECT_LT(std::abs(history.pitch_rate[i]), 1e-3);
      EXPECT_LT(history.distance[i], 0.0);
    }
    if (std::abs(history.time[i]) < 1e-9) {
      EXPECT_NEAR(history.speed[i], 60 * units::kt, 1e-12);
      EXPECT_NEAR(history.distance[i], 0.0, 1e-12);
    }
  }
}

TEST(Overrun, HistoriesAreColumnsOfEqualLengthAtTheAskedInterval) {
  Options options;
  options.sampling = 0.01;
  const auto history = simulate(jet_in_foam(), at(50), options).history;
  const auto rows = history.time.size();
  EXPECT_GT(rows, 200u);
  for (const auto* column :
       {&history.distance, &history.speed, &history.deceleration, &history.acceleration_x, &history.acceleration_z,
        &history.pitch, &history.pitch_rate, &history.heave, &history.dissipated, &history.gears[1].drag,
        &history.gears[0].rut, &history.gears[1].spin})
    EXPECT_EQ(column->size(), rows);
  for (std::size_t i = 1; i + 1 < rows; ++i) EXPECT_NEAR(history.time[i] - history.time[i - 1], 0.01, 1e-9);
}

TEST(Overrun, AccelerometersReadZeroInTheStaticAttitude) {
  // On level pavement at constant speed the specific force is g along the static vertical.
  auto model = testing::foam_model("B737-800", testing::pavement());
  model.aircraft.aero = {};
  auto overrun = at(60);
  overrun.thrust = 0.0;
  Options options;
  options.time_limit = 1e9;
  const auto history = simulate(model, overrun, options).history;
  const double rolling = 0.014 * units::g0;
  EXPECT_NEAR(history.acceleration_x.front(), -rolling, 0.1 * rolling);
  EXPECT_NEAR(history.acceleration_z.front(), 0.0, 1e-3);
}

TEST(Overrun, WithoutSamplingThereIsNoHistory) {
  Options options;
  options.sampling = 0.0;
  const auto result = simulate(jet_in_foam(), at(50), options);
  EXPECT_TRUE(result.history.time.empty());
  EXPECT_GT(result.gears[0].peak_drag, 0.0);
}

TEST(Overrun, BothMethodsAgreeWithinAMillimetre) {
  Options fast, reference;
  fast.method = Method::fast;
  fast.sampling = reference.sampling = 0.0;
  reference.rtol = 1e-9;
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"})
    for (const double knots : {40.0, 70.0}) {
      const auto model = testing::foam_model(name, testing::foam_bed(0.4572, 15.24, 600.0));
      const auto quick = simulate(model, at(knots), fast), exact = simulate(model, at(knots), reference);
      EXPECT_NEAR(quick.stop_distance, exact.stop_distance, 1e-3) << name << " " << knots;
      for (std::size_t g = 0; g < quick.gears.size(); ++g)
        EXPECT_NEAR(quick.gears[g].peak_drag, exact.gears[g].peak_drag, 5e-3 * exact.gears[g].peak_drag) << name;
    }
}

TEST(Overrun, AStepFrontIsAnEventForEveryRow) {
  Options fast, reference;
  fast.method = Method::fast;
  reference.rtol = 1e-9;
  fast.sampling = reference.sampling = 0.0;
  const auto model = testing::foam_model("B747-400", testing::foam_bed(0.25, 0.0, 600.0));
  auto overrun = at(60);
  overrun.braking = 0.25;
  overrun.braking_in_bed = 0.05;
  EXPECT_NEAR(simulate(model, overrun, fast).stop_distance, simulate(model, overrun, reference).stop_distance, 1e-3);
}

TEST(Overrun, BrakesAsFrictionAndAsTorqueAgreeInSteadyUse) {
  auto overrun = at(60);
  overrun.braking = 0.15;
  Options options;
  options.sampling = 0.0;
  const double friction = simulate(jet_in_foam(), overrun, options).stop_distance;
  overrun.brake_mode = BrakeMode::torque;
  EXPECT_NEAR(simulate(jet_in_foam(), overrun, options).stop_distance, friction, 0.01 * friction);
}

TEST(Overrun, FrictionInsideTheBedIsAnInputOfItsOwn) {
  auto overrun = at(60);
  overrun.braking = 0.25;
  Options options;
  options.sampling = 0.0;
  const double everywhere = simulate(jet_in_foam(), overrun, options).stop_distance;
  overrun.braking_in_bed = 0.0;
  EXPECT_GT(simulate(jet_in_foam(), overrun, options).stop_distance, everywhere + 5.0);
}

TEST(Overrun, ReverseThrustUphillAndHeadwindShortenTheStop) {
  Options options;
  options.sampling = 0.0;
  const double plain = simulate(jet_in_foam(), at(60), options).stop_distance;
  auto changed = at(60);
  changed.thrust = -40e3;
  EXPECT_LT(simulate(jet_in_foam(), changed, options).stop_distance, plain - 1.0);
  changed = at(60);
  changed.headwind = 10.0;
  EXPECT_LT(simulate(jet_in_foam(), changed, options).stop_distance, plain);
  auto bed = testing::foam_bed(0.4572);
  bed.grade = 0.02;
  EXPECT_LT(simulate(testing::foam_model("B737-800", bed), at(60), options).stop_distance, plain - 1.0);
}

TEST(Overrun, TrailingWheelsInTheRutTakeLessDrag) {
  Options options;
  options.sampling = 0.0;
  const auto model = testing::foam_model("B747-400", testing::foam_bed(0.4572, 15.24, 600.0));
  auto abreast = model;
  for (auto& gear : abreast.aircraft.gears) {
    if (gear.is_nose()) continue;
    gear.wheels_per_axle = 4;
    gear.axles = 1;
  }
  const double following = simulate(model, at(60), options).stop_distance;
  EXPECT_GT(following, 1.3 * simulate(abreast, at(60), options).stop_distance);
  auto sticky = at(60);
  sticky.rut_following.rolling_resistance = 0.05;
  EXPECT_LT(simulate(model, sticky, options).stop_distance, following - 5.0);
}

TEST(Overrun, SameBitsOnAnyNumberOfThreads) {
  for (const auto method : {Method::fast, Method::reference}) {
    const auto run = [&](unsigned threads) {
      std::vector<double> stops(8);
      parallel_for(stops.size(), threads, [&](std::size_t i) {
        Options options;
        options.method = method;
        options.sampling = 0.0;
        options.rtol = 1e-5;
        stops[i] = simulate(jet_in_foam(), at(40.0 + 4.0 * static_cast<double>(i)), options).stop_distance;
      });
      return stops;
    };
    const auto one = run(1), four = run(4);
    EXPECT_EQ(std::memcmp(one.data(), four.data(), one.size() * sizeof(double)), 0);
  }
}

TEST(Overrun, EndlessRollingIsASolverErrorWithAdvice) {
  auto overrun = at(60);
  overrun.thrust = 60e3;
  Options options;
  options.time_limit = 5.0;
  options.sampling = 0.0;
  try {
    simulate(testing::foam_model("B737-800", testing::pavement()), overrun, options);
    ADD_FAILURE() << "stopped";
  } catch (const SolveError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did not stop: still rolling at"));
    EXPECT_THAT(error.what(), HasSubstr("with a deceleration of"));
    EXPECT_THAT(error.what(), HasSubstr("Is thrust (or a falling grade) as large as the drag?"));
    EXPECT_GT(error.time, 5.0);
  }
}

TEST(Overrun, StopsWhereTheDragExceedsTheThrustHoweverLittle) {
  // Constant drag on level ground: v²/2 = (drag − thrust)/m × distance. Below 0.05 m/s the model's drag fades, so that
  // a thrust of more than three quarters of it would hold a creeping balance that the unfaded drag does not know.
  auto plane = testing::shipped_aircraft("B737-800");
  plane.aero = {};
  const double weight = plane.mass * units::g0;
  const auto model = testing::exact_model(plane, [&](double, double penetration) {
    return TireLoad{0.1 * 4e6 * penetration, 4e6 * penetration, 0.0, 1.0};  // drag = a tenth of the vertical load
  });
  for (const auto method : {Method::reference, Method::fast})
    for (const double share : {0.5, 0.8, 0.95, 0.98}) {
      auto overrun = at(20);
      overrun.wheel_spin = WheelSpin::free;
      overrun.thrust = share * 0.1 * weight;
      Options options;
      options.method = method;
      options.sampling = 0.0;
      const auto result = simulate(model, overrun, options);
      const double speed = overrun.entry_speed, exact = 0.5 * speed * speed / ((1.0 - share) * 0.1 * units::g0);
      EXPECT_EQ(result.outcome, Outcome::stopped);
      // Pitch turns the thrust a little: a share of it, which weighs the more the less deceleration is left.
      EXPECT_NEAR(result.stop_distance, exact, 4e-4 / (1.0 - share) * exact) << share;
    }
}

TEST(Overrun, LeavesTheBedWhereTheThrustExceedsTheDrag) {
  auto overrun = at(40);
  overrun.thrust = 600e3;
  Options options;
  options.sampling = 0.0;
  for (const auto method : {Method::reference, Method::fast}) {
    options.method = method;
    const auto result = simulate(testing::foam_model("B737-800", testing::foam_bed(0.3)), overrun, options);
    EXPECT_EQ(result.outcome, Outcome::left_bed);
    EXPECT_GT(result.exit_speed, 0.0);
  }
}

TEST(Overrun, RefusesImpossibleConditions) {
  EXPECT_THROW(simulate(jet_in_foam(), at(0)), InputError);
  auto tail_heavy = at(60);
  tail_heavy.cg_behind_nose_gear = 15.8;
  EXPECT_THROW(simulate(jet_in_foam(), tail_heavy), InputError);
  auto weightless = at(60);
  weightless.mass = 1000.0;
  EXPECT_THROW(simulate(jet_in_foam(), weightless), InputError);
}

TEST(Model, NamesTheTireThatHasNoTable) {
  try {
    make_model(testing::shipped_aircraft("CRJ-200"), testing::pavement(), {});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no load table for the tire R18x4.4 of the nose gear of the CRJ-200"));
  }
}

TEST(Overrun, ReportsWhereItLeftTheTable) {
  Options options;
  options.sampling = 0.0;
  const auto result = simulate(jet_in_foam(), at(70), options);
  for (const auto& coverage : result.coverage) {
    EXPECT_GT(coverage.speed_below, 0.0) << "every stop passes below 5 m/s";
    EXPECT_LE(coverage.inside, 1.0 - coverage.speed_below + 1e-12);
  }
}

}  // namespace
}  // namespace apc::simulation
