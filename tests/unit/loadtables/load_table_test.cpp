#include "loadtables/load_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/curve.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "loadtables/load_table_data.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

namespace u = units;

const LoadTable& table() {
  static const LoadTable made = synthetic::table();
  return made;
}

void expect_slopes_match(const TireContact& at, double tolerance = 1e-5) {
  const auto found = table().load_with_slopes(at);
  const auto value = table().load(at);
  EXPECT_NEAR(found.load.drag, value.drag, 1e-12 * value.drag);
  EXPECT_NEAR(found.load.vertical, value.vertical, 1e-12 * value.vertical);
  const auto differences = [&](double TireContact::*axis, double step) {
    auto up = at, down = at;
    up.*axis += step, down.*axis -= step;
    const auto a = table().load(up), b = table().load(down);
    return std::array{(a.drag - b.drag) / (2 * step), (a.vertical - b.vertical) / (2 * step),
                      (a.rut_depth - b.rut_depth) / (2 * step), (a.spin_ratio - b.spin_ratio) / (2 * step)};
  };
  const auto compare = [&](const std::array<double, 4>& numeric, double Slopes::*axis, const char* what) {
    const std::array analytic{found.drag.*axis, found.vertical.*axis, found.rut_depth.*axis, found.spin_ratio.*axis};
    for (std::size_t m = 0; m < 4; ++m)
      EXPECT_NEAR(analytic[m], numeric[m], tolerance * (std::abs(numeric[m]) + 1e-3 * (m < 2 ? 1e5 : 1.0)))
          << what << ", response " << m << " at " << at.speed << " " << at.bed_depth << " " << at.penetration;
  };
  compare(differences(&TireContact::speed, 1e-4), &Slopes::speed, "speed");
  compare(differences(&TireContact::bed_depth, 1e-6), &Slopes::bed_depth, "bed depth");
  compare(differences(&TireContact::penetration, 1e-6), &Slopes::penetration, "penetration");
}

TEST(LoadTable, GivesNothingWithoutPenetration) {
  for (const double penetration : {0.0, -0.01, -5.0}) {
    const auto load = table().load({20.0, 0.4, penetration});
    EXPECT_EQ(load.drag, 0.0);
    EXPECT_EQ(load.vertical, 0.0);
    EXPECT_EQ(load.rut_depth, 0.0);
    EXPECT_EQ(load.spin_ratio, 1.0);
    EXPECT_EQ(table().load_with_slopes({20.0, 0.4, penetration}).vertical.penetration, 0.0);
    EXPECT_TRUE(table().coverage({500.0, 50.0, penetration}).inside());
  }
}

TEST(LoadTable, StartsWithoutAStepOrAKink) {
  for (const double depth : {0.0, 0.05, 0.4}) {
    const auto start = table().load_with_slopes({20.0, depth, 1e-7});
    EXPECT_NEAR(start.load.vertical, 0.0, 1e-6);
    EXPECT_NEAR(start.vertical.penetration, 0.0, 1.0);  // later slopes are of the order of 1e6 N/m
    EXPECT_NEAR(start.drag.penetration, 0.0, 1.0);
    EXPECT_NEAR(start.load.spin_ratio, 1.0, 1e-9);
  }
}

TEST(LoadTable, IsTheTireItselfOnPavement) {
  for (const double deflection : {0.03, 0.08, 0.12, 0.15}) {
    const MonotoneCurve curve(table().tire().curve_deflection, table().tire().curve_load);
    for (const double speed : {0.0, 15.0, 36.0}) {
      const auto load = table().load({speed, 0.0, deflection});
      EXPECT_NEAR(load.vertical, curve(deflection), 2e-3 * curve(deflection));
      EXPECT_NEAR(load.drag, 0.014 * curve(deflection), 4e-3 * 0.014 * curve(deflection));
      EXPECT_NEAR(load.rut_depth, 0.0, 1e-12);
    }
  }
}

TEST(LoadTable, ReproducesItsSamplesWithinTheStatedError) {
  const auto& set = table().data().samples;
  for (const auto& quality : table().quality()) {
    double error = 0.0, mean = 0.0;
    for (const auto& [contact, load] : set.samples) {
      const auto found = table().load(contact);
      const auto pick = [&](const TireLoad& of) {
        return quality.response == "drag"        ? of.drag
               : quality.response == "vertical"  ? of.vertical
               : quality.response == "rut_depth" ? of.rut_depth
                                                 : of.spin_ratio;
      };
      error += std::pow(pick(found) - pick(load), 2) / static_cast<double>(set.samples.size());
      mean += std::abs(pick(load)) / static_cast<double>(set.samples.size());
    }
    EXPECT_NEAR(std::sqrt(error) / mean, quality.rms_relative, 1e-9) << quality.response;
    EXPECT_EQ(quality.points, 70);
    EXPECT_LT(quality.rms_relative, 0.02) << quality.response;
    EXPECT_GT(quality.r2, 0.995) << quality.response;
  }
  EXPECT_EQ(table().quality().size(), 4u);
}

TEST(LoadTable, SlopesMatchDifferencesInside) {
  for (const double speed : {1.0, 12.0, 30.0})
    for (const double depth : {0.01, 0.1, 0.45, 0.8})
      for (const double ratio : {0.01, 0.2, 0.6, 0.95})
        expect_slopes_match({speed, depth, ratio * table().maximum_penetration(depth)});
}

