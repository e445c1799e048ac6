#include "loadtables/crush_balance.h"

#include <gtest/gtest.h>

#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

CrushBalance balance() {
  const auto tire = synthetic::tire();
  CrushBalance result;
  result.tire = MonotoneCurve(tire.curve_deflection, tire.curve_load);
  result.radius = 0.5 * tire.diameter;
  result.width = tire.width;
  result.strength = 345e3;
  return result;
}

TEST(CrushBalance, IsTheTireOnPavement) {
  const auto model = balance();
  const auto load = model.load({20.0, 0.0, 0.08});
  EXPECT_DOUBLE_EQ(load.vertical, 150e3);
  EXPECT_DOUBLE_EQ(load.drag, 0.014 * 150e3);
  EXPECT_EQ(load.rut_depth, 0.0);
  EXPECT_GT(load.spin_ratio, 1.0);  // the rolling radius is smaller than the free one
}

TEST(CrushBalance, SplitsPenetrationIntoRutAndDeflection) {
  const auto model = balance();
  for (const double depth : {0.05, 0.2, 0.6})
    for (const double penetration : {0.02, 0.1, 0.3, 0.6}) {
      const auto load = model.load({20.0, depth, penetration});
      EXPECT_NEAR(model.tire(penetration - load.rut_depth), load.vertical, 1e-6 * load.vertical);
    }
}

TEST(CrushBalance, TheTireTakesOverOnceTheFoamIsCompacted) {
  const auto model = balance();
  const double depth = 0.08;
  const auto thin = model.load({20.0, depth, 0.85 * depth + 0.09}), deep = model.load({20.0, 0.9, 0.85 * depth + 0.09});
  EXPECT_NEAR(thin.vertical, model.tire(0.09), 0.12 * thin.vertical);
  EXPECT_LT(deep.vertical, 0.6 * thin.vertical);
  EXPECT_NEAR(thin.rut_depth, 0.85 * depth, 0.1 * depth);
}

TEST(CrushBalance, VerticalLoadGrowsWithPenetration) {
  const auto model = balance();
  for (const double depth : {0.0, 0.01, 0.1, 0.5}) {
    double last = 0.0;
    for (double penetration = 0.005; penetration < 0.5; penetration += 0.005) {
      const double vertical = model.load({0.0, depth, penetration}).vertical;
      EXPECT_GT(vertical, last) << depth << " " << penetration;
      last = vertical;
    }
  }
}

TEST(CrushBalance, CalibrationFindsTheFactorsThatMadeTheSamples) {
  auto made_with = balance();
  made_with.area_factor = 1.4, made_with.crown = 0.15, made_with.wall_shear = 0.1;
  made_with.lock_up = 0.8, made_with.lock_width = 0.05, made_with.drag_factor = 1.6;
  auto samples = synthetic::samples(50).samples;
  for (auto& sample : samples) sample.load = made_with.load(sample.contact);
  const auto found = calibrate(balance(), samples);
  EXPECT_NEAR(found.area_factor, 1.4, 0.01);
  EXPECT_NEAR(found.lock_up, 0.8, 0.005);
  EXPECT_NEAR(found.drag_factor, 1.6, 0.01);
  EXPECT_NEAR(found.crown, 0.15, 0.01);
}

}  // namespace
}  // namespace apc::loadtables
