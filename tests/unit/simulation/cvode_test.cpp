#include "apc/simulation/cvode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"

namespace apc::simulation {
namespace {

OdeProblem oscillator() {
  OdeProblem problem;
  problem.states = 2;
  problem.rate = [](double, const double* y, double* dydt) { dydt[0] = y[1], dydt[1] = -9.0 * y[0]; };
  problem.jacobian = [](double, const double*, double* j) { j[0] = 0.0, j[1] = 1.0, j[2] = -9.0, j[3] = 0.0; };
  return problem;
}

TEST(Cvode, FollowsAnOscillatorAndItsQuadrature) {
  auto problem = oscillator();
  problem.quadratures = 1;
  problem.integrand = [](double, const double* y, double* q) { q[0] = y[1]; };
  Cvode solver(problem, {1e-10, {1e-12, 1e-12}, 0.0});
  solver.start(0.0, {1.0, 0.0});
  while (solver.time() < 2.0) solver.step();
  double y[2], q[1];
  solver.state(2.0, y);
  solver.integrals(2.0, q);
  EXPECT_NEAR(y[0], std::cos(6.0), 1e-7);
  EXPECT_NEAR(q[0], y[0] - 1.0, 1e-7);
}

TEST(Cvode, EndsAStepWhereItIsTold) {
  Cvode solver(oscillator(), {1e-6, {1e-8, 1e-8}, 0.0});
  solver.start(0.0, {1.0, 0.0});
  while (solver.time() < 0.5) {
    solver.stop_at(0.5);
    solver.step();
    EXPECT_LE(solver.time(), 0.5);
  }
  double y[2];
  solver.state(0.5, y);
  EXPECT_NEAR(y[0], std::cos(1.5), 1e-4);
  solver.stop_at(INFINITY);
  while (solver.time() < 2.0) solver.step();
  solver.state(2.0, y);
  EXPECT_NEAR(y[0], std::cos(6.0), 1e-3);
}

TEST(Cvode, CarriesSensitivitiesInsideItsErrorControl) {
  auto problem = oscillator();
  problem.parameters = 1;  // initial position
  problem.sensitivity = [](double, const double*, int, const double* s, double* ds) {
    ds[0] = s[1], ds[1] = -9.0 * s[0];
  };
  Cvode solver(problem, {1e-9, {1e-11, 1e-11}, 0.0});
  solver.start(0.0, {2.0, 0.0}, {}, {1.0, 0.0});
  while (solver.time() < 1.0) solver.step();
  double s[2];
  solver.sensitivities(1.0, s);
  EXPECT_NEAR(s[0], std::cos(3.0), 1e-6);
}

TEST(Cvode, RethrowsWhatACallbackThrows) {
  auto problem = oscillator();
  problem.rate = [](double t, const double* y, double* dydt) {
    if (t > 0.1) throw InputError("the ground is missing");
    dydt[0] = y[1], dydt[1] = -9.0 * y[0];
  };
  Cvode solver(problem, {1e-6, {1e-8, 1e-8}, 0.0});
  solver.start(0.0, {1.0, 0.0});
  EXPECT_THROW(while (solver.time() < 1.0) solver.step(), InputError);
}

TEST(Cvode, GivesUpWithTimeStateAndAdvice) {
  OdeProblem problem;
  problem.states = 1;
  problem.rate = [](double t, const double*, double* dydt) { dydt[0] = std::sqrt(1.0 - t); };  // nothing beyond t = 1
  problem.jacobian = [](double, const double*, double* j) { j[0] = 0.0; };
  problem.describe = [](const double* y) { return "height " + std::to_string(y[0]) + " m"; };
  Cvode solver(problem, {1e-8, {1e-10}, 0.0});
  solver.start(0.0, {1.0});
  try {
    for (int i = 0; i < 100000; ++i) solver.step();
    ADD_FAILURE() << "no error";
  } catch (const SolveError& error) {
    EXPECT_NEAR(error.time, 1.0, 1e-3);
    EXPECT_NE(std::string(error.what()).find("at t = "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("height 1.6"), std::string::npos) << error.what();  // 1 + 2/3
    EXPECT_NE(std::string(error.what()).find("Try a looser tolerance"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace apc::simulation
