#include "apc/reliability/reliability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../design/closed_form.h"
#include "apc/base/require.h"

namespace apc::reliability {
namespace {

TEST(NormalOf, HasTheQuantilesOfTheStandardNormal) {
  EXPECT_NEAR(normal_of(0.5), 0.0, 1e-9);
  EXPECT_NEAR(normal_of(0.975), 1.959963985, 1e-8);
  EXPECT_NEAR(normal_of(0.01), -2.326347874, 1e-8);
  EXPECT_EQ(normal_of(1e-9), -3.0);
}

TEST(LatinHypercube, VisitsEveryStratumOnce) {
  const auto points = latin_hypercube(50, 3);
  for (std::size_t input = 0; input < scattered_inputs; ++input) {
    std::set<int> strata;
    for (const auto& point : points) strata.insert(static_cast<int>(point[input] * 50));
    EXPECT_EQ(strata.size(), 50u);
  }
}

/// f = x₁ + 2 x₂ + x₁x₂ of uniform inputs on (−1, 1): variances 1/3, 4/3, 1/9.
TEST(Chaos, GivesTheSobolIndicesOfAKnownFunction) {
  Draws draws(5);
  std::vector<std::vector<double>> u;
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) {
    u.push_back({draws.next(), draws.next(), draws.next()});
    const double x = 2 * u.back()[0] - 1, y = 2 * u.back()[1] - 1;
    values.push_back(x + 2 * y + x * y);
  }
  const Chaos chaos(u, values);
  const auto indices = chaos.indices();
  const double total = 1.0 / 3 + 4.0 / 3 + 1.0 / 9;
  EXPECT_NEAR(chaos.unexplained(), 0.0, 1e-9);
  EXPECT_NEAR(indices[0].first, 1.0 / 3 / total, 1e-6);
  EXPECT_NEAR(indices[1].total, (4.0 / 3 + 1.0 / 9) / total, 1e-6);
  EXPECT_NEAR(indices[2].total, 0.0, 1e-9);
}

TEST(ExitSpeeds, PassThroughTheirTwoPoints) {
  const ExitSpeeds speeds;
  EXPECT_NEAR(speeds.below(40 * 0.514444), 0.5, 2e-3);
  EXPECT_NEAR(speeds.below(70 * 0.514444), 0.9, 2e-3);
}

ReliabilityInput braking_only() {
  ReliabilityInput input;
  input.model = closed_form::model(5e4, 0.5);
  input.centre.entry_speed = input.asked_speed = 38.0;
  input.use = [](const simulation::Result&) { return 0.0; };
  input.scatter.mass = input.scatter.cg = input.scatter.strength = input.scatter.depth = 0.0;
  input.scatter.block_strength = 0.0, input.scatter.temperature_scatter = input.scatter.per_kelvin = 0.0;
  input.scatter.per_year = 0.0;
  input.scatter.braking_low = 0.0, input.scatter.braking_high = 0.25;
  return input;
}

/// Only braking scatters: v_arrest² = 2 L (a₀ + k h + g μ), μ uniform.
TEST(Reliability, AgreesWithTheClosedForm) {
  const auto input = braking_only();
  study::Store store;
  ReliabilityOptions options;
  options.samples = 400;
  const auto out = assess(input, one_by_one(closed_form::solve), store, options);
  const auto critical = [](double mu) { return std::sqrt(200.0 * (0.5 + 20 * 0.4 + 9.80665 * mu)); };
  double exact = 0.0;
  for (int i = 0; i < 1000; ++i) exact += input.exit_speeds.below(critical(0.25 * (i + 0.5) / 1000)) / 1000;
  EXPECT_NEAR(out.arrest.value, exact, 2e-4);
  EXPECT_LE(out.arrest.low, exact + 1e-4);
  EXPECT_GE(out.arrest.high, exact - 1e-4);
  EXPECT_NEAR(out.arrest_speed_975, critical(0.25 * 0.025), 0.15);
  EXPECT_GT(out.arrest_indices[2].first, 0.95);  // braking
  EXPECT_LE(out.runs, 2 * 400);
}

/// A load (v/25 m/s)^0.4 × peak deceleration / 9.5 m/s² besides: v_intact in closed form, the smaller of the two.
TEST(Reliability, OfDamageAgreesWithTheClosedForm) {
  auto input = braking_only();
  input.use = [](const simulation::Result& result) {
    return std::pow(result.entry_speed / 25.0, 0.4) * result.peak_deceleration / 9.5;
  };
  study::Store store;
  ReliabilityOptions options;
  options.samples = 2000;
  const auto out = assess(input, one_by_one(closed_form::solve), store, options);
  double exact = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double a = 0.5 + 9.80665 * 0.25 * (i + 0.5) / 1000, peak = a + 20 * 0.4;
    const double arrest = std::sqrt(200.0 * peak), intact = 25.0 * std::pow(9.5 / peak, 2.5);
    exact += input.exit_speeds.below(std::min(arrest, intact)) / 1000;
  }
  EXPECT_NEAR(out.intact.value, exact, 1e-3);
  EXPECT_LE(out.intact.low, exact + 5e-4);
  EXPECT_GE(out.intact.high, exact - 5e-4);
  EXPECT_LT(out.intact.high - out.intact.low, 0.01);
  EXPECT_LE(out.intact_speed_975, out.arrest_speed_975);
  EXPECT_LE(out.runs, 4 * 2000);
}

