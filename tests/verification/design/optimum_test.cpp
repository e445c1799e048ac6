/// Optima known in closed form: a₀ x + k ∫h dx = v²/2 at rest, nose drag q h (tests/unit/design/closed_form.h).
#include <gtest/gtest.h>

#include <random>

#include "apc/design/size_bed.h"
#include "tests/unit/design/closed_form.h"

namespace apc::design {
namespace {

constexpr double speed = 36.0, mass = 5e4, limit_depth = 0.35, shortest_ramp = 5.0;
constexpr double per_depth = closed_form::per_depth * 5e4 / mass;

Fleet fleet_of(std::vector<std::string> names) {
  Fleet fleet;
  fleet.name = "test";
  simulation::Overrun run;
  run.entry_speed = speed;
  for (const auto& name : names) fleet.cases.push_back({name, "case", run});
  fleet.limits.table_range = false;
  auto& bed = fleet.bed;
  bed.width = 45.0;
  bed.minimum_depth = 0.05, bed.maximum_depth = 0.8;
  bed.minimum_ramp = shortest_ramp, bed.maximum_ramp = 15.0;
  bed.maximum_slope = 0.5;
  bed.maximum_length = 300.0;
  bed.nodes = 4;
  bed.block_length = 1.2, bed.block_width = 1.2, bed.step = 0.01;
  return fleet;
}

Problem problem_of(Fleet fleet, std::vector<simulation::Model> models) {
  Problem problem;
  problem.fleet = std::move(fleet);
  problem.models = std::move(models);
  problem.solve = closed_form::solve;
  return problem;
}

Problem one_aircraft() { return problem_of(fleet_of({"only"}), {closed_form::model(mass, limit_depth)}); }

/// Two aircraft: a light one with a weak nose gear, a heavy one that rolls farther.
Problem two_aircraft() {
  return problem_of(fleet_of({"light", "heavy"}), {closed_form::model(3e4, 0.25), closed_form::model(1e5, 0.6)});
}

/// a₀ L + k h (L − r/2) = v²/2.
double length_at(double depth, double ramp) {
  return (0.5 * speed * speed + 0.5 * per_depth * depth * ramp) / (closed_form::base + per_depth * depth);
}

Aim length_aim(const Problem& problem, double reference) {
  Aim aim{Objective::length, reference, 0.0, {}, {}, 0.0, false};
  for (std::size_t k = 0; k < problem.fleet.cases.size(); ++k) aim.cases.push_back(k);
  return aim;
}

TEST(Optimum, OfOneAircraftIsTheDepthOfItsLimitBehindTheShortestRamp) {
  const auto problem = one_aircraft();
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  const double exact = length_at(limit_depth, shortest_ramp);
  for (const auto* each : {&design.certificate.first, &design.certificate.second}) {
    EXPECT_TRUE(each->feasible) << text(each->method);
    EXPECT_NEAR(each->objective * design.profile.reference, exact, 1e-3 * exact) << text(each->method);
  }
  EXPECT_TRUE(certified(design.certificate));
  EXPECT_LT(design.certificate.difference, 1e-3);
  EXPECT_LT(design.certificate.stationarity, 0.01);
}

TEST(Optimum, MultipliersAreTheDerivativesOfTheBestLength) {
  const auto problem = one_aircraft();
  study::Store store;
  Evaluator evaluator(problem, store);
  const double reference = 60.0;
  const auto program = make_program(evaluator, length_aim(problem, reference));
  const Profile best{shortest_ramp, reference, std::vector<double>(4, limit_depth)};
  const double length = length_at(limit_depth, shortest_ramp);
  Certificate certificate;
  examine(program, point_of(problem.fleet.bed, best, length / reference), {}, certificate);
  EXPECT_LT(certificate.stationarity, 1e-3);
  EXPECT_LT(certificate.gap, 1e-3);
  double drag = 0.0, stop = 0.0;
  for (const auto& active : certificate.active) {
    if (active.constraint.kind == Kind::drag) drag += active.multiplier;
    if (active.constraint.kind == Kind::stop) stop += active.multiplier;
  }
  // A limit higher by a share ε deepens the bed by the same share: Σ λ = −h dL/dh / reference.
  const double slope = (length_at(1.001 * limit_depth, shortest_ramp) - length_at(0.999 * limit_depth, shortest_ramp)) /
                       (0.002 * reference);
  EXPECT_NEAR(drag, -slope, 2e-3 * std::abs(slope));
  EXPECT_NEAR(stop, 1.0, 1e-6);
}

TEST(Optimum, ShortOfItTheConditionsFailAndNoCertificateIsGiven) {
  const auto problem = one_aircraft();
  study::Store store;
  Evaluator evaluator(problem, store);
  const double reference = 60.0;
  const auto program = make_program(evaluator, length_aim(problem, reference));
  const Profile shallow{shortest_ramp, reference, std::vector<double>(4, 0.9 * limit_depth)};
  Certificate certificate;
  certificate.agreed = true;  // two methods may agree and both be wrong
  examine(program, point_of(problem.fleet.bed, shallow, length_at(0.9 * limit_depth, shortest_ramp) / reference), {},
          certificate);
  EXPECT_GT(certificate.stationarity, 0.3);
  EXPECT_FALSE(certified(certificate));
}

TEST(Optimum, OfTwoAircraftIsBeatenByNoneOfManyRandomBeds) {
  const auto problem = two_aircraft();
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  EXPECT_TRUE(certified(design.certificate)) << design.certificate.difference << " " << design.certificate.stationarity;
  Evaluator evaluator(problem, store);
  const auto program = make_program(evaluator, length_aim(problem, design.profile.reference));
  const auto& best = design.certificate.first.z;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int feasible = 0;
  for (int i = 0; i < 3000; ++i) {
    Eigen::VectorXd z = best;
    const double reach =
        std::pow(10.0, -3.0 + 2.5 * (i % 100) / 100.0);  // from a hair's breadth to a third of the space
    for (Eigen::Index j = 0; j + 1 < z.size(); ++j)
      z[j] = std::clamp(z[j] + reach * normal(random), program.low[j], program.high[j]);
    // Its own length is the longest stop in it; judged like the optimum, by the same tolerance.
    const auto figures = evaluator.run({{profile_of(problem.fleet.bed, z, design.profile.reference), 1.0}}, {0, 1});
    z[z.size() - 1] = std::max(figures[0][0].distance, figures[0][1].distance) / design.profile.reference;
    const auto values = program.at(z);
    if (values.tail(values.size() - 1).maxCoeff() > 2e-4) continue;
    ++feasible;
    EXPECT_GT(values[0], design.certificate.first.objective * (1 - 1e-3)) << z.transpose();
  }
  EXPECT_GT(feasible, 100);
}

TEST(Optimum, TwoMethodsAgreeForEveryObjective) {
  for (const auto objective : {Objective::length, Objective::volume, Objective::minimax, Objective::speed}) {
    const auto problem = two_aircraft();
    study::Store store;
    SizeOptions options;
    options.objective = objective;
    if (objective == Objective::speed) options.length = 60.0;
    const auto design = size_bed(problem, store, options);
    ASSERT_TRUE(design.feasible) << text(objective) << ": " << design.reason;
    EXPECT_TRUE(design.certificate.agreed) << text(objective);
    EXPECT_LT(design.certificate.difference, 5e-3) << text(objective);
    EXPECT_LT(design.certificate.stationarity, 0.05) << text(objective);
    EXPECT_LE(design.built.worst_use, 1.0) << text(objective);
  }
}

TEST(Optimum, OfVolumeIsSmallerAndLongerThanThatOfLength) {
  const auto problem = two_aircraft();
  study::Store store;
  SizeOptions least;
  least.objective = Objective::volume;
  const auto by_length = size_bed(problem, store), by_volume = size_bed(problem, store, least);
  EXPECT_GE(by_volume.length, by_length.length * (1 - 1e-3));
  EXPECT_LE(by_volume.profile.section(by_volume.length), by_length.profile.section(by_length.length) * (1 + 1e-3));
}

TEST(Optimum, AnUltimateCriterionAllowsHalfAsMuchDepthAgain) {
  auto problem = one_aircraft();
  problem.fleet.limits.criterion = Criterion::ultimate;
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  const double exact = length_at(1.5 * limit_depth, shortest_ramp);
  EXPECT_NEAR(design.length, exact, 1e-3 * exact);
}

TEST(Optimum, KeepsTheSteepestSlope) {
  auto problem = one_aircraft();
  problem.fleet.bed.maximum_slope = 0.03;  // 0.35 m of depth then need a ramp of 11.7 m
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  for (const double use : slope_use(problem.fleet.bed, design.profile)) EXPECT_LE(use, 1.0 + 1e-3);
  EXPECT_LE(slope_use(problem.fleet.bed, design.built.blocks), 1.0);
  EXPECT_LT(design.profile.ramp, 12.0);
  const auto& active = design.certificate.active;
  EXPECT_TRUE(std::any_of(active.begin(), active.end(), [](const Active& each) {
    return each.constraint.kind == Kind::slope && each.constraint.what == "slope of the ramp";
  }));
}

}  // namespace
}  // namespace apc::design
