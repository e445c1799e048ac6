/// `apc simulate` on shipped data, as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

const std::vector<std::string>& a_stop() {
  static const std::vector<std::string> words{"simulate", "--aircraft", "B737-800", "--bed",
                                              "bed.json", "--speed",    "70 kt"};
  return words;
}

std::vector<std::string> and_also(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Simulate, StopsA737AndWritesItsFilesWhereItSays) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  const auto said = run(folder, a_stop());
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_NE(said.out.find("out/B737-800_bed_70kt/report.html"), std::string::npos) << said.out;
  const std::set<std::string> expected{"bed.json",
                                       "out",
                                       "out/B737-800_bed_70kt",
                                       "out/B737-800_bed_70kt/history.csv",
                                       "out/B737-800_bed_70kt/history.h5",
                                       "out/B737-800_bed_70kt/report.html",
                                       "out/B737-800_bed_70kt/result.json"};
  EXPECT_EQ(folder.files(), expected);
  const auto json = nlohmann::json::parse(text_of(folder.path() / "out/B737-800_bed_70kt/result.json"));
  EXPECT_EQ(json.at("outcome"), "stopped");
  EXPECT_GT(json.at("stop_distance").get<double>(), 40.0);
  EXPECT_LT(json.at("stop_distance").get<double>(), 152.0);
  EXPECT_LT(json.at("energy").at("residual").get<double>(), 1e-5);
  EXPECT_NEAR(json.at("runway_distance").get<double>() - json.at("stop_distance").get<double>(), 50 * 0.3048, 1e-6);
}

TEST(Simulate, PageStandsAloneAndShowsEveryGear) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  ASSERT_EQ(run(folder, and_also(a_stop(), {"-o", "here"})).exit_code, 0);
  const auto page = text_of(folder.path() / "here/report.html");
  for (const char* word : {"http:", "https:", "src=", "@import"}) EXPECT_EQ(page.find(word), std::string::npos) << word;
  for (const char* part : {"Drag per nose strut", "Drag per main strut", "class=\"section\"", "Energy by sink",
                           "sha256", "apc simulate --aircraft B737-800"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_FALSE(std::regex_search(page, std::regex("[^a-zA-Z](nan|inf|NaN|Infinity)[^a-zA-Z]")));
}

TEST(Simulate, JsonFileIsTheSameRecord) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  ASSERT_EQ(run(folder, and_also(a_stop(), {"-o", "here", "--json", "record.json", "--quiet"})).exit_code, 0);
  EXPECT_EQ(text_of(folder.path() / "record.json"), text_of(folder.path() / "here/result.json"));
}

TEST(Simulate, QuietPrintsNothing) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  const auto said = run(folder, and_also(a_stop(), {"--quiet"}));
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(said.out, "");
  EXPECT_EQ(said.err, "");
}

TEST(Simulate, SpeaksTheUnitsAskedFor) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  const auto field = run(folder, a_stop()), si = run(folder, and_also(a_stop(), {"--units", "si"}));
  EXPECT_NE(field.out.find(" lbf"), std::string::npos);
  EXPECT_EQ(si.out.find(" lbf"), std::string::npos);
  EXPECT_NE(si.out.find(" kN"), std::string::npos);
}

TEST(Simulate, LeavingTheBedIsAResult) {
  const Folder folder;
  folder.write("bed.json", with(good_bed(), "[0, 50, 500]", "[0, 50, 80]"));
  const auto said = run(folder, and_also(a_stop(), {"-o", "here"}));
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "here/result.json"));
  EXPECT_TRUE(json.at("outcome") == "left_bed" || json.at("outcome") == "gear_limit") << json.at("outcome");
  EXPECT_TRUE(json.at("stop_distance").is_null());
  EXPECT_GT(json.at("exit_speed").get<double>(), 5.0);
}

TEST(Simulate, SpeedOutsideTheTablesIsAWarningNotAnError) {
  const Folder folder;
  folder.write("bed.json", with(good_bed(), "[0, 50, 500]", "[0, 50, 900]"));
  auto words = a_stop();
  words.back() = "100 kt";
  const auto said = run(folder, and_also(words, {"-o", "here"}));
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_NE(said.out.find("warning: the nose tire's speed lay above its load table for "), std::string::npos)
      << said.out.substr(0, 400);
  const auto json = nlohmann::json::parse(text_of(folder.path() / "here/result.json"));
  for (const auto* gear : {"nose", "main"}) {
    const auto& coverage = json.at("table_coverage_by_gear").at(gear);
    EXPECT_GT(coverage.at("speed_above").get<double>(), 0.05);  // from 100 kt down to the tables' 70
    EXPECT_LT(coverage.at("speed_below").get<double>(), 0.5);   // below 10 kt
    EXPECT_GT(coverage.at("speed_below").get<double>(), 0.0);
  }
  const auto page = text_of(folder.path() / "here/report.html");
  EXPECT_NE(page.find("too fast"), std::string::npos);
}

