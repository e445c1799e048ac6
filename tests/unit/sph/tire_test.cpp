#include "sph_backend/tire.h"

#include <gtest/gtest.h>

#include "apc/base/require.h"
#include "cases.h"

namespace apc::sph {
namespace {

TEST(Tire, PassesThroughRatedAndBottomingPointOnARigidPlane) {
  for (const TireShape& shape : {testing::main_tire(), testing::nose_tire()}) {
    Tire tire = make_tire(shape);
    EXPECT_NEAR(press_on_plane(tire, shape.rated_deflection, 0.25) / shape.rated_load, 1.0, 0.01);
    EXPECT_NEAR(press_on_plane(tire, shape.bottoming_deflection, 0.25) / shape.bottoming_load, 1.0, 0.01);
  }
}

TEST(Tire, FollowsTheCatalogueCurveInBetween) {
  Tire tire = make_tire(testing::main_tire());
  for (const double share : {0.2, 0.3, 0.5, 0.7, 0.9}) {
    const double deflection = share * tire.shape.bottoming_deflection;
    EXPECT_NEAR(press_on_plane(tire, deflection) / catalogue_load(tire.shape, deflection), 1.0, 0.04) << share;
  }
}

TEST(Tire, StoresTheWorkOfTheLoad) {
  Tire tire = make_tire(testing::main_tire());
  double work = 0.0, before = 0.0;
  const int pieces = 40;
  const double piece = 0.8 * tire.shape.bottoming_deflection / pieces;
  for (int k = 1; k <= pieces; ++k) {
    const double load = press_on_plane(tire, k * piece);
    work += 0.5 * (before + load) * piece;
    before = load;
  }
  EXPECT_NEAR(2.0 * stored_energy(tire) / work, 1.0, 0.02);  // the half model stores half
}

TEST(Tire, LosesGasVolumeAndGainsPressureWhenPressed) {
  Tire tire = make_tire(testing::main_tire());
  EXPECT_NEAR(gas_state(tire).pressure / tire.shape.inflation, 1.0, 1e-12);
  press_on_plane(tire, tire.shape.rated_deflection);
  const GasState gas = gas_state(tire);
  EXPECT_LT(gas.volume_change, 0.0);
  EXPECT_GT(gas.pressure, tire.shape.inflation);
  EXPECT_LT(gas.pressure, 1.15 * tire.shape.inflation);
}

TEST(Tire, ElasticForceIsTheGradientOfTheStoredEnergy) {
  Tire tire = make_tire(testing::nose_tire());
  press_on_plane(tire, tire.shape.rated_deflection);
  std::vector<double> force;
  elastic_force(tire, force);
  for (const auto& [i, j] : {std::pair{0, 0}, std::pair{2, 3}, std::pair{94, 6}}) {
    const std::size_t n = tire.node(i, j);
    const double step = 1e-6, middle = tire.u[n];
    tire.u[n] = middle + step;
    const double high = stored_energy(tire);
    tire.u[n] = middle - step;
    const double low = stored_energy(tire);
    tire.u[n] = middle;
    EXPECT_NEAR(-(high - low) / (2.0 * step), force[n], 1e-3 * std::abs(force[n]) + 0.05);
  }
}

TEST(TireShape, MaximumPenetrationIsCrushedBedPlusDeflectionAndAtMostTheDiameter) {
  const TireShape tire = testing::main_tire();
  const double deflection = catalogue_deflection(tire, 0.8 * tire.bottoming_load);
  EXPECT_NEAR(catalogue_load(tire, deflection), 0.8 * tire.bottoming_load, 1.0);
  EXPECT_NEAR(maximum_penetration(tire, 0.3), 0.85 * 0.3 + deflection, 1e-12);
  EXPECT_DOUBLE_EQ(maximum_penetration(testing::nose_tire(), 36.0 * units::in), 17.9 * units::in);
}

TEST(TireShape, SectionIsItsOutline) {
  const Section s = section(testing::main_tire());
  EXPECT_NEAR(s.at(s.radial, 0.0).distance, 0.0, 1e-12);
  EXPECT_NEAR(s.at(0.0, s.lateral).distance, 0.0, 1e-12);
  EXPECT_NEAR(s.at(-s.radial, 0.8 * s.lateral).distance, 0.0, 1e-9);
  EXPECT_NEAR(s.at(s.radial + 0.01, 0.0).distance, 0.01, 1e-4);
  EXPECT_NEAR(s.at(s.radial + 0.01, 0.0).normal_radial, 1.0, 1e-12);
}

/// The contact does as much work as it stores only with the exact gradient, away from the outline too.
TEST(TireShape, NormalIsTheGradientOfTheDistance) {
  const Section s = section(testing::main_tire());
  const double step = 1e-6;
  for (const double r : {0.9, 0.5, 0.1, -0.1, -0.6})
    for (const double y : {0.2, 0.6, 0.9, 1.05}) {
      const double radial = r * s.radial, lateral = y * s.lateral;
      const SectionPoint p = s.at(radial, lateral);
      const double dr = s.at(radial + step, lateral).distance - s.at(radial - step, lateral).distance;
      const double dy = s.at(radial, lateral + step).distance - s.at(radial, lateral - step).distance;
      EXPECT_NEAR(p.normal_radial, dr / (2.0 * step), 1e-6) << r << " " << y;
      EXPECT_NEAR(p.normal_lateral, dy / (2.0 * step), 1e-6) << r << " " << y;
    }
}

TEST(Tire, ImpossibleCatalogueIsRefused) {
  TireShape tire = testing::main_tire();
  tire.bottoming_load = 1e8;
  EXPECT_THROW(make_tire(tire), InputError);
}

}  // namespace
}  // namespace apc::sph
