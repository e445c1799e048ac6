#include <gtest/gtest.h>

#include "aircraft/static_stand.h"
#include "apc/base/file.h"
#include "apc/base/units.h"

namespace apc::aircraft {
namespace {

/// The FAA's instrumented 727 stood with 12,299 lb of its 135,000 lb on the nose gear.
TEST(TestAircraft, StandsOnItsNoseGearAsTheFaaWeighedIt) {
  const auto folder = shipped("aircraft/data");
  const auto plane = load_aircraft(folder / "B727-100.json", load_tires(folder / "tires.json"));
  const auto stand = static_stand(plane);
  EXPECT_NEAR(plane.mass / units::lb, 135000, 1);
  EXPECT_NEAR(stand.gears[0].vertical / units::lbf, 12299, 50);
  EXPECT_NEAR(stand.gears[0].vertical + 2 * stand.gears[1].vertical, plane.mass * units::g0, 1.0);
}

}  // namespace
}  // namespace apc::aircraft
