#include "apc/study/sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "../design/closed_form.h"
#include "apc/base/require.h"
#include "apc/study/critical_speed.h"
#include "apc/study/envelope.h"
#include "apc/study/tornado.h"

namespace apc::study {
namespace {

Axes axes() {
  Axes out;
  out.speeds = {20.0, 25.0, 30.0}, out.mass_factors = {0.8, 1.0}, out.brakings = {0.0, 0.25};
  out.strengths = {0.9, 1.1};
  return out;
}

TEST(Sweep, RunsEveryCombinationInOrderForAnyNumberOfThreads) {
  const std::vector<simulation::Model> models{closed_form::model(5e4, 0.5), closed_form::model(2e4, 0.5)};
  const auto cases = combinations(models, axes());
  ASSERT_EQ(cases.size(), 2u * 3 * 2 * 2 * 2);
  SweepOptions one, four;
  one.threads = 1, four.threads = 4;
  Store a, b;
  const auto first = run(models, cases, closed_form::solve, a, one),
             second = run(models, cases, closed_form::solve, b, four);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(first[i].result.stop_distance, second[i].result.stop_distance);
    EXPECT_EQ(first[i].input.overrun.entry_speed, cases[i].overrun.entry_speed);
  }
}

TEST(Sweep, SolvesNothingTwice) {
  const std::vector<simulation::Model> models{closed_form::model(5e4, 0.5)};
  std::atomic<int> calls{0};
  const Solve counted = [&](const auto& model, const auto& run, const auto& options) {
    ++calls;
    return closed_form::solve(model, run, options);
  };
  auto some = axes();
  Store store;
  run(models, combinations(models, some), counted, store);
  EXPECT_EQ(calls, 24);
  some.speeds.push_back(35.0);  // one more speed: only its cases are new
  run(models, combinations(models, some), counted, store);
  EXPECT_EQ(calls, 32);
}

TEST(Sweep, ASolverThatGivesUpCostsOneCaseNotTheSweep) {
  const std::vector<simulation::Model> models{closed_form::model(5e4, 0.5)};
  const Solve moody = [](const auto& model, const auto& run, const auto& options) {
    if (run.entry_speed == 25.0) throw SolveError("no trim\nfound");
    return closed_form::solve(model, run, options);
  };
  Axes some;
  some.speeds = {20.0, 25.0, 30.0}, some.mass_factors = {1.0}, some.brakings = {0.0};
  Store store;
  for (int start = 0; start < 2; ++start) {  // the second time from the store
    const auto results = run(models, combinations(models, some), moody, store);
    EXPECT_TRUE(results[0].failure.empty());
    EXPECT_EQ(results[1].failure, "no trim found");
    EXPECT_TRUE(std::isfinite(results[2].result.stop_distance));
  }
}

TEST(Envelope, LengthFallsWithDepthAndTheLimitDepthIsWhereTheLoadMeetsIt) {
  EnvelopeInput input;
  input.model = closed_form::model(5e4, 0.31);
  input.depths = {0.1, 0.2, 0.3, 0.4}, input.speeds = {25.0, 35.0}, input.ramp = 10.0;
  Store store;
  const auto out = envelope(input, closed_form::solve, store);
  for (std::size_t d = 0; d + 1 < input.depths.size(); ++d)
    EXPECT_GT(out.stop_distance[1][d], out.stop_distance[1][d + 1]);
  // a₀ x + k h (x − r/2) = v²/2 with k = 20
  EXPECT_NEAR(out.stop_distance[1][1], (0.5 * 35 * 35 + 20 * 0.2 * 5) / (0.5 + 20 * 0.2), 1e-6);
  EXPECT_NEAR(out.limit_depth[0], 0.31, 5e-3);
}

TEST(Tornado, MovesEachInputByItselfAndPutsTheLargestFirst) {
  auto model = closed_form::model(5e4, 0.5);
  simulation::Overrun run;
  run.entry_speed = 30.0, run.braking = 0.1;
  Store store;
  const auto out = tornado(model, run, closed_form::solve, store);
  ASSERT_EQ(out.bars.size(), 8u);
  for (std::size_t i = 0; i + 1 < out.bars.size(); ++i) EXPECT_GE(out.bars[i].reach, out.bars[i + 1].reach);
  for (const auto& bar : out.bars) {
    if (bar.input == "exit speed") {
      EXPECT_LT(bar.distance_low, out.distance);
      EXPECT_GT(bar.distance_high, out.distance);
    }
    if (bar.input == "bed strength") {
      EXPECT_GT(bar.distance_low, out.distance);
    }
    if (bar.input == "pitch inertia") {
      EXPECT_NEAR(bar.reach, 0.0, 1e-9);  // the closed form does not know it
    }
  }
}

TEST(CriticalSpeed, IsTheSpeedThatStopsAtTheBedsEnd) {
  const auto model = closed_form::model(5e4, 0.5);  // 100 m of 0.4 m, no ramp
  int calls = 0;
  const Solve counted = [&](const auto& m, const auto& run, const auto& options) {
    ++calls;
    return closed_form::solve(m, run, options);
  };
  const Use use = [](const simulation::Result&) { return 0.0; };
  const auto found = critical_speed(model, {}, 100.0, use, counted, {});
  EXPECT_NEAR(found.arrest, std::sqrt(2 * 100.0 * (0.5 + 20 * 0.4)), 0.01);
  EXPECT_EQ(found.intact, found.arrest);
  EXPECT_LE(calls, 12);
  EXPECT_EQ(found.runs, calls);
}

TEST(CriticalSpeed, OfAnIntactStopIsWhereTheLoadMeetsItsLimit) {
  const auto model = closed_form::model(5e4, 0.5);
  const Use use = [](const simulation::Result& result) { return result.entry_speed / 27.0; };
  const auto found = critical_speed(model, {}, 100.0, use, closed_form::solve, {});
  EXPECT_NEAR(found.intact, 27.0, 0.01);
  EXPECT_GT(found.arrest, 40.0);
}

}  // namespace
}  // namespace apc::study
