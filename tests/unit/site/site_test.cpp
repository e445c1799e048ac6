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
  EXPECT_NEAR(corners[3].longitude, 10 * units::deg + 135.24 * metre_east, 1e-3 * metre_east);
  EXPECT_GT(corners[0].latitude, 45 * units::deg);  // left of east is north
  EXPECT_NEAR(corners[0].latitude + corners[1].latitude, 90 * units::deg, 1e-9);
  EXPECT_NEAR(way(corners[0], corners[1]).length, 45.72, 1e-6);
  EXPECT_NEAR(way(corners[2], corners[3]).length, 45.72, 1e-6);
}

TEST(Site, FallsShortOfTheSetBackIsBadInput) {
  try {
    fit(site(), bed(200.0, 120.0, 45.72));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/safety_area/length"), std::string::npos) << error.what();
  }
}

TEST(Site, IsReadBackFromItsOwnFile) {
  auto from = site();
  from.elevation = 31.4, from.displaced_threshold = 120.0;
  const auto back = read_site(parse_json(site_json(from), "site.json"));
  EXPECT_NEAR(back.end.latitude, from.end.latitude, 1e-11);
  EXPECT_NEAR(back.heading, from.heading, 1e-11);
  EXPECT_NEAR(back.runway_width, from.runway_width, 1e-3);
  EXPECT_NEAR(back.safety_length, from.safety_length, 1e-3);
  EXPECT_EQ(back.displaced_threshold, 120.0);
  EXPECT_EQ(back.name, from.name);
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
