#include "apc/site/site.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::site {
namespace {

const std::string good = R"({ "schema": "apc-site/1", "name": "made-up runway end", "source": "invented for tests",
  "runway_end": { "latitude": "45 deg", "longitude": "10 deg", "true_heading": "90 deg", "width": "150 ft" },
  "safety_area": { "length": "600 ft", "width": "500 ft" }, "minimum_setback": "35 ft", "grade": 0.0 })";

Site site() { return read_site(parse_json(good, "site.json")); }

bed::Bed bed(double setback, double length, double width) {
  bed::Bed out;
  out.name = "b", out.material = "foam";
  out.setback = setback, out.width = width;
  out.distance = {0.0, 15.0, length}, out.depth = {0.0, 0.4, 0.4};
  return out;
}

/// One degree of meridian at the equator, 110 574.3886 m (WGS 84).
TEST(Away, OneDegreeOfMeridianAtTheEquator) {
  const auto there = away({0.0, 0.2}, 0.0, 110574.3886);
  EXPECT_NEAR(there.latitude / units::deg, 1.0, 1e-9);
  EXPECT_NEAR(there.longitude, 0.2, 1e-15);
}

TEST(Away, OneDegreeOfEquatorIsTheCircleOfTheSemiMajorAxis) {
  const auto there = away({0.0, 0.0}, 90 * units::deg, 6378137.0 * units::deg);
  EXPECT_NEAR(there.longitude / units::deg, 1.0, 1e-10);
  EXPECT_NEAR(there.latitude, 0.0, 1e-15);
}

TEST(Away, ComesBackWhereItStarted) {
  const Place from{40.6 * units::deg, -73.8 * units::deg};
  const auto there = away(from, 33 * units::deg, 180.0), back = away(there, 213.0014 * units::deg, 180.0);
  EXPECT_NEAR(back.latitude, from.latitude, 1e-9);
  EXPECT_NEAR(back.longitude, from.longitude, 1e-9);
}

TEST(Site, ABedThatFitsMeetsEveryCheck) {
  for (const auto& check : fit(site(), bed(15.24, 120.0, 45.72))) EXPECT_TRUE(check.met) << check.what;
}

TEST(Site, SaysWhatDoesNotFit) {
  const auto misses = [](const bed::Bed& each) {
    std::string out;
    for (const auto& check : fit(site(), each))
      if (!check.met) out += check.what + ";";
    return out;
  };
  EXPECT_NE(misses(bed(5.0, 120.0, 45.72)).find("set-back"), std::string::npos);
  EXPECT_NE(misses(bed(15.24, 200.0, 45.72)).find("far end"), std::string::npos);
  EXPECT_NE(misses(bed(15.24, 120.0, 30.0)).find("not below the runway's"), std::string::npos);
  EXPECT_NE(misses(bed(15.24, 120.0, 200.0)).find("safety area's width"), std::string::npos);
}

TEST(Site, TheBedLiesAheadAndCentred) {
  const auto corners = area(site(), 15.24, 135.24, 45.72);  // heading east at 45° north
  const double metre_east = 1.0 / (6378137.0 / std::sqrt(1 - 0.00669437999 * 0.5) * std::cos(45 * units::deg));
  EXPECT_NEAR(corners[0].longitude, 10 * units::deg + 15.24 * metre_east, 1e-3 * metre_east);
  EXPECT_NEAR(corners[1].longitude, 10 * units::deg + 135.24 * metre_east, 1e-3 * metre_east);
  EXPECT_GT(corners[0].latitude, 45 * units::deg);  // left of east is north
  EXPECT_NEAR(corners[0].latitude + corners[3].latitude, 90 * units::deg, 1e-9);
}

TEST(Site, GeoJsonIsReadableAndClosesItsRings) {
  const auto text = geojson(site(), bed(15.24, 120.0, 45.72));
  const auto json = parse_json(text, "geojson");
  EXPECT_EQ(json.text("type"), "FeatureCollection");
  const auto ring = json.objects("features")[2].raw()["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_NE(kml(site(), bed(15.24, 120.0, 45.72)).find("<coordinates>"), std::string::npos);
}

TEST(Site, IsRefusedByPlaceAndReason) {
  const struct {
    std::string from, to, place;
  } slips[] = {{R"("length": "600 ft")", R"("length": "20 ft")", "/minimum_setback"},
               {R"("true_heading": "90 deg")", R"("true_heading": "400 deg")", "/runway_end/true_heading"},
               {R"("latitude": "45 deg")", R"("latitude": 45)", "/runway_end"},
               {R"("width": "500 ft")", R"("width": "100 ft")", "/safety_area/width"},
               {R"("grade": 0.0)", R"("grad": 0.0)", "grad"}};
  for (const auto& slip : slips) {
    auto text = good;
    text.replace(text.find(slip.from), slip.from.size(), slip.to);
    try {
      read_site(parse_json(text, "site.json"));
      FAIL() << slip.to;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(slip.place), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace apc::site
