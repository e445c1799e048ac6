/// How far the numbers of an overrun are from the solution of its own equations: energy, tolerance, solver, table,
/// modes.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

#include "aircraft/static_stand.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"
#include "tests/support/shipped_models.h"

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
  // One run's error changes sign on its way down; the root mean square over eight entry speeds does not hide that.
  // Least-squares slope of its logarithm against the tolerance's, over four decades.
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  for (const auto method : {Method::reference, Method::fast}) {
    double slope = 0.0;
    std::printf("V8 stop distance 737, 52 to 80 kt, rms error, %s:", method == Method::fast ? "fast" : "reference");
    std::array<double, 5> squares{};
    for (double knots = 52.0; knots <= 80.0; knots += 4.0) {
      const double exact = simulate(model, at(knots), with(1e-11)).stop_distance;
      for (std::size_t decade = 0; decade < squares.size(); ++decade) {
        const double rtol = std::pow(10.0, -5.0 - static_cast<double>(decade));
        squares[decade] += std::pow(simulate(model, at(knots), with(rtol, method)).stop_distance - exact, 2) / 8.0;
      }
    }
    for (std::size_t decade = 0; decade < squares.size(); ++decade) {
      const double error = std::sqrt(squares[decade]);
      std::printf("  1e-%zu %.1e m", decade + 5, error);
      slope += 0.1 * (2.0 - static_cast<double>(decade)) * std::log10(error);
      if (decade >= 1) {
        EXPECT_LT(error, 1e-3);
      }
    }
    std::printf("  slope %.2f\n", slope);
    EXPECT_GE(slope, 0.8);
  }
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

TEST(StopDistance, OfTheFastPathIsWithinAMillimetreOnEveryShippedBedAtEverySpeed) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    double worst = 0.0, squares = 0.0;
    int runs = 0;
    for (const auto* bed : {"emas_14in_50psi", "emas_18in_50psi", "emas_18in_50psi_raised", "emas_24in_50psi"}) {
      const auto model = testing::shipped_model(name, bed);
      for (double knots = 30.0; knots <= 80.0; knots += 10.0)
        for (const double braking : {0.0, 0.25}) {
          const auto overrun = at(knots, braking);
          const double exact = simulate(model, overrun, with(1e-9)).stop_distance;
          const double error = std::abs(simulate(model, overrun, with(1e-6, Method::fast)).stop_distance - exact);
          ++runs;
          worst = std::max(worst, error);
          squares += error * error;
          EXPECT_LT(error, 1e-3) << name << " " << bed << " " << knots << " kt, braked " << braking << ", stop "
                                 << exact;
        }
    }
    std::printf("V9 %s: %d runs against CVODE at 1e-9, worst %.2f mm, rms %.2f mm\n", name, runs, 1e3 * worst,
                1e3 * std::sqrt(squares / runs));
  }
}

/// What bounces most: bogies that climb the raised bed's ramp and meet their own ruts behind its corner.
TEST(StopDistance, WhereBogiesBounceInTheirRutsBothMethodsConvergeToTheSame) {
  const auto model = testing::shipped_model("B747-400", "emas_18in_50psi_raised");
  for (const auto& overrun : {at(70), at(80), at(80, 0.25)}) {
    const double exact = simulate(model, overrun, with(1e-10)).stop_distance;
    std::printf("V9 raised, %.0f kt braked %.2f, %.3f m; reference:", overrun.entry_speed / units::kt, overrun.braking,
                exact);
    // Errors grow on the way by the factor below, so one run's may change sign; each has to keep its decade.
    for (const double rtol : {1e-7, 1e-8, 1e-9}) {
      const double reference = simulate(model, overrun, with(rtol)).stop_distance - exact;
      const double fast = simulate(model, overrun, with(rtol, Method::fast)).stop_distance - exact;
      std::printf("  %.0e: %+.4f, fast %+.4f mm", rtol, 1e3 * reference, 1e3 * fast);
      const double allowed = rtol > 5e-8 ? 0.5e-3 : rtol > 5e-9 ? 1e-4 : 3e-5;
      EXPECT_LT(std::abs(reference), allowed) << rtol;
      EXPECT_LT(std::abs(fast), allowed) << rtol;
    }
    std::printf("\n");
  }
}