TEST(LoadTable, SlopesMatchDifferencesOutside) {
  expect_slopes_match({60.0, 0.4, 0.2});
  expect_slopes_match({20.0, 1.4, 0.5});
  expect_slopes_match({20.0, 0.3, 1.35 * table().maximum_penetration(0.3)});
  expect_slopes_match({60.0, 1.2, 1.4 * table().maximum_penetration(1.2)});
  expect_slopes_match({-20.0, 0.4, 0.2});
}

TEST(LoadTable, IsLevelInSpeedAtRestAndSymmetric) {
  const auto rest = table().load_with_slopes({0.0, 0.4, 0.2});
  EXPECT_NEAR(rest.drag.speed, 0.0, 1e-6);
  EXPECT_NEAR(rest.vertical.speed, 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(table().load({-7.0, 0.4, 0.2}).drag, table().load({7.0, 0.4, 0.2}).drag);
}

TEST(LoadTable, ContinuesLinearlyBeyondItsSpeeds) {
  const auto at = [](double speed) { return table().load({speed, 0.4, 0.2}).drag; };
  EXPECT_NEAR(at(50.0) - at(45.0), at(45.0) - at(40.0), 1e-6 * at(45.0));
}

TEST(LoadTable, StaysPositiveHoweverFarOutside) {
  for (const double speed : {0.0, 80.0, 300.0})
    for (const double depth : {0.0, 0.02, 0.5, 3.0})
      for (const double ratio : {0.01, 0.3, 1.0, 4.0}) {
        const auto load = table().load({speed, depth, ratio * table().maximum_penetration(depth)});
        EXPECT_GE(load.drag, 0.0);
        EXPECT_GE(load.vertical, 0.0);
        EXPECT_TRUE(std::isfinite(load.drag) && std::isfinite(load.vertical));
      }
}

TEST(LoadTable, SaysWhichAxisWasLeft) {
  const auto inside = table().coverage({20.0, 0.4, 0.2});
  EXPECT_TRUE(inside.inside());
  EXPECT_FALSE(table().coverage({2.0, 0.4, 0.2}).speed);
  EXPECT_FALSE(table().coverage({40.0, 0.4, 0.2}).speed);
  EXPECT_FALSE(table().coverage({20.0, 1.0, 0.2}).bed_depth);
  const auto deep = table().coverage({20.0, 0.4, 1.1 * table().maximum_penetration(0.4)});
  EXPECT_FALSE(deep.penetration);
  EXPECT_TRUE(deep.speed && deep.bed_depth);
  EXPECT_TRUE(table().coverage({2.0, 0.0, 0.05}).inside());  // pavement loads do not depend on speed
  EXPECT_TRUE(table().coverage({10 * u::kt, 3 * u::in, 0.01}).inside());
}

TEST(LoadTable, VerticalLoadRisesSteeplyOnceAThinBedIsCompacted) {
  const double depth = 0.05, compact = 0.83 * depth + 0.03;
  const auto before = table().load_with_slopes({20.0, depth, 0.4 * compact}),
             after = table().load_with_slopes({20.0, depth, compact + 0.06});
  EXPECT_GT(after.vertical.penetration, 1.5e6);  // the tire's own stiffness is about 2.2e6 N/m
  EXPECT_GT(after.vertical.penetration, 2.0 * before.vertical.penetration);
}

TEST(LoadTable, MaximumPenetrationFollowsTheReportsDefinition) {
  const MonotoneCurve curve(table().tire().curve_deflection, table().tire().curve_load);
  const double deflection = curve.inverse(0.8 * 420e3);
  EXPECT_NEAR(table().maximum_penetration(0.4), 0.85 * 0.4 + deflection, 1e-3);
  EXPECT_NEAR(table().maximum_penetration(3.0), 1.0, 1e-3);  // capped at the diameter
  EXPECT_NEAR(table().maximum_penetration(0.0), deflection, 1e-3);
}

TEST(LoadTable, FitRefusesSamplesThatCannotCarryATable) {
  auto set = synthetic::samples();
  set.samples.resize(8);
  EXPECT_THROW(fit(set, synthetic::tire(), {}), InputError);
  set = synthetic::samples();
  set.samples[3].load.drag = std::nan("");
  EXPECT_THROW(fit(set, synthetic::tire(), {}), InputError);
  auto tire = synthetic::tire();
  tire.curve_load = {0.0, 150e3, 140e3};
  EXPECT_THROW(fit(synthetic::samples(), tire, {}), InputError);
}

TEST(LoadTable, FitsSamplesWithoutRutAndSpin) {
  auto set = synthetic::samples();
  set.has_rut = set.has_spin = false;
  for (auto& sample : set.samples) sample.load.rut_depth = 0.0, sample.load.spin_ratio = 1.0;
  const auto made = fit(set, synthetic::tire(), {});
  EXPECT_EQ(made.quality().size(), 2u);
  const auto load = made.load({20.0, 0.4, 0.25});
  const MonotoneCurve curve(synthetic::tire().curve_deflection, synthetic::tire().curve_load);
  EXPECT_NEAR(load.rut_depth, 0.25 - curve.inverse(load.vertical), 0.005);  // from the tire's own deflection
}

}  // namespace
}  // namespace apc::loadtables
