#include "aircraft/limits.h"

#include <gtest/gtest.h>

#include "aircraft/static_stand.h"
#include "apc/base/file.h"
#include "apc/base/units.h"

namespace apc::aircraft {
namespace {

Aircraft shipped_aircraft(const std::string& name) {
  const auto folder = shipped("aircraft/data");
  return load_aircraft(folder / (name + ".json"), load_tires(folder / "tires.json"));
}

TEST(Limits, TowLoadFollowsTheThreeBranchesOf25_509) {
  using units::lbf;
  EXPECT_NEAR(tow_load(29300 * lbf) / lbf, 8790.0, 1e-6);
  EXPECT_NEAR(tow_load(53250 * lbf) / lbf, 10992.86, 0.01);
  EXPECT_NEAR(tow_load(174700 * lbf) / lbf, 26205.0, 1e-6);
  // continuous at the joints, which the misprinted divisor 7 is not
  EXPECT_NEAR(tow_load(30000 * lbf), tow_load(29999.999 * lbf), 1.0);
  EXPECT_NEAR(tow_load(100000 * lbf), tow_load(100000.001 * lbf), 1.0);
}

TEST(Limits, NoseDragOfTheShippedAircraftMatchesTheRampWeights) {
  const auto nose = [](const Aircraft& plane) { return load_limits(plane, plane.gears.front()); };
  EXPECT_NEAR(nose(shipped_aircraft("CRJ-200")).drag_limit, 48.9e3, 0.1e3);
  EXPECT_NEAR(nose(shipped_aircraft("B737-800")).drag_limit, 116.6e3, 0.1e3);
  EXPECT_NEAR(nose(shipped_aircraft("B747-400")).drag_limit, 585.2e3, 0.2e3);
  EXPECT_EQ(nose(shipped_aircraft("B737-800")).drag_rule, "14 CFR 25.509 from the ramp weight");
  EXPECT_DOUBLE_EQ(nose(shipped_aircraft("B737-800")).drag_ultimate,
                   1.5 * nose(shipped_aircraft("B737-800")).drag_limit);
}

TEST(Limits, BrakedMainGearFollows25_493) {
  const auto plane = shipped_aircraft("B737-800");
  const auto stand = static_stand(plane);
  const auto main = load_limits(plane, plane.gears[1]);
  EXPECT_NEAR(main.vertical_limit, 1.2 * stand.gears[1].vertical, 1.0);
  EXPECT_NEAR(main.drag_limit, 0.8 * main.vertical_limit, 1e-6);
}

TEST(Limits, SuddenBrakingOf25_493eActsAtTheTakeOffWeight) {
  auto plane = shipped_aircraft("B737-800");
  const auto nose = [&] { return load_limits(plane, plane.gears.front()); };
  // V = W/(A + B) [B + f mu A E/(A + B + mu E)] at 174,200 lb, by hand
  const double ahead = 14.5, behind = 15.6 - 14.5, height = plane.cg_height, weight = 79016.0 * units::g0;
  const double expected = weight / 15.6 * (behind + 2.0 * 0.8 * ahead * height / (15.6 + 0.8 * height));
  EXPECT_NEAR(nose().vertical_limit, expected, 1e-6 * expected);
  EXPECT_EQ(nose().vertical_rule, "14 CFR 25.493(e) from the take-off weight");
  plane.ramp_mass *= 1.1;  // does not enter
  EXPECT_NEAR(nose().vertical_limit, expected, 1e-6 * expected);
  plane.takeoff_mass = 0.0;
  EXPECT_NEAR(nose().vertical_limit, expected * plane.ramp_mass / 79016.0, 1e-6 * expected);
  EXPECT_EQ(nose().vertical_rule, "14 CFR 25.493(e) from the ramp weight (no takeoff_mass given)");
}

TEST(Limits, TheFileOverrules) {
  auto plane = shipped_aircraft("CRJ-200");
  plane.gears[0].limits.drag_limit = 50e3;
  const auto nose = load_limits(plane, plane.gears[0]);
  EXPECT_DOUBLE_EQ(nose.drag_limit, 50e3);
  EXPECT_DOUBLE_EQ(nose.drag_ultimate, 75e3);
  EXPECT_EQ(nose.drag_rule, "aircraft file");
}

TEST(StaticStand, CarriesTheWeightAndTheMoment) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto plane = shipped_aircraft(name);
    const auto stand = static_stand(plane);
    double load = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < plane.gears.size(); ++i) {
      load += plane.gears[i].struts * stand.gears[i].vertical;
      moment += plane.gears[i].struts * stand.gears[i].vertical * plane.gears[i].behind_nose_gear;
    }
    const double weight = plane.mass * units::g0;
    EXPECT_NEAR(load, weight, 1e-10 * weight) << name;
    EXPECT_NEAR(moment, weight * plane.cg_behind_nose_gear, 1e-10 * moment) << name;
  }
}

TEST(StaticStand, MainStrutsSitWhereStrutsAreSizedFor) {
  for (const auto* name : {"CRJ-200", "B737-800"}) {
    const auto plane = shipped_aircraft(name);
    const double share = static_stand(plane).gears[1].stroke / plane.gears[1].strut.stroke;
    EXPECT_GT(share, 0.66) << name;
    EXPECT_LT(share, 0.82) << name;
  }
}

}  // namespace
}  // namespace apc::aircraft
