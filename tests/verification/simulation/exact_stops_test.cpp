/// Stops with solutions in closed form, run through the real simulation on tables that hold the law exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "apc/simulation/trim.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

constexpr double speed = 70 * units::kt;

/// A 737 on pavement with `law(per-wheel share)`; no aerodynamics, wheels without effort.
Result stop(const testing::AffineLaw& law, double drag_coefficient = 0.0, double mass = 0.0) {
  auto plane = testing::shipped_aircraft("B737-800");
  plane.aero = {124.6, drag_coefficient, 0.0, 0.0};
  auto model = testing::exact_model(plane, law);
  Overrun overrun;
  overrun.entry_speed = speed;
  overrun.mass = mass;
  overrun.wheel_spin = WheelSpin::free;
  Options options;
  options.rtol = 1e-11;
  return simulate(model, overrun, options);
}

/// The way of the centre of gravity: the nose wheel turns about it with the pitch, which a changing drag changes.
double cg_way(const Result& result) {
  const auto plane = testing::shipped_aircraft("B737-800");
  const auto& history = result.history;
  std::size_t entry = 0;
  while (history.time[entry] < -1e-9) ++entry;
  const double ahead = plane.cg_behind_nose_gear, below = plane.cg_height - plane.tires.at("H27x7.7-15").radius();
  const auto offset = [&](double pitch) { return ahead * std::cos(pitch) + below * std::sin(pitch); };
  return result.stop_distance - (offset(history.pitch.back()) - offset(history.pitch[entry]));
}

/// Linear springs, so that the sum of the vertical loads is the weight exactly.
constexpr double spring = 3e6;  // N/m per tire

TEST(ExactStop, ConstantDrag) {
  const double mass = testing::shipped_aircraft("B737-800").mass, each = 0.3 * units::g0 * mass / 6.0;
  const auto result = stop([&](double, double p) { return TireLoad{each, spring * p}; });
  std::printf("V1 constant drag: %.7f m, error %.2e\n", result.stop_distance, result.stop_distance / 220.39469 - 1.0);
  EXPECT_NEAR(result.stop_distance, speed * speed / (2 * 0.3 * units::g0), 2e-8 * 220.0);
  EXPECT_NEAR(result.stop_distance, 220.39469, 1e-5);
  // The aircraft still rocks while the drag fades in the last 0.02 s.
  EXPECT_NEAR(result.stop_time, 12.24037, 3e-4);
}

TEST(ExactStop, CoulombFrictionAndSquareDrag) {
  const double mass = 66000.0, friction = 0.25 * mass * units::g0, K = 0.5 * 1.225 * 124.6 * 0.11;
  const auto result = stop([&](double, double p) { return TireLoad{0.25 * spring * p, spring * p}; }, 0.11, mass);
  const double exact = mass / (2 * K) * std::log(1 + K * speed * speed / friction);
  std::printf("V2 Coulomb + square: %.6f m, exact %.6f, error %.2e\n", result.stop_distance, exact,
              result.stop_distance / exact - 1.0);
  EXPECT_NEAR(exact, 255.95669, 1e-5);
  EXPECT_NEAR(result.stop_distance, exact, 1e-6 * exact);
  EXPECT_NEAR(result.stop_time, 14.37172, 3e-4);
  // DeLoach's drag reduction factor of the same stop.
  const double r = K * speed * speed / friction;
  EXPECT_NEAR(result.stop_distance / (speed * speed / (2 * friction / mass)), std::log(1 + r) / r, 1e-6);
}

TEST(ExactStop, CoulombFrictionAndLinearDrag) {
  const double mass = 66000.0, friction = 0.25 * mass * units::g0, k = 2000.0;
  const auto result = stop(
      [&](double v, double p) {
        return TireLoad{0.25 * spring * p + k * v / 6.0, spring * p};
      },
      0.0, mass);
  const double exact = mass / k * (speed - friction / k * std::log(1 + k * speed / friction));
  std::printf("V3 Coulomb + linear: %.6f m, exact %.6f, error %.2e\n", cg_way(result), exact,
              cg_way(result) / exact - 1.0);
  EXPECT_NEAR(exact, 205.37324, 1e-5);
  EXPECT_NEAR(cg_way(result), exact, 2e-6 * exact);
}

}  // namespace
}  // namespace apc::simulation
