#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/curve.h"
#include "apc/base/file.h"
#include "apc/base/units.h"
#include "loadtables/load_table.h"

namespace apc::loadtables {
namespace {

constexpr const char* tires[] = {"R18x4.4", "H27x7.7-15", "H29x9.0-15", "H44.5x16.5-21", "H49x19-22"};

LoadTable shipped_table(const std::string& tire) {
  return load_table(shipped("loadtables/data/" + tire + "_foam_50psi.h5"));
}

/// Calls `look(table, depth, speed)` for every shipped tire, over the beds that are built and the speeds of a stop.
template <class Look>
void for_all_beds(const Look& look) {
  for (const auto* tire : tires) {
    SCOPED_TRACE(tire);
    const auto table = shipped_table(tire);
    for (const double depth : {3.0, 9.0, 18.0, 24.0, 36.0})
      for (const double speed : {0.0, 10.0, 20.0, 36.0}) look(table, depth * units::in, speed);
  }
}

TEST(CrushedThrough, JoinsTheTableWithoutAStepOrAKinkWhereTheTableRises) {
  for_all_beds([](const LoadTable& table, double depth, double speed) {
    const double edge = table.maximum_penetration(depth);
    const auto before = table.load_with_slopes({speed, depth, edge * (1.0 - 1e-10)}),
               after = table.load_with_slopes({speed, depth, edge * (1.0 + 1e-10)});
    EXPECT_NEAR(after.load.vertical, before.load.vertical, 1e-6 * before.load.vertical);
    EXPECT_NEAR(after.load.drag, before.load.drag, 1e-6 * before.load.drag);
    EXPECT_NEAR(after.load.rut_depth, before.load.rut_depth, 1e-8);
    EXPECT_NEAR(after.load.spin_ratio, before.load.spin_ratio, 1e-6);
    const double rising = std::max(0.0, before.vertical.penetration);
    EXPECT_NEAR(after.vertical.penetration, rising, 1e-5 * rising + 1.0);
  });
}

TEST(CrushedThrough, LoadGrowsWithEveryFurtherMillimetreAndAtLastAsOnTheTireAlone) {
  for_all_beds([](const LoadTable& table, double depth, double speed) {
    const double edge = table.maximum_penetration(depth);
    for (double beyond = 1e-3; beyond < 3.0; beyond *= 1.3)
      EXPECT_GT(table.load_with_slopes({speed, depth, edge + beyond}).vertical.penetration, 0.0)
          << depth << " " << beyond;
    const MonotoneCurve curve(table.tire().curve_deflection, table.tire().curve_load);
    const double stiffness = curve.slope(10.0);
    EXPECT_NEAR(table.load_with_slopes({speed, depth, edge + 200.0}).vertical.penetration, stiffness, 2e-3 * stiffness);
  });
}

TEST(CrushedThrough, RutEndsAtTheBaseAndDragAtTheVolumeDownToIt) {
  for_all_beds([](const LoadTable& table, double depth, double speed) {
    const auto pavement = table.load_on_pavement(table.maximum_penetration(0.0)).load;
    const double friction = pavement.drag / pavement.vertical;
    const double edge = table.maximum_penetration(depth);
    const auto at_edge = table.load({speed, depth, edge});
    const double crushing = at_edge.drag - friction * at_edge.vertical;
    const double deepest = std::max(depth, at_edge.rut_depth);  // a fit may put the edge's rut just below the base
    EXPECT_LT(at_edge.rut_depth, 1.02 * depth);
    for (const double beyond : {0.01, 0.1, 0.5, 2.0}) {
      const auto load = table.load({speed, depth, edge + beyond});
      EXPECT_GE(load.rut_depth, at_edge.rut_depth - 1e-12);
      EXPECT_LE(load.rut_depth, deepest);
      EXPECT_LE(load.rut_depth, edge + beyond);
      const double crushed = load.drag - friction * load.vertical;
      EXPECT_LE(crushed, crushing * deepest / at_edge.rut_depth * 1.001 + 1.0);
      EXPECT_GE(crushed, 0.999 * crushing - 1.0);
      EXPECT_GE(load.spin_ratio, std::min(0.5 * at_edge.spin_ratio, at_edge.spin_ratio));
      EXPECT_LT(load.spin_ratio, 1.5);
    }
  });
}

TEST(CrushedThrough, IsTheTireItselfOnPavement) {
  for (const auto* tire : tires) {
    const auto table = shipped_table(tire);
    const MonotoneCurve curve(table.tire().curve_deflection, table.tire().curve_load);
    for (const double share : {1.05, 1.2, 1.5}) {
      const double deflection = share * table.tire().bottoming_deflection;
      EXPECT_NEAR(table.load({20.0, 0.0, deflection}).vertical, curve(deflection), 5e-3 * curve(deflection)) << tire;
      EXPECT_NEAR(table.load_on_pavement(deflection).load.vertical, curve(deflection), 5e-3 * curve(deflection));
    }
  }
}

}  // namespace
}  // namespace apc::loadtables
