/// How far the numbers of an overrun are from the solution of its own equations: energy, tolerance, solver, table,
/// modes.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "aircraft/static_stand.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

Overrun at(double knots, double braking = 0.0) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  overrun.braking = braking;
  return overrun;
}

Options with(double rtol, Method method = Method::reference) {
  Options options;
  options.rtol = rtol;
  options.method = method;
  options.sampling = 0.0;
  return options;
}

TEST(EnergyAccount, ClosesWithTheTolerance) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto model = testing::foam_model(name, testing::foam_bed(0.4572, 15.24, 600.0));
    std::printf("V5 energy residual %s:", name);
    for (const double rtol : {1e-4, 1e-6, 1e-8}) {
      const double residual = simulate(model, at(70, 0.25), with(rtol)).energy.at("residual");
      std::printf("  %.0e -> %.1e", rtol, residual);
      EXPECT_LT(residual, rtol == 1e-4 ? 1e-3 : rtol == 1e-6 ? 1e-5 : 1e-6) << name << " " << rtol;
    }
    const double fast = simulate(model, at(70, 0.25), with(1e-6, Method::fast)).energy.at("residual");
    std::printf("  fast %.1e\n", fast);
    EXPECT_LT(fast, 1e-4) << name;
  }
}

TEST(StopDistance, ConvergesWithTheTolerance) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  const double exact = simulate(model, at(70), with(1e-11)).stop_distance;
  // Least-squares slope of log error against log tolerance over four decades; below 1e-6 m the solution itself is the
  // floor.
  double slope = 0.0;
  std::printf("V8 stop distance 737, 70 kt, %.6f m:", exact);
  for (int decade = -2; decade <= 2; ++decade) {
    const double rtol = std::pow(10.0, decade - 7);
    const auto result = simulate(model, at(70), with(rtol));
    const double error = std::abs(result.stop_distance - exact);
    std::printf("  %.0e %.1e m (%ld steps)", rtol, error, result.solver.steps);
    slope += 0.1 * decade * std::log10(std::max(error, 1e-12));
    if (rtol < 2e-6) {
      EXPECT_LT(error, 1e-3);
    }
  }
  std::printf("  slope %.2f\n", slope);
  EXPECT_GE(slope, 0.75);
}

TEST(StopDistance, IsWithinAMillimetreAtTheDefaultToleranceForEveryAircraftAndMethod) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"})
    for (const double depth : {0.25, 0.4572}) {
      const auto model = testing::foam_model(name, testing::foam_bed(depth, 15.24, 900.0));
      const double exact = simulate(model, at(70, 0.25), with(1e-10)).stop_distance;
      const double reference = simulate(model, at(70, 0.25), with(1e-6)).stop_distance - exact;
      const double fast = simulate(model, at(70, 0.25), with(1e-6, Method::fast)).stop_distance - exact;
      std::printf("V9 %s %.2f m: reference %+.3f mm, fast %+.3f mm\n", name, depth, 1e3 * reference, 1e3 * fast);
      EXPECT_LT(std::abs(reference), 1e-3) << name;
      EXPECT_LT(std::abs(fast), 1e-3) << name;
    }
}

TEST(TableError, ShrinksWithTheNodes) {
  // The same closed-form ground, tabulated ever finer: the stop must settle.
  auto plane = testing::shipped_aircraft("B737-800");
  const auto stop = [&](int refine) {
    std::vector<loadtables::LoadTable> tables;
    for (const auto& [name, tire] : plane.tires) tables.push_back(testing::foam_table(tire, 50 * units::psi, refine));
    return simulate(make_model(plane, testing::foam_bed(0.4572), tables), at(70), with(1e-8)).stop_distance;
  };
  const double coarse = stop(1), middle = stop(2), fine = stop(4), finest = stop(8);
  std::printf("V10 table nodes 17x25, 33x49, 65x97 against 129x193: %+.4f %+.4f %+.4f m of %.4f m\n", coarse - finest,
              middle - finest, fine - finest, finest);
  EXPECT_LT(std::abs(fine - finest), std::abs(coarse - finest));
  EXPECT_LT(std::abs(fine - finest), 5e-3);
  EXPECT_LT(std::abs(coarse - finest), 0.01 * finest);
}

