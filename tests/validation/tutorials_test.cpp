// The tutorials (apc/doc/tutorials): what a reader is told the program says, asserted on the cases they ship
// (designs/cases). Three of them are simulated by this project itself with something hidden: they show how to read an
// answer, not how good answers are on measured runs.
//   APC_WRITE_TUTORIALS=1 validation_tests --gtest_filter=Tutorials.WriteCases      writes the cases again
#include <gtest/gtest.h>

#include <cstdio>

#include "apc/learning/next_run.h"
#include "tests/support/tutorial_cases.h"

namespace apc::learning {
namespace {

Study studied(const Case& data, const std::vector<effects::Effect>& own = {}) {
  DiagnoseOptions options;
  options.effects = effects::catalogue();
  options.effects.insert(options.effects.end(), own.begin(), own.end());
  Study study = diagnose(data, options);
  std::printf("%s: %s", data.title.c_str(), text(study.diagnosis.verdict));
  for (const Claim& claim : study.diagnosis.claims)
    if (claim.probability > 0.1) std::printf(", %s P %.2f", claim.id.c_str(), claim.probability);
  std::printf("\n");
  return study;
}

TEST(Tutorials, TheFaaPairCannotBeToldApartAndASlowRunWithRutsWould) {
  const Case data = load_case(testing::tutorial_folder("faa_b727"));
  const Diagnosis d = studied(data).diagnosis;
  EXPECT_EQ(d.verdict, Verdict::ambiguous);
  for (const Claim& claim : d.claims) EXPECT_LT(claim.probability, 0.5) << claim.id;
  EXPECT_GE(d.set90.size(), 3u);

  // A law of speed against a law of place: what the pair suggests.
  const auto& known = effects::catalogue();
  NextOptions options;
  options.speeds = {30 * units::kt, 50 * units::kt, 60 * units::kt}, options.masses = {53722.0};
  const NextPlan plan = plan_next(data, contenders_of({{"inertial"}, {"softening"}}, {}, {}, known), known, options);
  ASSERT_FALSE(plan.best.empty());
  std::printf("apart at 30, 50, 60 kt: %.1f, %.1f, %.1f; by the stop alone %.1f, %.1f, %.1f\n",
              plan.at(0, 0).separation.back(), plan.at(1, 0).separation.back(), plan.at(2, 0).separation.back(),
              plan.at(0, 0).separation.front(), plan.at(1, 0).separation.front(), plan.at(2, 0).separation.front());
  // The slow run, which stays in the first third of the bed, is as good as the best.
  const double best = plan.candidates[plan.best.front()].separation.back();
  EXPECT_GT(plan.at(0, 0).separation.back(), 0.95 * best);
  EXPECT_GT(plan.at(0, 0).separation.back(), 4.0);
  // Where it stops is not enough: bed strength, tables and entry speed may hold as much.
  for (const CandidateRun& c : plan.candidates) EXPECT_LT(c.separation.front(), 2.0);
}

TEST(Tutorials, FrostOnTheFirstRowsIsSofteningWithPlace) {
  const Diagnosis d = studied(load_case(testing::tutorial_folder("frost"))).diagnosis;
  EXPECT_EQ(d.verdict, Verdict::found);
  ASSERT_FALSE(d.claims.empty());
  EXPECT_EQ(d.claims.front().id, "softening");
  EXPECT_GT(d.claims.front().probability, 0.8);
  // Half the strength is gone on the first 12 m: rows, all alike, and not the catalogue's law that fades with distance.
  const auto& softened = d.claims.front().applied;
  EXPECT_EQ(softened.effect.form, "rows");
  EXPECT_NEAR(softened.values[0] * (softened.values[1] + softened.values[2]), 0.5 * 12.2, 0.25 * 12.2);
}

TEST(Tutorials, ATiltedAccelerometerIsBlamedAndNotTheSlope) {
  const Diagnosis d = studied(load_case(testing::tutorial_folder("tilted"))).diagnosis;
  EXPECT_EQ(d.verdict, Verdict::sensor);
  for (const Claim& claim : d.claims) EXPECT_LT(claim.probability, 0.5) << claim.id;
  ASSERT_FALSE(d.sensors.empty());
  EXPECT_EQ(d.sensors.front().what, "acceleration_x.bias");
  EXPECT_EQ(d.sensors.front().run, "") << "in every run";
  EXPECT_NEAR(d.sensors.front().value, 0.03 * units::g0, 3.0 * d.sensors.front().deviation);
}

TEST(Tutorials, NothingIsMissingFromTwoCleanRuns) {
  const Diagnosis d = studied(load_case(testing::tutorial_folder("clean"))).diagnosis;
  EXPECT_EQ(d.verdict, Verdict::nothing);
  EXPECT_TRUE(d.augmented.empty());
  ASSERT_TRUE(d.smallest_detectable.contains("inertial.C"));
  EXPECT_LT(d.smallest_detectable.at("inertial.C"), 1.0) << "two runs with ruts say something about inertia";
}

TEST(Tutorials, AUsersOwnEffectComesFirst) {
  const auto hump = effects::load_own_effect(testing::tutorial_folder("own_effect") / "hump.json");
  const Diagnosis d = studied(load_case(testing::tutorial_folder("own_effect")), {hump}).diagnosis;
  ASSERT_FALSE(d.claims.empty());
  EXPECT_EQ(d.claims.front().id, "hump");
  EXPECT_GT(d.claims.front().probability, 0.5);
  EXPECT_NEAR(d.claims.front().applied.values[0], 7e4, 3.0 * d.claims.front().deviation[0]);
  for (std::size_t i = 1; i < d.claims.size(); ++i) EXPECT_LT(d.claims[i].probability, 0.3) << d.claims[i].id;
}

TEST(Tutorials, WriteCases) {
  if (!std::getenv("APC_WRITE_TUTORIALS")) GTEST_SKIP() << "set APC_WRITE_TUTORIALS to write designs/cases again";
  testing::write_faa_pair();
  auto frosty = testing::tutorial_runs(3);
  frosty.hidden = {testing::frost(12.2, 0.5)};
  testing::write_tutorial("frost", "B737-800 in 20 in of foam after a frost", frosty);
  auto tilted = testing::tutorial_runs(4);
  tilted.accelerometer_offset = 0.03 * units::g0;
  testing::write_tutorial("tilted", "B737-800 in 20 in of foam, new accelerometer", tilted);
  auto clean = testing::tutorial_runs(5);
  clean.speeds = {22.0, 31.0}, clean.masses = {56000.0, 66000.0}, clean.ramp = 15.24;
  testing::write_tutorial("clean", "B737-800 in 20 in of foam, two runs", clean);
  auto own = testing::tutorial_runs(6);
  own.hidden = {effects::applied(effects::load_own_effect(testing::tutorial_folder("own_effect") / "hump.json"), 7e4)};
  testing::write_tutorial("own_effect", "B737-800 in 20 in of foam, drag with a hump", own);
}

}  // namespace
}  // namespace apc::learning
