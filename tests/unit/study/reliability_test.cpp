#include "apc/study/reliability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../design/closed_form.h"

namespace apc::study {
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
  Store store;
  ReliabilityOptions options;
  options.samples = 400;
  const auto out = reliability(input, closed_form::solve, store, options);
  const auto critical = [](double mu) { return std::sqrt(200.0 * (0.5 + 20 * 0.4 + 9.80665 * mu)); };
  double exact = 0.0;
  for (int i = 0; i < 1000; ++i) exact += input.exit_speeds.below(critical(0.25 * (i + 0.5) / 1000)) / 1000;
  EXPECT_NEAR(out.arrest.value, exact, 2e-4);
  EXPECT_LE(out.arrest.low, exact + 1e-4);
  EXPECT_GE(out.arrest.high, exact - 1e-4);
  EXPECT_NEAR(out.arrest_speed_975, critical(0.25 * 0.025), 0.15);
  EXPECT_GT(out.arrest_indices[2].first, 0.95);  // braking
  EXPECT_LT(out.runs, 7 * 400);
}

TEST(Reliability, ContinuesFromItsStoreWithoutARun) {
  const auto input = braking_only();
  Store store;
  ReliabilityOptions options;
  options.samples = 200;
  const auto first = reliability(input, closed_form::solve, store, options);
  const auto second = reliability(input, closed_form::solve, store, options);
  EXPECT_GT(first.runs, 0);
  EXPECT_EQ(second.runs, 0);
  EXPECT_EQ(first.arrest.value, second.arrest.value);
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
}  // namespace apc::study
