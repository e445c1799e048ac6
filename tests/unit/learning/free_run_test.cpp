// Free runs: their errors are those of the comparison, strength and sizes come back from runs that hold them, effects
// are weighed by what they mend, and leaving runs out tells help from harm.
#include <gtest/gtest.h>

#include <cmath>

#include "apc/effects/catalogue.h"
#include "apc/learning/free_evidence.h"
#include "apc/learning/held_out.h"
#include "apc/learning/run_level.h"
#include "apc/learning/shapes.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

Case made(const std::vector<effects::Applied>& hidden, double scatter, unsigned seed = 1) {
  testing::SurveyedRuns wanted;
  wanted.speeds = {20.0, 26.0, 30.0, 34.0}, wanted.masses = {50000.0, 60000.0, 66000.0, 70000.0};
  wanted.hidden = hidden;
  wanted.block_strength = scatter, wanted.sinking = 1.0, wanted.seed = seed;
  return testing::surveyed_case(wanted);
}

effects::Applied inertia(double C) {
  return effects::applied(effects::find_effect(effects::catalogue(), "inertial"), C);
}

TEST(FreeRun, SquaredLengthOfTheMisfitIsTheErrorOfTheComparison) {
  const Case data = made({inertia(0.6)}, 0.02);
  const FreeRuns f = free_runs(data, 0);
  const auto misfits = free_misfits(f, 0.0, {});
  for (std::size_t r = 0; r < data.runs.size(); ++r) {
    const double error = compare(data, f.layout, r, data.runs[r], f.eta, {}).total;
    EXPECT_GT(error, 1.0) << "a hidden inertia is an error";
    EXPECT_NEAR(misfits[r].norm(), error, 0.02 * error);
  }
}

TEST(FreeRun, AModelThatIsRightErrsByTheInstruments) {
  const Case data = made({}, 1e-4);
  // Speed and acceleration within their noise or 2 % of the range, the stop within 2 %.
  for (const auto& misfit : free_misfits(free_runs(data, 0), 0.0, {})) EXPECT_LT(misfit.norm(), 1.2);
}

TEST(FreeRun, RunsThatAreNotUsedTellNothing) {
  const Case data = made({}, 1e-4);
  const auto misfits = free_misfits(free_runs(data, 0), 0.0, {}, {1, 0, 1, 1});
  EXPECT_GT(misfits[0].size(), 0);
  EXPECT_EQ(misfits[1].size(), 0);
}

TEST(FreeFit, FindsTheSizeOfAnEffectBesideTheStrength) {
  const Case data = made({inertia(0.6)}, 0.01);
  const FreeRuns f = free_runs(data, 0);
  const FreeFit none = fit_strength(f), with = fit_free(f, {inertia(0.1)}, none.strength);
  std::printf("without: strength %.3f, S %.1f; with: strength %.3f, C %.3f ± %.3f, S %.1f\n", none.strength,
              none.square, with.strength, with.effects[0].values[0], std::sqrt(with.covariance(1, 1)), with.square);
  EXPECT_LT(with.square, 0.3 * none.square);
  EXPECT_NEAR(with.effects[0].values[0], 0.6, 0.06);
  EXPECT_NEAR(with.strength, 0.0, 0.03);
  EXPECT_GT(log_evidence_of(with, none), 4.0);
}

TEST(FreeFit, AnAmplitudeStaysInItsRange) {
  const Case data = made({}, 0.02);
  const FreeRuns f = free_runs(data, 0);
  const FreeFit fit = fit_free(f, {inertia(0.2)}, 0.0);
  EXPECT_GE(fit.effects[0].values[0], 0.0) << "foam is not thrown forward";
  EXPECT_LT(fit.effects[0].values[0], 0.1);
}

