/// Runs in the lanes of vectors are the runs of the scalar code, to the last bit: whatever their neighbours, their
/// order, the threads and the instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/simulation/simulate_each.h"
#include "apc/simulation/together.h"
#include "apc/study/result_text.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

/// Every number of a result but the wall clock.
std::string all_of(Result result) {
  result.solver.wall_s = 0.0;
  auto text = study::to_text(result);
  const auto& history = result.history;
  for (const auto* column : {&history.time, &history.distance, &history.speed, &history.deceleration, &history.pitch,
                             &history.pitch_rate, &history.heave, &history.dissipated})
    text += study::to_text(*column);
  for (const auto& gear : history.gears)
    for (const auto* column : {&gear.drag, &gear.vertical, &gear.stroke, &gear.penetration, &gear.rut, &gear.spin})
      text += study::to_text(*column);
  return text;
}

/// Overruns of three aircraft over beds that ramp, step, fall short and lie raised; brakes that change at the edge;
/// altered ground; some with histories; and some that lanes must leave to the scalar code.
class SideBySide : public ::testing::Test {
 protected:
  SideBySide() {
    for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
      models_.push_back(testing::foam_model(name, testing::foam_bed(0.4572, 15.24, 400.0)));
      models_.push_back(testing::foam_model(name, testing::foam_bed(0.3, 0.0, 60.0)));
      auto raised = testing::foam_bed(0.35, 12.0, 500.0);
      raised.flush = bed::Flush::base;
      raised.distance = {0.0, 12.0, 60.0, 90.0, 500.0};
      raised.depth = {0.0, 0.35, 0.35, 0.45, 0.45};
      models_.push_back(testing::foam_model(name, raised));
    }
    options_.method = with_history_.method = Method::fast;
    options_.sampling = 0.0, with_history_.sampling = 0.01;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t m = 0; m < models_.size(); ++m)
      for (int k = 0; k < 6; ++k) {
        Overrun overrun;
        overrun.entry_speed = (25.0 + 50.0 * uniform(random)) * units::kt;
        overrun.mass = (0.85 + 0.15 * uniform(random)) * models_[m].aircraft.mass;
        overrun.braking = k % 3 == 0 ? 0.0 : 0.25;
        if (k % 3 == 1) overrun.braking_in_bed = 0.1;
        if (k == 2) overrun.thrust = -1e4, overrun.headwind = 3.0;
        if (k == 3) overrun.wheel_spin = WheelSpin::free;
        if (k == 4) overrun.alterations.bed_strength = 0.9;
        if (k == 5 && m % 3 == 0) overrun.brake_mode = BrakeMode::torque;
        overruns_.push_back(overrun);
        of_.push_back(m);
      }
    for (std::size_t i = 0; i < overruns_.size(); ++i) {
      const auto& options = i % 7 == 6 ? with_history_ : options_;
      errands_.push_back({&models_[of_[i]], &overruns_[i], &options});
      alone_.push_back(all_of(simulate(models_[of_[i]], overruns_[i], options)));
    }
  }

  std::vector<Model> models_;
  std::vector<Overrun> overruns_;
  std::vector<std::size_t> of_;
  Options options_, with_history_;
  std::vector<Errand> errands_;
  std::vector<std::string> alone_;
};

TEST_F(SideBySide, HasTheBitsOfOneByOneForAnyNumberOfThreads) {
  EXPECT_GT(std::count_if(errands_.begin(), errands_.end(), fits_lanes), 45);
  for (const unsigned threads : {1u, 3u}) {
    const auto outturns = simulate_each(errands_, threads);
    for (std::size_t i = 0; i < errands_.size(); ++i) {
      ASSERT_FALSE(outturns[i].failure) << i;
      EXPECT_EQ(all_of(outturns[i].result), alone_[i]) << i << " on " << threads << " threads";
    }
  }
}

TEST(SideBySideAtWalkingPace, EndsWhereOnlyFadingDragHoldsTheThrust) {
  // The end of a run that no event marks: neighbours in the block must neither feel nor miss it.
  auto plane = testing::shipped_aircraft("B737-800");
  plane.aero = {};
  const auto model = testing::exact_model(plane, [](double, double penetration) {
    return TireLoad{0.1 * 4e6 * penetration, 4e6 * penetration, 0.0, 1.0};
  });
  Options options;
  options.method = Method::fast;
  options.sampling = 0.0;
  std::vector<Overrun> overruns(12);
  std::vector<Errand> errands;
  for (std::size_t i = 0; i < overruns.size(); ++i) {
    overruns[i].entry_speed = (10.0 + static_cast<double>(i)) * units::kt;
    overruns[i].thrust = 0.08 * static_cast<double>(i) * 0.1 * plane.mass * units::g0;
    errands.push_back({&model, &overruns[i], &options});
  }
  const auto outturns = simulate_each(errands, 1);
  for (std::size_t i = 0; i < errands.size(); ++i) {
    ASSERT_FALSE(outturns[i].failure) << i;
    EXPECT_EQ(outturns[i].result.outcome, Outcome::stopped);
    EXPECT_EQ(all_of(outturns[i].result), all_of(simulate(model, overruns[i], options))) << i;
  }
}

