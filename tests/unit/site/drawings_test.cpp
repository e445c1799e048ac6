/// What goes to other programs: GeoJSON after RFC 7946 and KML that any XML reader takes.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "apc/base/units.h"
#include "apc/site/site.h"

namespace apc::site {
namespace {

Site end_at(double latitude, double longitude, double heading) {
  Site out;
  out.name = "end <\"27\"> & more", out.source = "made for tests";
  out.end = {latitude * units::deg, longitude * units::deg}, out.heading = heading * units::deg;
  out.runway_width = 45.72, out.safety_length = 300.0, out.safety_width = 150.0;
  return out;
}

bed::Bed some_bed() {
  bed::Bed out;
  out.name = "a bed", out.material = "foam";
  out.setback = 15.24, out.width = 45.72;
  out.distance = {0.0, 15.0, 120.0}, out.depth = {0.0, 0.4, 0.4};
  return out;
}

/// Twice the area enclosed, east × north, m²; positive = counterclockwise.
double signed_area(const nlohmann::json& ring, double latitude) {
  double sum = 0.0;
  const double north = 111.1e3, east = north * std::cos(latitude * units::deg);
  const double x0 = ring[0][0], y0 = ring[0][1];
  const auto x = [&](std::size_t i) { return (ring[i][0].get<double>() - x0) * east; };
  const auto y = [&](std::size_t i) { return (ring[i][1].get<double>() - y0) * north; };
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) sum += x(i) * y(i + 1) - x(i + 1) * y(i);
  return 0.5 * sum;
}

TEST(GeoJson, HasClosedCounterclockwiseRingsOfTheRightArea) {
  for (const auto& place : {end_at(45, 10, 92.4), end_at(-33.9, 151.2, 338), end_at(60, -150, 180)}) {
    const auto bed = some_bed();
    const auto drawing = nlohmann::json::parse(geojson(place, bed));
    EXPECT_EQ(drawing.at("type"), "FeatureCollection");
    int polygons = 0;
    for (const auto& feature : drawing.at("features")) {
      EXPECT_EQ(feature.at("type"), "Feature");
      EXPECT_TRUE(feature.at("properties").is_object());
      if (feature["geometry"]["type"] != "Polygon") continue;
      ++polygons;
      ASSERT_EQ(feature["geometry"]["coordinates"].size(), 1u);
      const auto& ring = feature["geometry"]["coordinates"][0];
      ASSERT_EQ(ring.size(), 5u);
      EXPECT_EQ(ring.front(), ring.back());
      const double area = signed_area(ring, place.end.latitude / units::deg);
      EXPECT_GT(area, 0.0) << feature["properties"]["name"];  // right-hand rule
      if (feature["properties"]["name"] == "arrestor bed") {
        EXPECT_NEAR(area / (bed.length() * bed.width), 1.0, 1e-2);  // degrees of a sphere
      }
    }
    EXPECT_EQ(polygons, 5);  // safety area, set-back, bed, two pieces of its depth
  }
}

TEST(GeoJson, DoesNotWindAroundTheEarthAtTheDateLine) {
  const auto drawing = nlohmann::json::parse(geojson(end_at(-17.0, 179.9999, 90), some_bed()));
  for (const auto& feature : drawing.at("features")) {
    if (feature["geometry"]["type"] != "Polygon") continue;
    const auto& ring = feature["geometry"]["coordinates"][0];
    for (const auto& corner : ring) EXPECT_NEAR(corner[0].get<double>(), ring[0][0].get<double>(), 0.01);
  }
}

TEST(Kml, ClosesEveryTagAndRingAndEscapesNames) {
  const auto text = kml(end_at(45, 10, 92.4), some_bed());
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z]+)[^>]*>");
  for (std::sregex_iterator each(text.begin(), text.end(), tag), end; each != end; ++each) {
    if ((*each)[1].length() == 0) {
      open.push_back((*each)[2]);
      continue;
    }
    ASSERT_FALSE(open.empty());
    EXPECT_EQ(open.back(), (*each)[2]);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
  EXPECT_NE(text.find("end &lt;&quot;27&quot;&gt; &amp; more"), std::string::npos);
  const std::regex ring("<LinearRing><coordinates>([^<]*)</coordinates>");
  int rings = 0;
  for (std::sregex_iterator each(text.begin(), text.end(), ring), end; each != end; ++each, ++rings) {
    const std::string corners = (*each)[1];
    const auto first = corners.substr(0, corners.find(' ')), last = corners.substr(corners.rfind(' ') + 1);
    EXPECT_EQ(first, last);
    EXPECT_EQ(std::count(corners.begin(), corners.end(), ' '), 4);
  }
  EXPECT_EQ(rings, 2);
}

}  // namespace
}  // namespace apc::site
