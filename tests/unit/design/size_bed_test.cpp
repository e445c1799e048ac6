/// Sizing against problems whose optimum is known in closed form.
#include "apc/design/size_bed.h"

#include <gtest/gtest.h>

#include "closed_form.h"

namespace apc::design {
namespace {

Fleet one_aircraft(double speed) {
  Fleet fleet;
  fleet.name = "test";
  simulation::Overrun run;
  run.entry_speed = speed;
  fleet.cases = {{"light", "only case", run}};
  fleet.limits.table_range = false;
  auto& bed = fleet.bed;
  bed.width = 45.0;
  bed.minimum_depth = 0.05, bed.maximum_depth = 0.8;
  bed.minimum_ramp = 5.0, bed.maximum_ramp = 15.0;
  bed.maximum_slope = 0.5;
  bed.maximum_length = 300.0;
  bed.nodes = 4;
  bed.block_length = 1.2, bed.block_width = 1.2, bed.step = 0.01;
  return fleet;
}

Problem problem_of(const Fleet& fleet, std::vector<simulation::Model> models) {
  Problem problem;
  problem.fleet = fleet;
  problem.models = std::move(models);
  problem.solve = closed_form::solve;
  return problem;
}

/// a₀ L + k h (L − r/2) = v²/2: constant depth h behind a ramp of length r.
double length_of_constant_bed(double speed, double mass, double depth, double ramp) {
  const double k = closed_form::per_depth * 5e4 / mass;
  return (0.5 * speed * speed + 0.5 * k * depth * ramp) / (closed_form::base + k * depth);
}

TEST(SizeBed, OneAircraftGetsTheDepthOfItsLimitBehindTheShortestRamp) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.35)});
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  const double exact = length_of_constant_bed(36.0, 5e4, 0.35, 5.0);
  EXPECT_NEAR(design.length, exact, 2e-3 * exact);
  EXPECT_NEAR(design.profile.ramp, 5.0, 0.1);
  for (const double depth : design.profile.depth) EXPECT_NEAR(depth, 0.35, 2e-3);
  EXPECT_TRUE(design.certificate.agreed);
  EXPECT_LT(design.certificate.difference, 5e-3);
  EXPECT_LT(design.certificate.stationarity, 0.05);
  EXPECT_LT(design.certificate.gradient_error, 0.05);
}

TEST(SizeBed, TheActiveConstraintIsNamed) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.35)});
  study::Store store;
  const auto design = size_bed(problem, store);
  std::string names;
  for (const auto& active : design.certificate.active) names += describe(active.constraint, problem.fleet) + "\n";
  EXPECT_NE(names.find("light, only case: nose gear drag"), std::string::npos) << names;
}

TEST(SizeBed, ABuiltBedKeepsEveryLimitAndIsWholeBlocksLong) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.355)});
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible);
  EXPECT_LE(design.built.worst_use, 1.0);
  EXPECT_GE(design.built.bed.length(), design.length);
  EXPECT_LT(design.built.bed.length(), 1.05 * design.length);
  const double rows = design.built.bed.length() / 1.2;
  EXPECT_NEAR(rows, std::round(rows), 1e-9);
  for (const double depth : design.built.blocks.depth) EXPECT_NEAR(depth / 0.01, std::round(depth / 0.01), 1e-9);
  EXPECT_GE(design.cases[0].max_exit_speed, 36.0);
}

TEST(SizeBed, DeepensBeyondTheReachOfTheAircraftWithTheLowerLimit) {
  auto fleet = one_aircraft(36.0);
  fleet.cases.push_back(fleet.cases[0]);
  fleet.cases[1].aircraft = "heavy";
  const auto problem = problem_of(fleet, {closed_form::model(3e4, 0.25), closed_form::model(1e5, 0.6)});
  study::Store store;
  const auto design = size_bed(problem, store);
  ASSERT_TRUE(design.feasible) << design.reason;
  EXPECT_GT(design.profile.depth.back(), 0.3);  // beyond the light one's stop only the heavy one rolls
  EXPECT_LE(design.profile.depth.front(), 0.251);
  EXPECT_LT(design.length, 0.98 * design.uniform.length);
  EXPECT_LT(design.certificate.difference, 5e-3);
}

TEST(SizeBed, SaysWhichLimitForbidsEveryBed) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.02)});  // below the smallest depth
  study::Store store;
  const auto design = size_bed(problem, store);
  EXPECT_FALSE(design.feasible);
  EXPECT_NE(design.reason.find("light, only case: nose gear drag"), std::string::npos) << design.reason;
}

TEST(SizeBed, SaysThatTheSpaceIsTooShort) {
  auto fleet = one_aircraft(36.0);
  fleet.bed.maximum_length = 60.0;
  const auto problem = problem_of(fleet, {closed_form::model(5e4, 0.35)});
  study::Store store;
  const auto design = size_bed(problem, store);
  EXPECT_FALSE(design.feasible);
  EXPECT_NE(design.reason.find("longer than the space allows"), std::string::npos) << design.reason;
  EXPECT_NE(design.reason.find("nose gear drag"), std::string::npos) << design.reason;
}

TEST(SizeBed, StartedAgainItRepeatsNoRun) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.35)});
  study::Store store;
  const auto first = size_bed(problem, store), second = size_bed(problem, store);
  EXPECT_GT(first.runs, 50);
  EXPECT_EQ(second.runs, 0);
  EXPECT_EQ(first.length, second.length);
  EXPECT_EQ(first.profile.depth, second.profile.depth);
}

TEST(SizeBed, HighestSpeedInAGivenLengthIsTheSpeedItsShortestBedWasSizedFor) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.35)});
  study::Store store;
  const double length = length_of_constant_bed(30.0, 5e4, 0.35, 5.0);
  SizeOptions options;
  options.objective = Objective::speed, options.length = length;
  const auto design = size_bed(problem, store, options);
  EXPECT_NEAR(design.speed_factor * 36.0, 30.0, 0.1);
}

TEST(SizeBed, MinimaxIsOneForASingleAircraft) {
  const auto problem = problem_of(one_aircraft(36.0), {closed_form::model(5e4, 0.35)});
  study::Store store;
  SizeOptions options;
  options.objective = Objective::minimax;
  const auto design = size_bed(problem, store, options);
  EXPECT_NEAR(design.certificate.first.objective, 1.0, 5e-3);
}

TEST(NonNegativeLeastSquares, LeavesOutTheColumnThatWouldGoNegative) {
  Eigen::MatrixXd A(3, 2);
  A << 1, 1, 0, 1, 0, 0;
  const auto x = non_negative_least_squares(A, Eigen::Vector3d(2, -1, 0));
  EXPECT_NEAR(x[0], 2.0, 1e-6);
  EXPECT_EQ(x[1], 0.0);
}

}  // namespace
}  // namespace apc::design