TEST(Simulate, EveryChosenInputStandsInItsRecord) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  const auto said =
      run(folder, and_also(a_stop(), {"--thrust", "idle", "--brake-mode", "torque", "--wheel-spin", "free", "--braking",
                                      "0.2", "--rut-bearing-gain", "1.5", "--rut-rolling-resistance", "0.05",
                                      "--pitch-inertia", "2.5e6 kg m^2", "-o", "here"}));
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto inputs = nlohmann::json::parse(text_of(folder.path() / "here/result.json")).at("inputs");
  EXPECT_NEAR(inputs.at("thrust").get<double>(), 2 * 0.0488 * 26300 * 4.4482216, 100.0);  // the file's idle
  EXPECT_EQ(inputs.at("brake_mode"), "torque");
  EXPECT_EQ(inputs.at("wheel_spin"), "free");
  EXPECT_EQ(inputs.at("rut_bearing_gain"), 1.5);
  EXPECT_EQ(inputs.at("rut_rolling_resistance"), 0.05);
  EXPECT_EQ(inputs.at("pitch_inertia"), 2.5e6);
}

TEST(Simulate, SensitivitiesAreTheSlopesOfRuns) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  const auto stop = [&](const char* thrust) {
    EXPECT_EQ(run(folder, and_also(a_stop(), {"--thrust", thrust, "--quiet", "-o", "run"})).exit_code, 0);
    return nlohmann::json::parse(text_of(folder.path() / "run/result.json")).at("stop_distance").get<double>();
  };
  const double slope = (stop("1 kN") - stop("-1 kN")) / 2000.0;
  const auto said = run(folder, and_also(a_stop(), {"--sensitivities", "thrust, mass", "-o", "here"}));
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto by = nlohmann::json::parse(text_of(folder.path() / "here/result.json")).at("sensitivities");
  EXPECT_EQ(by.size(), 2u);
  EXPECT_EQ(by.at("thrust").at("unit"), "N");
  EXPECT_NEAR(by.at("thrust").at("stop_distance").get<double>(), slope, 0.01 * slope);
  EXPECT_GT(by.at("mass").at("gears").at("nose").at("peak_vertical").get<double>(), 0.0);
  EXPECT_NE(said.out.find("derivative by one unit of"), std::string::npos);
  EXPECT_NE(said.out.find("mass, kg"), std::string::npos);
}

TEST(Simulate, SlowerEntryStopsShorter) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  double last = 0.0;
  for (const char* speed : {"40 kt", "55 kt", "70 kt"}) {
    auto words = a_stop();
    words.back() = speed;
    ASSERT_EQ(run(folder, and_also(words, {"-o", "here"})).exit_code, 0);
    const double stop =
        nlohmann::json::parse(text_of(folder.path() / "here/result.json")).at("stop_distance").get<double>();
    EXPECT_GT(stop, last);
    last = stop;
  }
}

TEST(Simulate, LeavesNoFormerResultWhenTheSolverGivesUp) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  ASSERT_EQ(run(folder, and_also(a_stop(), {"-o", "here", "--json", "record.json"})).exit_code, 0);
  folder.write("here/notes.txt", "the user's own");
  const auto before = folder.files();
  // Bad input is no run: it takes nothing away.
  EXPECT_EQ(run(folder, and_also(a_stop(), {"-o", "here", "--mass", "3 kg"})).exit_code, 2);
  EXPECT_EQ(folder.files(), before);
  // At an airspeed of 320 kt and so light it would fly: no trim, no run, and no result of the run before.
  auto gives_up = a_stop();
  gives_up.insert(gives_up.end(), {"--headwind", "120 kt", "--mass", "30 t", "-o", "here", "--json", "record.json"});
  gives_up[6] = "200 kt";
  const auto said = run(folder, gives_up);
  EXPECT_EQ(said.exit_code, 3) << said.err;
  EXPECT_EQ(said.error_lines(), 1u) << said.err;
  EXPECT_EQ(folder.files(), (std::set<std::string>{"bed.json", "here", "here/notes.txt"}));
}

TEST(Simulate, SameInputGivesTheSameNumbers) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  ASSERT_EQ(run(folder, and_also(a_stop(), {"-o", "a"})).exit_code, 0);
  ASSERT_EQ(run(folder, and_also(a_stop(), {"-o", "b"})).exit_code, 0);
  const auto numbers = [&](const char* name) {
    const auto text = text_of(folder.path() / name / "history.csv");
    return text.substr(text.find("\ntime"));
  };
  EXPECT_EQ(numbers("a"), numbers("b"));
}

}  // namespace
}  // namespace apc::scenarios
