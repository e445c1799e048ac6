#include "aircraft/strut.h"

#include <gtest/gtest.h>

#include "apc/base/units.h"

namespace apc::aircraft {
namespace {

Strut example() {
  Strut strut;
  strut.stroke = 0.30;
  strut.piston_area = 0.0105;
  strut.extended_pressure = 2.25e6;
  strut.extended_gas_volume = 0.00335;
  strut.polytropic_exponent = 1.1;
  strut.damping_compression = 2.8e5;
  strut.damping_rebound = 7.3e5;
  strut.friction = 2500.0;
  strut.bearing_friction = 0.05;
  strut.bearing_upper = 0.5;
  strut.bearing_lower = 0.9;
  strut.end_stop = 1.4e8;
  return strut;
}

TEST(Strut, PushesWithGasPressureOverTheAtmosphereWhenExtended) {
  const auto strut = example();
  EXPECT_NEAR(gas_force(strut, 0.0), (2.25e6 - 101325.0) * 0.0105, 1e-9);
}

TEST(Strut, FollowsThePolytrope) {
  const auto strut = example();
  const double s = 0.2, volume = strut.extended_gas_volume - strut.piston_area * s;
  const double pressure = gas_force(strut, s) / strut.piston_area + atmospheric_pressure;
  EXPECT_NEAR(pressure * std::pow(volume, 1.1), 2.25e6 * std::pow(strut.extended_gas_volume, 1.1), 1e-6);
}

TEST(Strut, StoresWhatTheGasForceDoes) {
  const auto strut = example();
  const double h = 1e-6;
  for (const double s : {0.01, 0.15, 0.29})
    EXPECT_NEAR((gas_energy(strut, s + h) - gas_energy(strut, s - h)) / (2 * h), gas_force(strut, s),
                1e-6 * gas_force(strut, s));
}

TEST(Strut, DampsHarderInRebound) {
  const auto strut = example();
  EXPECT_DOUBLE_EQ(orifice_force(strut, 0.5), 0.25 * 2.8e5);
  EXPECT_DOUBLE_EQ(orifice_force(strut, -0.5), -0.25 * 7.3e5);
}

TEST(Strut, RubsWithSealsAndBearings) {
  const auto strut = example();
  const double lever = (0.9 - 0.2) / (0.5 + 0.2), normal = 40e3;
  const double bearings = normal * lever + normal * (1.0 + lever);  // N_u + N_l
  EXPECT_NEAR(friction_force(strut, 0.2, 1.0, normal), 2500.0 + 0.05 * bearings, 1e-3);
  EXPECT_NEAR(friction_force(strut, 0.2, 0.02, normal), std::tanh(1.0) * (2500.0 + 0.05 * bearings), 1e-3);
  EXPECT_EQ(friction_force(strut, 0.2, 0.0, normal), 0.0);
}

TEST(Strut, BottomsOutAtRatedStroke) {
  const auto strut = example();
  EXPECT_EQ(stop_force(strut, 0.30), 0.0);
  EXPECT_GT(stop_force(strut, 0.302), 1.8e5);
  EXPECT_LT(stop_force(strut, -0.002), -1.8e5);
  // C¹: the force starts with zero slope and reaches its stiffness after a millimetre or so.
  EXPECT_NEAR(stop_force(strut, 0.30 + 1e-7) / 1e-7, 0.0, 2e-4 * 1.4e8);
  EXPECT_NEAR((stop_force(strut, 0.3301) - stop_force(strut, 0.33)) / 1e-4, 1.4e8, 0.01e8);
}

TEST(Strut, StandsWhereGasCarriesTheLoad) {
  const auto strut = example();
  for (const double load : {30e3, 96e3, 200e3})
    EXPECT_NEAR(gas_force(strut, static_stroke(strut, load)) + stop_force(strut, static_stroke(strut, load)), load,
                1e-6 * load);
}

}  // namespace
}  // namespace apc::aircraft
