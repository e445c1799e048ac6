/// What can end a run, or break an aircraft within it, besides coming to rest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"
#include "apc/simulation/prepared.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Overrun at(double knots) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  return overrun;
}

Model jet(const bed::Bed& bed = testing::foam_bed(0.4572)) { return testing::foam_model("B737-800", bed); }

TEST(Outcomes, AnAircraftThatFallsOverEndsItsRunThere) {
  // A main gear under the nose, most of the weight on it, and all of it high up: foam turns it about that gear.
  auto plane = testing::shipped_aircraft("B737-800");
  const auto main = plane.gears[1];
  plane.gears[0] = main;
  plane.gears[0].name = "nose", plane.gears[0].behind_nose_gear = 0.0, plane.gears[0].braked = false;
  plane.cg_behind_nose_gear = 3.0, plane.cg_height = 8.0;
  const auto model = make_model(plane, testing::foam_bed(0.6), {testing::foam_table(plane.tires.at(main.tire))});
  for (const auto method : {Method::reference, Method::fast}) {
    Options options;
    options.method = method;
    auto overrun = at(70);
    overrun.braking = 0.5;
    const auto result = simulate(model, overrun, options);
    EXPECT_EQ(result.outcome, Outcome::pitched_over) << result.message;
    EXPECT_THAT(result.message, HasSubstr("pitched over: nose down by 20 deg"));
    EXPECT_TRUE(std::isnan(result.stop_distance));
    EXPECT_GT(result.exit_speed, 0.0);
    EXPECT_NEAR(result.lowest_pitch, -overturning_pitch, 0.02);
    EXPECT_NEAR(result.history.pitch.back(), -overturning_pitch, 1e-6);
  }
}

TEST(Outcomes, AGearFailsByTheLoadThatPassesItsUltimateFirst) {
  auto model = jet();
  const auto whole = simulate(model, at(60));
  EXPECT_EQ(whole.outcome, Outcome::stopped);
  EXPECT_FALSE(whole.gear_failed());
  auto& main = model.aircraft.gears[1].limits;
  main.vertical_limit = whole.gears[1].peak_vertical / 1.6;  // passed late, at 94 % of the peak
  const auto by_vertical = simulate(model, at(60));
  EXPECT_EQ(by_vertical.outcome, Outcome::gear_limit);
  EXPECT_EQ(by_vertical.gears[1].failed_by, "vertical");
  EXPECT_LE(by_vertical.gears[1].failed_at, whole.gears[1].peak_vertical_distance + 0.1);
  EXPECT_THAT(by_vertical.message, HasSubstr("main gear: vertical load passed its ultimate load"));
  EXPECT_THAT(by_vertical.message, HasSubstr("if the gear had held"));
  EXPECT_EQ(by_vertical.stop_distance, whole.stop_distance);

  auto& nose = model.aircraft.gears[0].limits;  // the nose gear now fails at the first foam, the main gear still later
  nose.drag_limit = nose.drag_ultimate = 0.05 * whole.gears[0].peak_drag;
  const auto both = simulate(model, at(60));
  EXPECT_EQ(both.gears[0].failed_by, "drag");
  EXPECT_LT(both.gears[0].failed_time, both.gears[1].failed_time);
  EXPECT_LT(both.message.find("nose gear: drag"), both.message.find("main gear: vertical load"));
}

TEST(Outcomes, LiftOffIsCountedPerGearAndPlaced) {
  const auto level = simulate(jet(), at(60));
  EXPECT_EQ(level.airborne, 0.0);
  EXPECT_TRUE(std::isnan(level.lifted_at));
  auto jump = testing::foam_bed(0.9, 3.0);  // a raised bed behind a short ramp
  jump.flush = bed::Flush::base;
  auto overrun = at(70);
  overrun.braking = 0.25;
  const auto result = simulate(testing::foam_model("CRJ-200", jump), overrun);
  const auto& history = result.history;
  double all = 0.0;
  std::array<double, 2> alone{};
  std::array<double, 2> first{-1.0, -1.0};
  for (std::size_t i = 1; i < history.time.size(); ++i) {
    if (history.time[i - 1] < 0.0) continue;
    const double dt = history.time[i] - history.time[i - 1];
    std::array<bool, 2> up{};
    for (std::size_t g = 0; g < 2; ++g) {
      up[g] = history.gears[g].penetration[i] == 0.0;
      if (up[g]) alone[g] += dt;
      if (up[g] && first[g] < 0.0) first[g] = history.distance[i];
    }
    if (up[0] && up[1]) all += dt;
  }
  for (std::size_t g = 0; g < 2; ++g) {
    ASSERT_GT(alone[g], 0.1);
    EXPECT_NEAR(result.gears[g].airborne, alone[g], 0.03);
    EXPECT_NEAR(result.gears[g].lifted_at, first[g], 0.2);
  }
  ASSERT_GT(all, 0.1);
  EXPECT_NEAR(result.airborne, all, 0.03);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("the nose wheels were off the ground")));
  EXPECT_THAT(result.warnings, Contains(HasSubstr("all wheels were off the ground")));
}

