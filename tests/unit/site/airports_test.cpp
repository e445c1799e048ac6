#include "apc/site/airports.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <numbers>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::site {
namespace {

/// A set of one invented airport: a runway 09/27 along the 45th parallel, one without coordinates, one closed, one
/// whose heading contradicts its ends.
class Airports : public testing::Test {
 protected:
  Airports() : folder_(std::filesystem::temp_directory_path() / ("apc_airports_" + std::to_string(::getpid()))) {
    write_text(folder_ / "airports.csv",
               "\"id\",\"ident\",\"type\",\"name\",\"latitude_deg\",\"longitude_deg\",\"gps_code\",\"iata_code\","
               "\"local_code\"\n"
               "1,\"XKAP\",\"medium_airport\",\"Example \"\"Regional\"\", North\",45.0,10.0,\"XKAP\",\"XKA\",\"\"\n");
    write_text(
        folder_ / "runways.csv",
        "\"id\",\"airport_ref\",\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\","
        "\"le_ident\",\"le_latitude_deg\",\"le_longitude_deg\",\"le_elevation_ft\",\"le_heading_degT\","
        "\"le_displaced_threshold_ft\",\"he_ident\",\"he_latitude_deg\",\"he_longitude_deg\",\"he_elevation_ft\","
        "\"he_heading_degT\",\"he_displaced_threshold_ft\"\n"
        "1,1,\"XKAP\",5171,148,\"ASP\",1,0,\"09\",45.00000,10.00000,102,90,,\"27\",45.00000,10.02000,98,270,500\n"
        "2,1,\"XKAP\",4000,100,\"GRS\",0,0,\"18\",,,,180,,\"36\",,,,,\n"
        "3,1,\"XKAP\",4000,100,\"ASP\",0,1,\"04\",45.0,10.0,,,,\"22\",45.01,10.01,,,\n"
        "4,1,\"XKAP\",5171,148,\"ASP\",1,0,\"13\",45.00000,10.00000,102,130,,\"31\",45.00000,10.02000,98,310,\n");
  }
  ~Airports() override { std::filesystem::remove_all(folder_); }

  std::string refusal(const std::string& airport, const std::string& runway) const {
    try {
      find_runway_end(folder_, airport, runway);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path folder_;
};

TEST_F(Airports, TheFarEndOfTheRunwayInUseIsOverrun) {
  for (const char* code : {"XKAP", "XKA"}) {
    const auto end = find_runway_end(folder_, code, "09");
    EXPECT_EQ(end.opposite, "27");
    EXPECT_EQ(end.name, "Example \"Regional\", North");
    EXPECT_NEAR(end.end.longitude / units::deg, 10.02, 1e-12);
    EXPECT_NEAR(end.heading / units::deg, 90.0, 0.01);  // half the convergence of the meridians: 0.007 deg
    EXPECT_NEAR(end.width, 148 * units::ft, 1e-9);
    EXPECT_NEAR(end.elevation, 98 * units::ft, 1e-9);
    EXPECT_NEAR(end.displaced_threshold, 500 * units::ft, 1e-9);
    EXPECT_NEAR(end.resolution, 1.11, 0.01);  // five decimals
  }
  const auto other = find_runway_end(folder_, "XKAP", "27");
  EXPECT_NEAR(other.end.longitude / units::deg, 10.0, 1e-12);
  EXPECT_NEAR(other.heading / units::deg, 270.0, 0.01);
  EXPECT_EQ(other.displaced_threshold, 0.0);
}

TEST_F(Airports, ASiteOfAnEndHoldsABedBehindIt) {
  const auto end = find_runway_end(folder_, "XKAP", "09");
  const auto site = read_site(parse_json(site_json(site_of(end, 300.0, 150.0, 10.0)), "site.json"));
  const auto corners = area(site, 15.0, 100.0, 45.0);
  EXPECT_GT(corners[0].longitude, end.end.longitude);  // east of the eastern end
  EXPECT_NEAR(site.displaced_threshold, 152.4, 1e-9);
}

TEST_F(Airports, WhatTheSetCannotTellIsRefused) {
  EXPECT_NE(refusal("XKAP", "08").find("It has: 09, 27, 18, 36"), std::string::npos) << refusal("XKAP", "08");
  EXPECT_NE(refusal("NONE", "08").find("knows no airport"), std::string::npos);
  EXPECT_NE(refusal("XKAP", "18").find("coordinates"), std::string::npos) << refusal("XKAP", "18");
  EXPECT_NE(refusal("XKAP", "04").find("is closed"), std::string::npos);
  EXPECT_NE(refusal("XKAP", "13").find("contradicts its ends"), std::string::npos) << refusal("XKAP", "13");
}

TEST_F(Airports, AFolderWithoutASetSaysWhatToDo) {
  try {
    airport_folder(folder_ / "nowhere");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("apc-site/1"), std::string::npos);
  }
  EXPECT_EQ(airport_folder(folder_), folder_);
}

TEST(Cells, MayBeQuotedAndThenHoldAnything) {
  const auto rows = cells_of("a,\"b,\n\"\"c\"\"\"\r\n\n,\n", "x.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"a", "b,\n\"c\""}));
  EXPECT_EQ(rows[1], (std::vector<std::string>{"", ""}));
  EXPECT_THROW(cells_of("a,\"b", "x.csv"), InputError);
}

}  // namespace
}  // namespace apc::site