TEST(FreeFit, ALevelTakesUpWhatIsWrongWithOneRun) {
  Case data = made({}, 1e-4);
  const FreeFit right = fit_strength(free_runs(data, 0));
  for (const double level : right.levels) EXPECT_LT(std::abs(level), 0.01);
  data.runs[2].overrun.mass *= 1.1;  // said to be heavier than it was: the bed seems stronger to it
  const FreeFit fit = fit_strength(free_runs(data, 0));
  std::printf("levels %.3f %.3f %.3f %.3f, strength %.3f\n", fit.levels[0], fit.levels[1], fit.levels[2], fit.levels[3],
              fit.strength);
  EXPECT_GT(fit.levels[2], 0.02);
  for (const std::size_t other : {0, 1, 3}) EXPECT_LT(std::abs(fit.levels[other]), 0.5 * fit.levels[2]) << other;
  EXPECT_LT(std::abs(fit.strength), 0.02);
}

TEST(FreeFit, ASearchLeadsBackToTheMinimumAndItsObjectiveIsThatOfItsMisfits) {
  const Case data = made({inertia(0.6)}, 0.01);
  const FreeRuns f = free_runs(data, 0);
  const FreeFit best = fit_free(f, {inertia(0.1)}, 0.0);
  FreeFit moved = best;
  moved.strength += std::sqrt(best.covariance(0, 0)), moved.effects[0].values[0] += std::sqrt(best.covariance(1, 1));
  moved.levels[1] += 0.5 * f.level_deviation[1];
  const auto lay_open = [&](FreeFit& fit) {  // square and objective of where it stands, as fit_free reckons them
    fit.misfit = free_misfits(f, fit.strength, fit.effects, {}, fit.levels);
    fit.square = 0.0, fit.objective = 0.0;
    for (std::size_t r = 0; r < fit.misfit.size(); ++r) {
      fit.square += fit.misfit[r].squaredNorm();
      fit.objective += std::pow(fit.levels[r] / f.level_deviation[r], 2);
    }
    const effects::Parameter& p = fit.effects[0].effect.parameters.front();
    fit.objective += told_by(f).objective(fit.square) + std::pow(fit.strength / data.bed_strength, 2) +
                     std::pow((fit.effects[0].values[0] - p.neutral) / amplitude_deviation(p), 2);
  };
  lay_open(moved);
  ASSERT_GT(moved.objective, best.objective + 1.0);
  const FreeFit found = searched(f, moved);
  std::printf("O %.2f, moved to %.2f, found %.2f\n", best.objective, moved.objective, found.objective);
  EXPECT_LT(found.objective, best.objective + 0.3);
  EXPECT_EQ(found.covariance, best.covariance);
  FreeFit again = found;
  lay_open(again);
  EXPECT_NEAR(again.objective, found.objective, 1e-9 * std::abs(found.objective));
}

TEST(FreeFit, ErrorsBelowTheirUncertaintyGainNoMoreThanTheyAreWorth) {
  const Told told{6.0, 2.0};
  // A run fitted exactly is no proof: O is bounded, and meets the logarithm where errors are their uncertainties.
  EXPECT_NEAR(told.objective(2.0), 6.0 * std::log(2.0), 1e-12);
  EXPECT_NEAR(told.objective(2.0) - told.objective(0.0), 6.0, 1e-12);
  for (const double S : {0.5, 1.999, 2.001, 30.0})
    EXPECT_NEAR((told.objective(S + 1e-5) - told.objective(S - 1e-5)) / 2e-5, told.weight(S), 1e-4);
}

TEST(FreeFit, ARunOfWhichOnlyTheStopIsKnownTellsOneNumber) {
  Case data = made({}, 1e-4);
  EXPECT_EQ(told_by(free_runs(data, 0)).numbers, 4.0 * told_by_a_run);
  for (auto& run : data.runs) run.channels.clear();
  const Told told = told_by(free_runs(data, 0));
  EXPECT_EQ(told.numbers, 4.0);
  EXPECT_EQ(told.runs, 4.0);
}