TEST(Outcomes, ATireBeyondItsBottomingLoadIsNamed) {
  auto model = jet();
  EXPECT_FALSE(simulate(model, at(60)).gears[0].tire_bottomed);
  const auto& tire = model.aircraft.gears[0].tire;
  model.aircraft.tires.at(tire).bottoming_load = 20e3;
  const auto result = simulate(model, at(60));
  EXPECT_TRUE(result.gears[0].tire_bottomed);
  EXPECT_FALSE(result.gears[1].tire_bottomed);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("a nose tire (" + tire + ") carried")));
}

TEST(Outcomes, SpeedsAboveTheTablesAreToldFromSpeedsBelowThem) {
  // The tables of these models hold for 5 to 40 m/s.
  const auto fast = simulate(jet(), at(90)), slow = simulate(jet(), at(70));
  for (const auto& each : fast.coverage) {
    EXPECT_GT(each.speed_above, 0.02);
    EXPECT_GT(each.speed_below, 0.0);
    EXPECT_NEAR(each.inside, 1.0 - each.speed_above - each.speed_below - each.penetration_outside, 1e-9);
  }
  EXPECT_THAT(fast.warnings, Contains(HasSubstr("the nose tire's speed lay above its load table")));
  for (const auto& each : slow.coverage) EXPECT_EQ(each.speed_above, 0.0);
  EXPECT_THAT(slow.warnings, Not(Contains(HasSubstr("speed"))));
}

TEST(Outcomes, CoverageWatchesEveryRowOfABogie) {
  auto bed = testing::foam_bed(0.4572, 15.24, 400.0);
  bed.distance = {0.0, 15.24, 20.0, 20.5, 24.0, 24.5, 400.0};
  bed.depth = {0.0, 0.4572, 0.4572, 1.2, 1.2, 0.4572, 0.4572};  // a pit deeper than the tables' 1 m
  const auto result = simulate(testing::foam_model("B747-400", bed), at(60));
  const auto& history = result.history;
  for (std::size_t g = 1; g < result.gears.size(); ++g) {
    double leading = 0.0, in_bed = 0.0;
    for (std::size_t i = 1; i < history.time.size(); ++i) {
      const double dt = history.time[i] - history.time[i - 1], depth = history.gears[g].bed_depth[i];
      if (depth > 0.0) in_bed += dt;
      if (depth > 1.0) leading += dt;
    }
    ASSERT_GT(leading, 0.0);
    // The trailing axle leaves the pit 1.47 m after the leading one, which was in it for about 3.8 m.
    EXPECT_NEAR(result.coverage[g].depth_outside / (leading / in_bed), 1.0 + 1.47 / 3.8, 0.1);
  }
}

TEST(Outcomes, AnOpenEnergyAccountIsAWarningThenNoResult) {
  const auto model = jet();
  const auto overrun = at(60);
  Options options;
  options.sampling = 0.0;
  Prepared prepared(model, overrun, options);
  auto end = run_reference(prepared.plant, prepared.start.state, 1e-6, 600.0, prepared.observer);
  const double kinetic = finish(model, overrun, options, prepared, end).energy.at("kinetic");
  EXPECT_THAT(finish(model, overrun, options, prepared, end).warnings, Not(Contains(HasSubstr("energy"))));
  end.dissipated[0] += 1e-3 * kinetic;
  EXPECT_THAT(finish(model, overrun, options, prepared, end).warnings, Contains(HasSubstr("energy account")));
  end.dissipated[0] += 2e-2 * kinetic;
  try {
    finish(model, overrun, options, prepared, end);
    FAIL() << "taken for a result";
  } catch (const SolveError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--rtol"));
    EXPECT_GT(error.time, 1.0);
  }
}

TEST(Outcomes, ToleranceAndSpeedThatMeanNothingAreRefused) {
  Options options;
  options.rtol = 2e-4;
  EXPECT_THROW(simulate(jet(), at(60), options), InputError);
  EXPECT_THROW(simulate(jet(), at(0.05)), InputError);  // 0.026 m/s
}

TEST(Outcomes, AnAircraftThatWouldFlyIsToldSo) {
  auto model = jet();
  model.aircraft.aero.CL = 3.0;
  try {
    simulate(model, at(120));
    FAIL() << "trimmed";
  } catch (const SolveError& error) {
    for (const char* part : {"t = 0 s", "the lift of", "it would fly", "Lower the speed", "speed 61.7", "strokes nose"})
      EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

}  // namespace
}  // namespace apc::simulation