TEST(Reliability, IsTheSameForAnyNumberOfThreads) {
  const auto input = braking_only();
  ReliabilityOptions one, four;
  one.samples = four.samples = 400, one.threads = 1, four.threads = 4;
  study::Store first, second;
  const auto a = assess(input, one_by_one(closed_form::solve), first, one);
  const auto b = assess(input, one_by_one(closed_form::solve), second, four);
  EXPECT_EQ(a.arrest_speeds, b.arrest_speeds);
  EXPECT_EQ(a.runs, b.runs);
}

TEST(Reliability, CountsSamplesTheSolverGivesUpOn) {
  const auto input = braking_only();
  study::Store store;
  ReliabilityOptions options;
  options.samples = 400;
  const auto solve = [](const simulation::Model& model, const simulation::Overrun& run,
                        const simulation::Options& how) -> simulation::Result {
    if (run.braking > 0.975 * 0.25) throw SolveError("too hard");
    return closed_form::solve(model, run, how);
  };
  const auto out = assess(input, one_by_one(solve), store, options);
  EXPECT_EQ(out.gave_up, 10u);  // the highest stratum of each cube of 40
  EXPECT_EQ(out.samples + out.gave_up, 400u);
}

TEST(Reliability, ContinuesFromItsStoreWithoutARun) {
  const auto input = braking_only();
  study::Store store;
  ReliabilityOptions options;
  options.samples = 200;
  const auto first = assess(input, one_by_one(closed_form::solve), store, options);
  const auto refuse = [](const simulation::Model&, const simulation::Overrun&,
                         const simulation::Options&) -> simulation::Result { throw SolveError("a run"); };
  const auto second = assess(input, one_by_one(refuse), store, options);
  EXPECT_GT(first.runs, 0);
  EXPECT_EQ(second.runs, first.runs);
  EXPECT_EQ(second.gave_up, 0u);
  EXPECT_EQ(first.arrest.value, second.arrest.value);
  EXPECT_EQ(first.intact_speeds, second.intact_speeds);
}

TEST(Drawn, BlocksScatterAsAskedAndTheSameSeedGivesTheSameBlocks) {
  auto model = closed_form::model(5e4, 0.5);
  model.bed.distance.back() = 20000.0;
  Scatter scatter;
  const std::array<double, scattered_inputs> middle{0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
  const auto run = drawn(model, {}, scatter, middle, 9), again = drawn(model, {}, scatter, middle, 9);
  const auto& blocks = run.alterations.strength.at(0).log_strength;
  EXPECT_EQ(blocks, again.alterations.strength.at(0).log_strength);
  double mean = 0.0, square = 0.0, neighbours = 0.0;
  for (const double each : blocks) mean += each / static_cast<double>(blocks.size());
  for (std::size_t i = 0; i + 1 < blocks.size(); ++i)
    square += std::pow(blocks[i] - mean, 2), neighbours += (blocks[i] - mean) * (blocks[i + 1] - mean);
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(blocks.size())), scatter.block_strength, 0.004);
  EXPECT_NEAR(neighbours / square, std::exp(-0.5), 0.04);
}

}  // namespace
}  // namespace apc::reliability
