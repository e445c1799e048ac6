// What is added to the model: claims with the sizes of free runs, tries that prove themselves on runs left out, and
// nothing where nothing is said to be missing.
#include "apc/learning/augment.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "apc/effects/catalogue.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

effects::Applied law(const char* id, double size) {
  return effects::applied(effects::find_effect(effects::catalogue(), id), size);
}

/// Four runs with an inertia hidden in them, weighed on free runs among three laws.
struct Weighed {
  Case data;
  Study study;
};
std::unique_ptr<Weighed> weighed(Verdict verdict) {
  auto w = std::make_unique<Weighed>();
  testing::SurveyedRuns wanted;
  wanted.speeds = {20.0, 26.0, 30.0, 34.0}, wanted.masses = {50000.0, 60000.0, 66000.0, 70000.0};
  wanted.hidden = {law("inertial", 0.6)};
  wanted.block_strength = 0.03, wanted.sinking = 1.0;
  w->data = testing::surveyed_case(wanted);
  std::vector<effects::Effect> laws;
  for (const char* id : {"inertial", "slope", "temperature"})
    laws.push_back(effects::find_effect(effects::catalogue(), id));
  w->study.free = weigh_free(w->data, laws, 0, {});
  w->study.diagnosis.verdict = verdict;
  return w;
}

TEST(Augment, TriesWhatMendsFreeRunsWhereNothingIsClaimed) {
  const auto w = weighed(Verdict::ambiguous);
  augment(w->study);
  ASSERT_EQ(w->study.diagnosis.augmented.size(), 1u);
  EXPECT_TRUE(w->study.diagnosis.tried);
  EXPECT_EQ(w->study.diagnosis.augmented.front().effect.id, "inertial");
  EXPECT_NEAR(w->study.diagnosis.augmented.front().values.front(), 0.6, 0.1);
  EXPECT_TRUE(w->study.held_out.helps());
}

TEST(Augment, AddsNothingWhereNothingIsSaidToBeMissing) {
  const auto w = weighed(Verdict::nothing);
  augment(w->study);
  EXPECT_TRUE(w->study.diagnosis.augmented.empty());
  EXPECT_FALSE(w->study.diagnosis.tried);
  EXPECT_EQ(w->study.strength, w->study.free->none.strength);
}

Claim claimed(const effects::Applied& applied, double probability) {
  Claim claim;
  claim.id = applied.effect.id, claim.applied = applied, claim.probability = probability;
  return claim;
}

TEST(Augment, AClaimThatDoesNotHelpIsNotCertainAndLeavesPredictionsAlone) {
  const auto w = weighed(Verdict::found);
  w->study.diagnosis.augmented = {law("temperature", 0.003)};
  w->study.diagnosis.claims = {claimed(law("temperature", 0.003), 0.99), claimed(law("slope", 0.01), 0.2)};
  augment(w->study);
  EXPECT_EQ(w->study.diagnosis.claims[0].probability, 0.75);
  EXPECT_EQ(w->study.diagnosis.claims[1].probability, 0.2) << "not asked";
  EXPECT_EQ(w->study.diagnosis.verdict, Verdict::ambiguous);
  ASSERT_EQ(w->study.diagnosis.augmented.size(), 1u);
  EXPECT_FALSE(w->study.diagnosis.tried);
  EXPECT_FALSE(w->study.held_out.helps()) << w->study.held_out.before << " -> " << w->study.held_out.after;
}

TEST(Augment, AClaimMustHelpInItsOwnForm) {
  // Free runs know another form of the claimed law, and that form (it acts as the hidden inertia does) mends them.
  const auto w = weighed(Verdict::found);
  auto other = law("inertial", 0.6);
  other.effect.id = "temperature", other.effect.form = "other";
  w->study.free->sets[{"temperature"}] = {fit_free(w->study.free->runs, {other}, 0.0), 5.0};
  w->study.diagnosis.augmented = {law("temperature", 0.003)};
  w->study.diagnosis.claims = {claimed(law("temperature", 0.003), 0.99)};
  augment(w->study);
  EXPECT_EQ(w->study.diagnosis.claims[0].probability, 0.75);
  EXPECT_FALSE(w->study.held_out.helps());
  w->study.diagnosis.augmented = {other};
  w->study.diagnosis.claims = {claimed(other, 0.99)};
  augment(w->study);
  EXPECT_TRUE(w->study.held_out.helps());
  EXPECT_EQ(w->study.diagnosis.claims[0].probability, 0.99);
}

TEST(Augment, AClaimThatHelpsKeepsItsProbability) {
  const auto w = weighed(Verdict::found);
  w->study.diagnosis.augmented = {law("inertial", 0.6)};
  w->study.diagnosis.claims = {claimed(law("inertial", 0.6), 0.99)};
  augment(w->study);
  EXPECT_TRUE(w->study.held_out.helps());
  EXPECT_EQ(w->study.diagnosis.claims[0].probability, 0.99);
  EXPECT_EQ(w->study.diagnosis.verdict, Verdict::found);
}

TEST(Augment, WhatKnowsARunByItsDateIsNoTry) {
  EXPECT_TRUE(known_by_date(effects::find_effect(effects::catalogue(), "ageing")));
  EXPECT_TRUE(known_by_date(effects::find_effect(effects::catalogue(), "temperature")));
  for (const char* id : {"inertial", "softening", "rate", "lock_up", "slope", "tire_loss"})
    EXPECT_FALSE(known_by_date(effects::find_effect(effects::catalogue(), id))) << id;
}

TEST(HeldOut, TheErrorMustFallByMoreThanRunsScatter) {
  HeldOut held;
  held.runs.resize(6);
  EXPECT_NEAR(held.least_fall(), 0.242, 0.001);
  held.before = 4.0, held.after = 3.1;
  EXPECT_FALSE(held.helps());
  held.after = 3.0;
  EXPECT_TRUE(held.helps());
  held.runs.resize(2);
  EXPECT_FALSE(held.helps()) << "two runs tell less";
}

TEST(HeldOut, ARunThatIsRuinedIsNotPaidForByAnother) {
  const auto runs = [](const std::vector<std::array<double, 2>>& errors) {
    std::vector<LeftOut> list;
    for (const auto& [before, after] : errors) {
      LeftOut one;
      one.before.total = before, one.after.total = after;
      list.push_back(one);
    }
    return list;
  };
  // Roots of the mean squares fall from 7.0 to 3.6 and to 2.4.
  EXPECT_FALSE(held_out_of(runs({{1.0, 6.0}, {12.0, 3.0}, {7.0, 2.0}, {1.5, 1.4}})).helps());
  // Here the geometric mean falls by 45 %, and one standard error is 49 %: one run is four times as bad.
  const HeldOut uneven = held_out_of(runs({{1.0, 4.0}, {12.0, 3.0}, {9.0, 2.0}, {6.0, 2.5}}));
  EXPECT_NEAR(uneven.least_fall(), 0.4905, 1e-4);
  EXPECT_FALSE(uneven.helps()) << uneven.before << " -> " << uneven.after;
  const HeldOut even = held_out_of(runs({{1.0, 0.2}, {12.0, 4.0}, {7.0, 2.0}, {1.5, 1.5}}));
  EXPECT_TRUE(even.helps());
  EXPECT_NEAR(even.before, std::pow(1.0 * 12.0 * 7.0 * 1.5, 0.25), 1e-12);
  EXPECT_NEAR(even.after, std::pow(1.0 * 4.0 * 2.0 * 1.5, 0.25), 1e-12) << "below its uncertainty an error is 1";
}

}  // namespace
}  // namespace apc::learning
