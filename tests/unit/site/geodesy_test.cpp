#include "apc/site/geodesy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apc/base/units.h"

namespace apc::site {
namespace {

double sexagesimal(int degrees, int minutes, double seconds) {
  return (degrees + minutes / 60.0 + seconds / 3600.0) * units::deg;
}

/// The worked example of the Geocentric Datum of Australia's technical manual: Flinders Peak to Buninyong, 54,972.271 m
/// at 306°52'05.37", back at 127°10'25.07". Its ellipsoid, GRS 80, is WGS 84 within 0.1 mm.
const Place flinders_peak{-sexagesimal(37, 57, 3.72030), sexagesimal(144, 25, 29.52440)},
    buninyong{-sexagesimal(37, 39, 10.15610), sexagesimal(143, 55, 35.38390)};

TEST(Geodesic, FlindersPeakToBuninyongBothWays) {
  const auto there = way(flinders_peak, buninyong), back = way(buninyong, flinders_peak);
  EXPECT_NEAR(there.length, 54972.271, 1e-3);
  EXPECT_NEAR(there.heading, sexagesimal(306, 52, 5.37), sexagesimal(0, 0, 0.01));
  EXPECT_NEAR(back.length, 54972.271, 1e-3);
  EXPECT_NEAR(back.heading, sexagesimal(127, 10, 25.07), sexagesimal(0, 0, 0.01));
  const auto end = away(flinders_peak, sexagesimal(306, 52, 5.37), 54972.271);
  EXPECT_NEAR(end.latitude, buninyong.latitude, 3e-10);  // 2 mm: the azimuth is given to 0.01"
  EXPECT_NEAR(end.longitude, buninyong.longitude, 5e-10);
}

/// One degree of meridian at the equator, 110 574.3886 m (WGS 84).
TEST(Geodesic, OneDegreeOfMeridianAtTheEquator) {
  const auto there = away({0.0, 0.2}, 0.0, 110574.3886);
  EXPECT_NEAR(there.latitude / units::deg, 1.0, 1e-9);
  EXPECT_NEAR(there.longitude, 0.2, 1e-15);
}

TEST(Geodesic, OneDegreeOfEquatorIsTheCircleOfTheSemiMajorAxis) {
  const auto there = away({0.0, 0.0}, 90 * units::deg, 6378137.0 * units::deg);
  EXPECT_NEAR(there.longitude / units::deg, 1.0, 1e-10);
  EXPECT_NEAR(there.latitude, 0.0, 1e-15);
  EXPECT_NEAR(way({0.0, 0.0}, {0.0, units::deg}).length, 6378137.0 * units::deg, 1e-4);
}

TEST(Geodesic, TheInverseUndoesTheDirectProblemAtAnyHeadingAndAcrossTheDateLine) {
  for (const double longitude : {-73.8, 179.9995})
    for (int degrees = 0; degrees < 360; degrees += 17) {
      const Place from{40.6 * units::deg, longitude * units::deg};
      const auto there = away(from, degrees * units::deg, 180.0);
      EXPECT_LE(std::abs(there.longitude), std::numbers::pi);
      const auto run = way(from, there);
      EXPECT_NEAR(run.length, 180.0, 1e-6);
      EXPECT_NEAR(std::remainder(run.heading - degrees * units::deg, 2 * std::numbers::pi), 0.0, 1e-8) << degrees;
    }
}

TEST(Geodesic, APlaceIsNoWayFromItself) { EXPECT_EQ(way(buninyong, buninyong).length, 0.0); }

}  // namespace
}  // namespace apc::site