TEST(RunLevel, BlocksAverageOutOverTheWay) {
  learning::Run run;
  run.overrun.entry_speed = 30.0, run.uncertainty.entry_speed = 0.0;
  run.overrun.mass = 60000.0, run.uncertainty.mass = 0.0;
  run.stop = 100.0;
  const double from_day_to_day = 0.02, tracks = std::sqrt(0.5 * 1.3);
  EXPECT_NEAR(level_deviation(run, 150.0, 0.0, 5.0), from_day_to_day, 1e-12);
  // One value for the whole way; and 2 ℓ / way of the variance where the way is long.
  EXPECT_NEAR(level_deviation(run, 150.0, 0.1, 1e9), std::hypot(from_day_to_day, 0.1 * tracks), 1e-5);
  EXPECT_NEAR(level_deviation(run, 150.0, 0.1, 0.5), std::hypot(from_day_to_day, 0.1 * tracks * std::sqrt(0.01)), 1e-4);
  run.uncertainty.mass = 600.0, run.uncertainty.entry_speed = 0.15;
  EXPECT_NEAR(level_deviation(run, 150.0, 0.0, 5.0), std::sqrt(4e-4 + 1e-4 + 1e-4), 1e-12);
}

TEST(FreeEvidence, ARightEffectLeadsAndWeighsNothingWhereItIsNot) {
  std::vector<effects::Effect> laws;
  for (const char* id : {"inertial", "softening", "slope", "oleo_friction", "temperature"})
    laws.push_back(effects::find_effect(effects::catalogue(), id));
  const Case hidden = made({inertia(0.6)}, 0.04, 3), clean = made({}, 0.04, 3);
  const auto with = weigh_free(hidden, laws, 0, {}), without = weigh_free(clean, laws, 0, {});
  ASSERT_TRUE(with && without);
  for (const auto& law : laws)
    std::printf("%-14s %.1f where inertia is hidden, %.1f where nothing is\n", law.id.c_str(), with->of({law.id}),
                without->of({law.id}));
  for (const auto& law : laws) {
    if (law.id != "inertial") {
      EXPECT_GT(with->of({"inertial"}), with->of({law.id}) + 2.0) << law.id;
    }
    EXPECT_LT(without->of({law.id}), 3.0) << law.id;
  }
  EXPECT_GT(with->of({"inertial"}), 4.0);
  auto pairs = *with;
  const auto slope = effects::applied(effects::find_effect(effects::catalogue(), "slope"), 0.005);
  add_pair(pairs, {slope, inertia(0.3)});
  ASSERT_TRUE(pairs.sets.contains({"inertial", "slope"}));
  std::printf("inertia and slope %.1f\n", pairs.of({"inertial", "slope"}));
  EXPECT_LT(pairs.of({"inertial", "slope"}), with->of({"inertial"}) + 1.0) << "what is not there adds nothing";
  EXPECT_EQ(with->of({"inertial", "seams"}), with->of({"inertial"})) << "joints are not seen by free runs";
}

TEST(HeldOut, ARightEffectHelpsRunsItWasNotFittedTo) {
  const Case data = made({inertia(0.6)}, 0.03);
  const HeldOut held = leave_one_out(free_runs(data, 0), {inertia(0.3)}, 0.0);
  ASSERT_EQ(held.runs.size(), data.runs.size());
  std::printf("error %.2f before, %.2f after\n", held.before, held.after);
  EXPECT_TRUE(held.helps());
  EXPECT_LT(held.after, 0.6 * held.before);
}

TEST(HeldOut, NothingHelpsWhereNothingIsMissing) {
  const Case data = made({}, 1e-4);
  const HeldOut held = leave_one_out(free_runs(data, 0), {inertia(0.1)}, 0.0);
  EXPECT_FALSE(held.helps()) << held.before << " -> " << held.after;
}

TEST(HeldOut, OneRunProvesNothing) {
  Case data = made({inertia(0.6)}, 0.03);
  data.runs.resize(1);
  const HeldOut held = leave_one_out(free_runs(data, 0), {inertia(0.3)}, 0.0);
  EXPECT_TRUE(held.runs.empty());
  EXPECT_FALSE(held.helps());
}

}  // namespace
}  // namespace apc::learning