TEST(StopDistance, MovesInProportionWithASmallChangeOfTheEntry) {
  // No chaos in the raised bed either: its stop answers like the level bed's, and in proportion over two decades.
  for (const auto* bed : {"emas_18in_50psi", "emas_18in_50psi_raised"}) {
    const auto model = testing::shipped_model("B747-400", bed);
    const auto options = with(1e-10, Method::fast);
    const auto stop = [&](double faster) {
      auto overrun = at(70);
      overrun.entry_speed += faster;
      return simulate(model, overrun, options).stop_distance;
    };
    const double base = stop(0.0);
    std::printf("V9 %s: metres of stop per m/s of entry:", bed);
    double first = 0.0;
    for (const double faster : {1e-4, 1e-5, 1e-6}) {
      const double gain = (stop(faster) - base) / faster;
      std::printf("  %.0e m/s %.3f", faster, gain);
      if (first == 0.0) first = gain;
      EXPECT_NEAR(gain, first, 0.1 * std::abs(first)) << bed << " " << faster;
    }
    std::printf("\n");
  }
}

TEST(NarrowPieces, OfABedAreFeltByBothMethods) {
  // A rib of 20 mm on the base, a third of a millisecond at 60 kt: the reference's steps used to pass over it.
  const auto bed = [](double height) {
    auto ribbed = testing::foam_bed(0.4572, 15.24, 400.0);
    ribbed.distance = {0.0, 15.24, 30.0, 30.01, 30.02, 400.0};
    ribbed.depth = {0.0, 0.4572, 0.4572, 0.4572 - height, 0.4572, 0.4572};
    return ribbed;
  };
  const auto run = [&](double height, double rtol, Method method) {
    return simulate(testing::foam_model("B737-800", bed(height)), at(60), with(rtol, method));
  };
  const auto plain = run(0.0, 1e-9, Method::reference);
  const auto exact = run(0.3, 1e-9, Method::reference);
  const auto reference = run(0.3, 1e-6, Method::reference), fast = run(0.3, 1e-6, Method::fast);
  std::printf(
      "rib of 20 mm: stop %+.2f mm; reference %+.3f, fast %+.3f mm of that; nose vertical %.0f -> %.0f, %.0f, %.0f N\n",
      1e3 * (exact.stop_distance - plain.stop_distance), 1e3 * (reference.stop_distance - exact.stop_distance),
      1e3 * (fast.stop_distance - exact.stop_distance), plain.gears[0].peak_vertical, exact.gears[0].peak_vertical,
      reference.gears[0].peak_vertical, fast.gears[0].peak_vertical);
  EXPECT_GT(exact.gears[0].peak_vertical, 1.2 * plain.gears[0].peak_vertical);
  auto seen = with(1e-6);  // with a history: instants of a grid, between which the rib comes and goes
  seen.sampling = 0.005;
  const auto model = testing::foam_model("B737-800", bed(0.3));
  const auto seen_reference = simulate(model, at(60), seen);
  seen.method = Method::fast;
  for (const auto& each : {reference, fast, seen_reference, simulate(model, at(60), seen)}) {
    EXPECT_NEAR(each.stop_distance, exact.stop_distance, 1e-3);
    EXPECT_NEAR(each.gears[0].peak_vertical, exact.gears[0].peak_vertical, 0.02 * exact.gears[0].peak_vertical);
  }
}

/// On pavement with friction and damping taken out, so that a disturbance rings on.
Model ringing_model(const std::string& name) {
  auto model = testing::foam_model(name, testing::pavement());
  for (auto& gear : model.aircraft.gears) {
    gear.strut.friction = gear.strut.bearing_friction = 0.0;
    gear.strut.damping_compression = gear.strut.damping_rebound = 0.0;
  }
  model.aircraft.aero = {};
  return model;
}

enum class Wheels { leave_out, spin_along };

