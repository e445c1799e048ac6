/// The gradients a search rests on: against the derivative of a closed form, with the order of the error, and for a
/// real aircraft in the shipped tables against sensitivities carried along the run by another integrator.
#include <gtest/gtest.h>

#include "apc/base/units.h"
#include "apc/design/gradient_check.h"
#include "loadtables/find_tables.h"
#include "tests/support/simulation_models.h"
#include "tests/unit/design/closed_form.h"

namespace apc::design {
namespace {

BedSpace space() {
  BedSpace bed;
  bed.material = "foam_50psi";
  bed.width = 45.0;
  bed.minimum_depth = 0.1, bed.maximum_depth = 0.7;
  bed.minimum_ramp = 8.0, bed.maximum_ramp = 22.0;
  bed.maximum_length = 300.0;
  bed.nodes = 4;
  bed.block_length = bed.block_width = 1.2, bed.step = 0.01;
  return bed;
}

Problem problem_of(simulation::Model model, double speed, study::Solve solve) {
  Problem problem;
  simulation::Overrun run;
  run.entry_speed = speed, run.braking = 0.0;
  problem.fleet.bed = space();
  problem.fleet.cases = {{model.aircraft.name, "case", run}};
  problem.fleet.limits.table_range = false;
  problem.models = {std::move(model)};
  problem.solve = std::move(solve);
  return problem;
}

Aim aim_of(double reference) { return {Objective::length, reference, 0.0, {0}, {}, 0.0, false}; }

TEST(Gradient, OfTheClosedFormsStopIsRightAndItsErrorFallsWithTheStep) {
  const auto problem = problem_of(closed_form::model(5e4, 0.35), 36.0, closed_form::solve);
  study::Store store;
  Evaluator evaluator(problem, store);
  const double reference = 160.0;
  const auto program = make_program(evaluator, aim_of(reference));
  const Profile profile{12.0, reference, {0.25, 0.3, 0.3, 0.35}};
  const auto z = point_of(problem.fleet.bed, profile, 1.0);
  const double x = evaluator.run({{profile, 1.0}}, {0}).front().front().distance;
  // a₀ x + k A(x) = v²/2: dx/dh_j = −k ∂A/∂h_j / (a₀ + k h(x)). Node 2's hat lies wholly before the stop.
  const auto at = profile.stations();
  ASSERT_GT(x, at[2]);
  ASSERT_LT(x, at[3]);  // on a slope: the stop then bends with the depth
  const double hat = 0.5 * (at[2] - at[0]);
  const double exact = -closed_form::per_depth * hat /
                       (closed_form::base + closed_form::per_depth * profile.depth_at(x)) *
                       (problem.fleet.bed.maximum_depth - problem.fleet.bed.minimum_depth) / reference;
  const Eigen::Index row = 1, node = 2;  // the stop comes first; z = ramp, nodes 1 to 4, length
  ASSERT_EQ(program.constraints[0].kind, Kind::stop);
  const auto error = [&](double step, Differences kind) {
    return std::abs(jacobian(program, z, step, kind)(row, node) - exact) / std::abs(exact);
  };
  const double wide = error(4e-3, Differences::forward), narrow = error(1e-3, Differences::forward);
  EXPECT_LT(narrow, 2e-3);
  EXPECT_NEAR(wide / narrow, 4.0, 0.4);  // first order
  EXPECT_LT(error(1e-3, Differences::central), 0.05 * narrow);
}

TEST(Gradient, OfAnAircraftInFoamAgreesWithSensitivitiesCarriedAlongTheRun) {
  auto plane = testing::shipped_aircraft("CRJ-200");
  std::vector<loadtables::LoadTable> tables;
  for (const auto& gear : plane.gears)
    tables.push_back(loadtables::find_table(shipped("loadtables/data"), "foam_50psi",
                                            simulation::table_tire(plane.tires.at(gear.tire))));
  bed::Bed site;
  site.material = "foam_50psi", site.width = 45.0, site.distance = {0.0, 100.0}, site.depth = {0.3, 0.3};
  auto problem = problem_of(simulation::make_model(plane, site, tables), 70 * units::kt, simulation::simulate);
  problem.sensitivity = simulation::sensitivity;
  problem.solver.rtol = 1e-8;
  study::Store store;
  Evaluator evaluator(problem, store);
  const auto aim = aim_of(150.0);
  const auto program = make_program(evaluator, aim);
  const Profile profile{20.0, 150.0, {0.24, 0.26, 0.30, 0.34}};
  const double stop = evaluator.run({{profile, 1.0}}, {0}).front().front().distance;
  const auto z = point_of(problem.fleet.bed, profile, stop / 150.0);
  // Every constraint that sensitivities tell the gradient of, as if it held the design.
  Certificate all;
  for (const auto& each : program.constraints) all.active.push_back({each, 1.0, 1.0, 1.0});
  const double difference = sensitivity_difference(evaluator, aim, program, z, all, {});
  EXPECT_LT(difference, 0.01);
  EXPECT_GT(difference, 0.0);
}

}  // namespace
}  // namespace apc::design
