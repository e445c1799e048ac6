/// The manifest of a report makes it again, byte for byte, and notices when it cannot.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/design_files.h"
#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

const char* const site = R"({ "schema": "apc-site/1", "name": "an end", "source": "made for a test",
  "runway_end": { "latitude": "45 deg", "longitude": "10 deg", "true_heading": "92 deg", "width": "150 ft" },
  "safety_area": { "length": "1000 ft", "width": "500 ft" }, "minimum_setback": "35 ft" })";

TEST(ReportManifest, MakesTheReportAgainByteForByte) {
  const Folder folder;
  make_design(folder);
  folder.write("site.json", site);
  const auto first = run(folder, {"report", "--design", "d/design.json", "--site", "site.json", "-o", "r"});
  ASSERT_TRUE(first.exit_code == 0 || first.exit_code == 1) << first.err;
  const auto again = run(folder, {"report", "--manifest", "r/manifest.json", "-o", "again", "--threads", "1"});
  EXPECT_EQ(again.exit_code, first.exit_code) << again.err;
  EXPECT_NE(again.out.find("the same bytes"), std::string::npos) << again.out;
  for (const char* name : {"report.html", "report.json", "manifest.json", "site.geojson", "site.kml"}) {
    const auto one = text_of(folder.path() / "r" / name), other = text_of(folder.path() / "again" / name);
    EXPECT_GT(one.size(), 500u) << name;
    EXPECT_TRUE(one == other) << name;
  }

  EXPECT_EQ(run(folder, {"check", "r/manifest.json"}).exit_code, 0);

  // Someone else's bytes are noticed.
  auto manifest = nlohmann::ordered_json::parse(text_of(folder.path() / "r/manifest.json"));
  manifest["made"][0]["sha256"] = std::string(64, '0');
  folder.write("forged.json", manifest.dump());
  const auto forged = run(folder, {"report", "--manifest", "forged.json", "-o", "third"});
  EXPECT_EQ(forged.exit_code, 1);
  EXPECT_NE(forged.err.find("report.html differs"), std::string::npos) << forged.err;

  // So is an input that has changed since, before anything is run.
  folder.write("site.json", with(site, "35 ft", "40 ft"));
  expect_refused(folder, {"report", "--manifest", "r/manifest.json", "-o", "fourth"},
                 {"r/manifest.json", "site.json", "has changed since"});
  expect_refused(folder, {"check", "r/manifest.json"}, {"r/manifest.json", "site.json", "has changed since"});
  manifest["program"] = "apc 0.0.1";
  folder.write("old.json", manifest.dump());
  expect_refused(folder, {"report", "--manifest", "old.json"}, {"old.json", "/program", "another version"});
  expect_refused(folder, {"check", "old.json"}, {"old.json", "/program", "another version"});
  manifest.erase("arguments");
  manifest["program"] = nlohmann::ordered_json::parse(text_of(folder.path() / "forged.json"))["program"];
  manifest["files"] = nlohmann::ordered_json::array();
  folder.write("cut.json", manifest.dump());
  expect_refused(folder, {"check", "cut.json"}, {"cut.json", "/arguments", "missing"});
  expect_refused(folder, {"report", "--manifest", "r/manifest.json", "--site", "site.json"}, {"--manifest"});
  expect_refused(folder, {"report"}, {"--design"});
}

TEST(ReportManifest, ASiteThatEndsBeforeTheBedIsRefused) {
  const Folder folder;
  make_design(folder);
  folder.write("short.json", with(with(site, "1000 ft", "49 ft"), "35 ft", "10 ft"));
  expect_refused(folder, {"report", "--design", "d/design.json", "--site", "short.json"},
                 {"/safety_area/length", "shorter than the bed's set-back"});
  folder.write("none.json", with(site, "1000 ft", "30 ft"));  // not even its own least set-back fits
  expect_refused(folder, {"report", "--design", "d/design.json", "--site", "none.json"},
                 {"none.json", "/minimum_setback"});
  expect_refused(folder, {"check", "none.json"}, {"none.json", "/minimum_setback"});
}

/// Every verdict the page shows carries the clause's own status, and no recalled clause passes or fails.
TEST(ReportManifest, RecalledClausesAreMarkedAndNeverPass) {
  const Folder folder;
  make_design(folder);
  const auto said = run(folder, {"report", "--design", "d/design.json", "-o", "r", "--quiet"});
  ASSERT_TRUE(said.exit_code == 0 || said.exit_code == 1) << said.err;
  const auto record = nlohmann::json::parse(text_of(folder.path() / "r/report.json"));
  std::size_t read = 0, recalled = 0;
  for (const auto& each : record.at("requirements")) {
    each.at("clause_read").get<bool>() ? ++read : ++recalled;
    if (!each.at("clause_read").get<bool>()) {
      EXPECT_EQ(each.at("result"), "not verified") << each.at("clause");
    }
  }
  EXPECT_GE(read, 12u);
  EXPECT_GE(recalled, 16u);
  const auto page = text_of(folder.path() / "r/report.html");
  std::size_t tags = 0;
  for (auto at = page.find(">recalled<"); at != std::string::npos; at = page.find(">recalled<", at + 1)) ++tags;
  EXPECT_EQ(tags, recalled);
  for (const char* outside : {"http://", "https://", "src=", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside << ": the page is not self-contained";
}

}  // namespace
}  // namespace apc::scenarios