/// Frequencies (Hz) of its rigid-body modes: eigenvalues of the Jacobian. Wheels that spin along add their inertia to
/// the fore-and-aft part of a mode.
std::vector<double> frequencies(const std::string& name, Wheels wheels) {
  const auto model = ringing_model(name);
  const auto overrun = at(30);
  const auto plant = make_plant(model, overrun);
  const auto y = trim(plant, 30.0).state;
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  const auto n = static_cast<int>(y.size()), m = plant.degrees();
  std::vector<double> rate(y.size()), matrix(y.size() * y.size());
  jacobian(plant, around, 0.0, y.data(), rate.data(), matrix.data());
  const int size = wheels == Wheels::spin_along ? n : 2 * m;
  Eigen::MatrixXd a(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) a(i, j) = matrix[static_cast<std::size_t>(i * n + j)];
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
    const auto modes = frequencies(name, Wheels::leave_out);
    ASSERT_GE(modes.size(), 2u) << name;
    const double low = std::min(f_heave, f_pitch), high = std::max(f_heave, f_pitch);
    std::printf("V7 modes %s: %.3f and %.3f Hz; uncoupled formula pitch %.3f, heave %.3f Hz\n", name, modes[0],
                modes[1], f_pitch, f_heave);
    EXPECT_NEAR(modes[0], low, 0.1 * low) << name;
    EXPECT_NEAR(modes[1], high, 0.1 * high) << name;
  }
}

TEST(Modes, AMillimetreOfFreeDecayRingsAtTheEigenvalues) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto model = ringing_model(name);
    const auto overrun = at(60);
    const auto plant = make_plant(model, overrun);
    Surroundings around;
    around.ruts.resize(plant.rows.size());
    // Half a minute by Runge–Kutta 4: the height of a point ahead of the centre of gravity sees heave and pitch.
    constexpr double dt = 2.5e-4, duration = 30.0;
    auto y = trim(plant, 30.0).state;
    y[1] += 1e-3;
    const std::size_t states = y.size();
    std::vector<double> k1(states), k2(states), k3(states), k4(states), at_stage(states), signal;
    const auto stage = [&](const std::vector<double>& k, double h) {
      for (std::size_t i = 0; i < states; ++i) at_stage[i] = y[i] + h * k[i];
      return at_stage.data();
    };
    for (int i = 0; i < static_cast<int>(duration / dt); ++i) {
      if (i % 40 == 0) signal.push_back(y[1] + 5.0 * y[2]);
      derivatives(plant, around, 0.0, y.data(), k1.data());
      derivatives(plant, around, 0.0, stage(k1, 0.5 * dt), k2.data());
      derivatives(plant, around, 0.0, stage(k2, 0.5 * dt), k3.data());
      derivatives(plant, around, 0.0, stage(k3, dt), k4.data());
      for (std::size_t j = 0; j < states; ++j) y[j] += dt / 6.0 * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j]);
    }
    double mean = 0.0;
    for (const double each : signal) mean += each / static_cast<double>(signal.size());
    // Fourier sums under a Hann window on a fine grid of frequencies; their peaks near the eigenvalues.
    const auto amplitude = [&](double frequency) {
      std::complex<double> sum = 0.0;
      for (std::size_t i = 0; i < signal.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(signal.size()), t = share * duration;
        sum += (signal[i] - mean) * (1.0 - std::cos(2 * std::numbers::pi * share)) *
               std::polar(1.0, -2 * std::numbers::pi * frequency * t);
      }
      return std::abs(sum);
    };
    const auto modes = frequencies(name, Wheels::spin_along);
    for (std::size_t k = 0; k < 2; ++k) {
      double found = 0.0, largest = 0.0;
      for (double f = 0.9 * modes[k]; f < 1.1 * modes[k]; f += 2e-4)
        if (const double a = amplitude(f); a > largest) largest = a, found = f;
      std::printf("V7 free decay %s: %.4f Hz, eigenvalue %.4f Hz (%+.2f %%)\n", name, found, modes[k],
                  100.0 * (found / modes[k] - 1.0));
      EXPECT_NEAR(found, modes[k], 0.005 * modes[k]) << name;
    }
  }
}

}  // namespace
}  // namespace apc::simulation