/// Frequencies (Hz) and damping ratios of the rigid-body modes on pavement, friction and damping taken out.
std::vector<double> frequencies(const std::string& name) {
  auto model = testing::foam_model(name, testing::pavement());
  for (auto& gear : model.aircraft.gears) {
    gear.strut.friction = gear.strut.bearing_friction = 0.0;
    gear.strut.damping_compression = gear.strut.damping_rebound = 0.0;
  }
  model.aircraft.aero = {};
  const auto overrun = at(30);
  const auto plant = make_plant(model, overrun);
  const auto y = trim(plant, 15.0).state;
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  const auto n = static_cast<int>(y.size()), m = plant.degrees();
  std::vector<double> rate(y.size()), matrix(y.size() * y.size());
  jacobian(plant, around, 0.0, y.data(), rate.data(), matrix.data());
  Eigen::MatrixXd a(2 * m, 2 * m);
  for (int i = 0; i < 2 * m; ++i)
    for (int j = 0; j < 2 * m; ++j) a(i, j) = matrix[static_cast<std::size_t>(i * n + j)];
  std::vector<double> found;
  const auto eigenvalues = a.eigenvalues();
  for (int i = 0; i < eigenvalues.size(); ++i)
    if (eigenvalues[i].imag() > 0.5) found.push_back(eigenvalues[i].imag() / (2 * std::numbers::pi));
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Modes, HeaveAndPitchMatchTheUncoupledFormula) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto plane = testing::shipped_aircraft(name);
    const auto stand = aircraft::static_stand(plane);
    double heave = 0.0, pitch = 0.0;
    for (std::size_t g = 0; g < plane.gears.size(); ++g) {
      const auto& gear = plane.gears[g];
      const auto& strut = gear.strut;
      const double length = strut.extended_gas_volume / strut.piston_area;
      const double gas = (stand.gears[g].strut_force + 101325.0 * strut.piston_area) * strut.polytropic_exponent /
                         (length - stand.gears[g].stroke);
      const double tire =
          plane.tires.at(gear.tire).load_curve.slope(stand.gears[g].tire_deflection) * gear.wheels() / gear.struts;
      const double series = gear.struts / (1.0 / gas + 1.0 / tire);
      heave += series;
      pitch += series * std::pow(gear.behind_nose_gear - plane.cg_behind_nose_gear, 2);
    }
    const double two_pi = 2 * std::numbers::pi;
    const double f_heave = std::sqrt(heave / plane.mass) / two_pi,
                 f_pitch = std::sqrt(pitch / plane.pitch_inertia) / two_pi;
    const auto modes = frequencies(name);
    ASSERT_GE(modes.size(), 2u) << name;
    const double low = std::min(f_heave, f_pitch), high = std::max(f_heave, f_pitch);
    std::printf("V7 modes %s: %.3f and %.3f Hz; uncoupled formula pitch %.3f, heave %.3f Hz\n", name, modes[0],
                modes[1], f_pitch, f_heave);
    EXPECT_NEAR(modes[0], low, 0.1 * low) << name;
    EXPECT_NEAR(modes[1], high, 0.1 * high) << name;
  }
}

TEST(Units, TheSameAircraftInPoundsAndFeetGivesTheSameBits) {
  // Conversion to SI happens in the reader: a deck in other units must land on the same numbers to rounding.
  const double kilograms = parse_quantity("146300 lb", dimension::mass),
               metres = parse_quantity("614.17322834645665 in", dimension::length);
  EXPECT_NEAR(kilograms / 66360.563731, 1.0, 1e-12);
  EXPECT_NEAR(metres / 15.6, 1.0, 1e-12);
  auto si = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  auto imperial = si;
  si.aircraft.mass = 66360.563731;
  imperial.aircraft.mass = kilograms;
  imperial.aircraft.gears[1].behind_nose_gear = metres;
  const double a = simulate(si, at(60), with(1e-8)).stop_distance,
               b = simulate(imperial, at(60), with(1e-8)).stop_distance;
  std::printf("V12 SI against pounds and feet: %.2e m\n", std::abs(a - b));
  EXPECT_NEAR(a, b, 1e-7 * a);
}

}  // namespace
}  // namespace apc::simulation
