/// The landing-gear drop of NACA TN 2755 / Report 1154, integrated with our strut law and CVODES wrapper. The deck's
/// numbers are recalled and its tire is a linear stand-in: the targets are self-converged values of another program.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "aircraft/strut.h"
#include "apc/base/units.h"
#include "apc/simulation/cvode.h"

namespace apc::simulation {
namespace {

using units::ft, units::lbf;

struct Drop {
  double peak_tire = 0.0, peak_time = 0.0, peak_stroke = 0.0, release = 0.0;
};

/// Discharge coefficient and polytropic exponent as varied in the report.
Drop drop(double discharge, double exponent, double rtol) {
  const double length = ft, force = lbf;
  const double g = 32.174 * length;
  const double w1 = 2411 * force, w2 = 131 * force, m1 = w1 / g, m2 = w2 / g;
  aircraft::Strut strut;
  const double pressure = force / (length * length);
  strut.piston_area = 0.05761 * length * length;
  strut.extended_pressure = 6264 * pressure;
  strut.extended_gas_volume = 0.03545 * length * length * length;
  strut.polytropic_exponent = exponent;
  strut.stroke = 10.0 * length;
  const double hydraulic = 0.04708 * length * length, orifice = 0.0005585 * length * length;
  const double rho = 1.61 * (force / length) / (length * length * length);  // lbf s²/ft⁴
  strut.damping_compression = strut.damping_rebound =
      rho * std::pow(hydraulic, 3) / (2.0 * std::pow(discharge * orifice, 2));
  const double k = 18500 * force / length;
  const double atmosphere = aircraft::atmospheric_pressure * strut.piston_area;
  // The report's gas force is p₀ A (…)ⁿ without the atmosphere; z₁ sprung, z₂ unsprung, downward; lift = weight.
  const auto strut_force = [&](double s, double v) {
    return aircraft::gas_force(strut, s) + atmosphere + aircraft::orifice_force(strut, v);
  };
  bool released = false;
  OdeProblem problem;
  problem.states = 4;
  problem.rate = [&](double, const double* y, double* dydt) {
    const double tire = k * y[1];
    dydt[0] = y[2], dydt[1] = y[3];
    if (!released) {
      dydt[2] = dydt[3] = -tire / (m1 + m2);
    } else {
      const double f = strut_force(y[0] - y[1], y[2] - y[3]);
      dydt[2] = -(f + w2) / m1;  // the lift carries both weights
      dydt[3] = (f + m2 * g - tire) / m2;
    }
  };
  problem.jacobian = [&](double t, const double* y, double* j) {
    double up[4], down[4], z[4];
    for (int c = 0; c < 4; ++c) {
      const double h = 1e-7 * length;
      std::copy(y, y + 4, z);
      z[c] = y[c] + h;
      problem.rate(t, z, up);
      z[c] = y[c] - h;
      problem.rate(t, z, down);
      for (int r = 0; r < 4; ++r) j[4 * r + c] = (up[r] - down[r]) / (2 * h);
    }
  };
  Cvode solver(problem, {rtol, std::vector<double>(4, rtol * 1e-2 * length), 1e-3});
  solver.start(0.0, {0.0, 0.0, 8.86 * length, 8.86 * length});
  const double release_load = (6264 * pressure * strut.piston_area + w2) * (w1 + w2) / w1;
  Drop result;
  std::vector<double> y(4);
  while (solver.time() < 0.25) {
    const double before = solver.time();
    solver.step();
    if (!released) {
      solver.state(solver.time(), y.data());
      if (k * y[1] >= release_load) {
        double low = before, high = solver.time();
        for (int i = 0; i < 60; ++i) {
          const double middle = 0.5 * (low + high);
          solver.state(middle, y.data());
          (k * y[1] < release_load ? low : high) = middle;
        }
        solver.state(high, y.data());
        released = true;
        result.release = high;
        solver.start(high, std::vector<double>(y));
      }
      continue;
    }
    for (int i = 1; i <= 20; ++i) {
      const double t = before + (solver.time() - before) * i / 20;
      solver.state(t, y.data());
      if (k * y[1] > result.peak_tire) result.peak_tire = k * y[1], result.peak_time = t;
      result.peak_stroke = std::max(result.peak_stroke, y[0] - y[1]);
    }
  }
  result.peak_tire /= force;
  result.peak_stroke /= length;
  return result;
}

TEST(StrutDrop, MatchesTheSelfConvergedDeck) {
  const auto base = drop(0.9, 1.12, 1e-9);
  std::printf("V4 drop: release %.4f ms, F_max %.3f lbf at %.5f s, s_max %.6f ft\n", 1e3 * base.release, base.peak_tire,
              base.peak_time, base.peak_stroke);
  EXPECT_NEAR(1e3 * base.release, 3.165, 0.002);
  EXPECT_NEAR(base.peak_tire, 6635.96, 1.0);
  EXPECT_NEAR(base.peak_stroke, 0.527061, 1e-4);
}

TEST(StrutDrop, PeakLoadDependsOnTheOrificeAndHardlyOnTheGas) {
  EXPECT_NEAR(drop(0.8, 1.12, 1e-9).peak_tire, 6978.0, 2.0);
  EXPECT_NEAR(drop(1.0, 1.12, 1e-9).peak_tire, 6316.0, 2.0);
  EXPECT_NEAR(drop(0.9, 1.0, 1e-9).peak_tire, 6630.0, 2.0);
  EXPECT_NEAR(drop(0.9, 1.3, 1e-9).peak_tire, 6645.0, 2.0);
}

}  // namespace
}  // namespace apc::simulation