TEST_F(SideBySide, HasTheSameBitsInAnyOrder) {
  std::vector<std::size_t> order(errands_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<Errand> shuffled;
  for (const auto i : order) shuffled.push_back(errands_[i]);
  const auto outturns = simulate_each(shuffled, 1);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(all_of(outturns[i].result), alone_[order[i]]) << order[i];
}

TEST_F(SideBySide, HasTheSameBitsInEveryInstructionSetOfThisProcessor) {
  const auto run = [&](LaneBlock* (*make)()) {
    std::map<Shape, std::vector<std::size_t>> queues;
    for (std::size_t i = 0; i < errands_.size(); ++i)
      if (fits_lanes(errands_[i])) queues[shape_of(models_[of_[i]], overruns_[i])].push_back(i);
    for (const auto& [shape, queue] : queues) {
      Convoy convoy(shape, make());
      for (std::size_t next = 0; next < queue.size() || !convoy.empty(); convoy.advance()) {
        while (next < queue.size() && convoy.has_room()) convoy.add(errands_[queue[next]], queue[next]), ++next;
        for (const auto& each : convoy.settled()) EXPECT_EQ(all_of(each.outturn.result), alone_[each.ticket]);
      }
    }
  };
  run(make_lane_block_v2);
  if (__builtin_cpu_supports("x86-64-v3")) run(make_lane_block_v3);
  if (__builtin_cpu_supports("x86-64-v4")) run(make_lane_block_v4);
}

TEST_F(SideBySide, HasTheSameBitsForCallersWhoWaitForOneAtATime) {
  const Together solve(2);
  std::vector<std::string> all(errands_.size());
  parallel_for(errands_.size(), solve.callers(), [&](std::size_t i) {
    const auto& each = errands_[i];
    all[i] = all_of(solve(*each.model, *each.overrun, *each.options));
  });
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], alone_[i]) << i;
  auto untrimmed = overruns_[0];
  untrimmed.cg_behind_nose_gear = 100.0;
  EXPECT_THROW(solve(models_[0], untrimmed, options_), InputError);
}

TEST_F(SideBySide, ARunThatFailsFailsAloneWithItsOwnWords) {
  auto hopeless = overruns_[0];
  hopeless.thrust = 2.5e5;  // rolls on and on, and is not turned over
  Options hurried = options_;
  hurried.time_limit = 20.0;
  auto untrimmed = overruns_[0];
  untrimmed.cg_behind_nose_gear = 100.0;
  auto endless = models_[0];
  endless.bed.distance.back() = 1e6;
  std::vector<Errand> errands(errands_.begin(), errands_.begin() + 6);
  errands.insert(errands.begin() + 1, {&endless, &hopeless, &hurried});
  errands.insert(errands.begin() + 3, {&models_[0], &untrimmed, &options_});
  const auto words = [](const std::exception_ptr& failure) -> std::string {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  const auto alone = [&](const Errand& errand) -> std::string {
    try {
      simulate(*errand.model, *errand.overrun, *errand.options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  const auto outturns = simulate_each(errands, 2);
  for (std::size_t i = 0; i < errands.size(); ++i) EXPECT_EQ(words(outturns[i].failure), alone(errands[i])) << i;
  EXPECT_NE(words(outturns[1].failure), "");
  EXPECT_NE(words(outturns[3].failure), "");
  EXPECT_EQ(all_of(outturns[0].result), alone_[0]);
  EXPECT_EQ(all_of(outturns[2].result), alone_[1]);
}

TEST(Lanes, LeaveBrakesOnABogiesBeamToTheScalarCode) {
  auto model = testing::foam_model("B747-400", testing::foam_bed(0.3));
  Overrun overrun;
  overrun.entry_speed = 30.0;
  overrun.braking = 0.2;
  Options options;
  options.method = Method::fast;
  const Errand errand{&model, &overrun, &options};
  EXPECT_TRUE(fits_lanes(errand));
  for (auto& gear : model.aircraft.gears) gear.brake_rods = false;
  EXPECT_FALSE(fits_lanes(errand));
}

}  // namespace
}  // namespace apc::simulation
