// Which run to do next, where the answer can be reasoned out.
#include "apc/learning/next_run.h"

#include <gtest/gtest.h>

#include "apc/base/require.h"
#include "apc/effects/catalogue.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

effects::Applied usual(const std::string& id, double amplitude) {
  return effects::applied(effects::find_effect(effects::catalogue(), id), amplitude);
}

/// Two runs at one speed and mass, with a drag that grows with the speed hidden in them.
Case alike() {
  testing::SurveyedRuns wanted;
  wanted.speeds = {28.0, 28.0}, wanted.masses = {62000.0, 62000.0};
  wanted.hidden = {usual("inertial", 0.3)};
  return testing::surveyed_case(wanted);
}

NextOptions few(std::vector<double> speeds, std::vector<double> masses) {
  NextOptions options;
  options.speeds = std::move(speeds), options.masses = std::move(masses);
  options.threads = 1;
  return options;
}

TEST(NextRun, AnotherSpeedSeparatesWhatGrowsWithSpeedFromWhatDoesNot) {
  Case data = alike();
  for (auto& run : data.runs) run.channels.clear(), run.survey.reset();  // where it stopped is all there is
  const auto plan =
      plan_next(data, {{usual("inertial", 0.5)}, {usual("slope", 0.01)}}, {}, few({24.0, 28.0, 36.0}, {62000.0}));
  ASSERT_FALSE(plan.sharpens);
  const auto by_stop_alone = [&](std::size_t i) { return plan.at(i, 0).separation.front(); };
  EXPECT_GT(by_stop_alone(2), 2.0 * by_stop_alone(1));
  EXPECT_EQ(plan.candidates[plan.best.front()].speed, 36.0);
  // Each was fitted to the runs at hand: there they show the same stop, elsewhere not.
  const auto& here = plan.at(1, 0).expects;
  EXPECT_NEAR(here[0].stop, here[1].stop, 0.02 * here[0].stop);
  EXPECT_GT(plan.at(2, 0).expects[1].stop, plan.at(2, 0).expects[0].stop)
      << "a constant force must stop it later from a higher speed";
  EXPECT_LT(plan.contenders[0].misfit, 1.6);
}

TEST(NextRun, MoreInstrumentsNeverSeparateLess) {
  const Case data = alike();
  const auto plan = plan_next(data, {{usual("wall_tear", 3000.0)}, {}}, {}, few({20.0, 30.0}, {55000.0, 70000.0}));
  for (const CandidateRun& c : plan.candidates) {
    ASSERT_TRUE(c.simulated);
    for (const auto& [less, more] : {std::pair{0, 1}, {1, 2}, {2, 3}, {2, 4}, {3, 5}, {4, 5}})
      EXPECT_GE(c.separation[static_cast<std::size_t>(more)], c.separation[static_cast<std::size_t>(less)] - 1e-9);
  }
}

TEST(NextRun, TheSameEffectTwiceCannotBeSeparated) {
  const Case data = alike();
  const auto plan = plan_next(data, {{usual("slope", 0.01)}, {usual("slope", 0.02)}}, {}, few({24.0}, {62000.0}));
  EXPECT_LT(plan.candidates.front().separation.back(), 0.2);
}

TEST(NextRun, WithOneExplanationLeftARunSharpensWhatWasNotFound) {
  Case data = alike();
  for (auto& run : data.runs) run.channels.clear(), run.survey.reset();  // where it stopped is all there is
  const auto plan = plan_next(data, {{usual("inertial", 0.5)}}, effects::catalogue(), few({18.0, 34.0}, {50000.0}));
  EXPECT_TRUE(plan.sharpens);
  EXPECT_GT(plan.sharpness_now, 0.0);
  for (const CandidateRun& c : plan.candidates) EXPECT_GT(c.separation.back(), plan.sharpness_now);
}

TEST(NextRun, ContendersAreTheSetOrWhatCannotBeToldFromItsOnlyMember) {
  const auto& known = effects::catalogue();
  const std::vector<Rival> rivals = {
      {"seams", "debris", 0.9, 1.0}, {"aero", "seams", 0.85, 2.0}, {"seams", "slope", 0.9, 7.0}};
  const auto two = contenders_of({{"seams"}, {}}, rivals, {}, known);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_TRUE(two[1].empty());
  const auto beside = contenders_of({{"seams", "rate"}}, rivals, {usual("rate", 0.07)}, known);
  ASSERT_EQ(beside.size(), 3u);
  EXPECT_EQ(beside[1][0].effect.id, "debris");
  EXPECT_EQ(beside[2][0].effect.id, "aero");
  EXPECT_EQ(beside[1][1].values[0], 0.07);
  EXPECT_THROW(contenders_of({{"no such effect"}}, {}, {}, known), InputError);
}

}  // namespace
}  // namespace apc::learning
