/// `apc site`: from a file or from an installed airport data set to a placed bed.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

const char* const runways =
    "\"id\",\"airport_ref\",\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\",\"le_"
    "ident\","
    "\"le_latitude_deg\",\"le_longitude_deg\",\"le_elevation_ft\",\"le_heading_degT\",\"le_displaced_threshold_ft\","
    "\"he_ident\",\"he_latitude_deg\",\"he_longitude_deg\",\"he_elevation_ft\",\"he_heading_degT\","
    "\"he_displaced_threshold_ft\"\n"
    "1,1,\"XKAP\",5171,148,\"ASP\",1,0,\"09\",45.00000,10.00000,102,90,,\"27\",45.00000,10.02000,98,270,500\n";

TEST(SiteProgram, WritesASiteFromADataSetThatTheReportTakes) {
  const Folder folder;
  folder.write("runways.csv", runways);
  const auto said = run(folder, {"site", "--airport", "XKAP", "--runway", "09", "--data", ".", "--safety-length",
                                 "1000 ft", "--safety-width", "500 ft", "--bed", "emas_18in_50psi", "-o", "s"});
  ASSERT_EQ(said.exit_code, 0) << said.err << said.out;
  const auto site = nlohmann::json::parse(text_of(folder.path() / "s/site.json"));
  EXPECT_EQ(site.at("runway_end").at("longitude"), "10.020000000 deg");
  EXPECT_EQ(site.at("displaced_threshold"), "152.400 m");
  EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "s/site.geojson")).at("type"), "FeatureCollection");
  EXPECT_EQ(run(folder, {"check", "s/site.json"}).exit_code, 0);
  const auto placed =
      run(folder, {"site", "--site", "s/site.json", "--bed", "emas_24in_50psi", "-o", "t", "--json", "p.json"});
  EXPECT_EQ(placed.exit_code, 0) << placed.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "p.json")).at("checks").size(), 5u);
}

TEST(SiteProgram, SaysWhatDoesNotFit) {
  const Folder folder;
  folder.write("runways.csv", runways);
  const auto said = run(folder, {"site", "--airport", "XKAP", "--runway", "27", "--data", ".", "--safety-length",
                                 "300 ft", "--safety-width", "500 ft", "--bed", "emas_18in_50psi", "-o", "s"});
  EXPECT_EQ(said.exit_code, 1) << said.err;
  EXPECT_NE(said.out.find("FAIL"), std::string::npos) << said.out;
}

TEST(SiteProgram, RefusesWhatIsWrong) {
  const Folder folder;
  folder.write("runways.csv", runways);
  expect_refused(folder, {"site"}, {"--site", "--airport"});
  expect_refused(folder, {"site", "--airport", "XKAP", "--data", "."}, {"--runway"});
  expect_refused(folder, {"site", "--airport", "XKAP", "--runway", "09", "--data", "."}, {"--safety-length"});
  const std::vector<std::string> area{"--safety-length", "1000 ft", "--safety-width", "500 ft"};
  const auto with_area = [&](std::vector<std::string> words) {
    words.insert(words.end(), area.begin(), area.end());
    return words;
  };
  expect_refused(folder, with_area({"site", "--airport", "XKAP", "--runway", "10", "--data", "."}), {"10", "09, 27"});
  expect_refused(folder, with_area({"site", "--airport", "XKAP", "--runway", "09", "--data", "nowhere"}),
                 {"no airport data set", "nowhere", "apc-site/1"});
  folder.write("runways.csv", std::string(runways) + "2,1,\"XKA");
  expect_refused(folder, with_area({"site", "--airport", "XKAP", "--runway", "09", "--data", "."}),
                 {"runways.csv", "quote"});
}

}  // namespace
}  // namespace apc::scenarios
