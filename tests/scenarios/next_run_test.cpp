// `apc next` on the measured case with joints: what a user reads, the record, the page, and bad input.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

const std::string joints = PROJECT_DIR "/tests/validation/cases/joints";

const char* const two_stand = R"({
  "schema": "apc-diagnosis/1", "verdict": "ambiguous",
  "effects": [ { "id": "inertial", "probability": 0.5, "parameters": { "C": 0.3 } } ],
  "set90": [ ["inertial"], ["wall_tear"] ] })";

std::vector<std::string> next(std::vector<std::string> more) {
  std::vector<std::string> words = {"next", joints,     "--from",      "d.json",   "--threads",
                                    "1",    "--speeds", "30:70:20 kt", "--masses", "17:21:4 t"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Next, NamesARunAndWhatEachExplanationWouldShowThere) {
  const Folder folder;
  folder.write("d.json", two_stand);
  const auto said = run(folder, next({"--json", "next.json", "-o", "next.html"}));
  ASSERT_EQ(said.exit_code, 0) << said.err;
  for (const char* part :
       {"NEXT RUN", "WHAT EACH WOULD SHOW", "inertial", "wall_tear", "sigma", "stops at", "SEPARATION"})
    EXPECT_NE(said.out.find(part), std::string::npos) << part << "\n" << said.out;

  const auto plan = nlohmann::json::parse(text_of(folder.path() / "next.json"));
  EXPECT_EQ(plan.at("schema"), "apc-next/1");
  EXPECT_EQ(plan.at("purpose"), "separate");
  ASSERT_EQ(plan.at("runs").size(), 6u);
  ASSERT_FALSE(plan.at("next").empty());
  double most = 0.0;
  for (const auto& candidate : plan.at("runs")) {
    ASSERT_TRUE(candidate.at("simulated"));
    ASSERT_EQ(candidate.at("expects").size(), 2u);
    if (candidate.at("stops")) most = std::max(most, candidate.at("separation").back().get<double>());
  }
  EXPECT_GT(most, 1.0);
  // The recommended run is the best of the grid, with the cheapest instruments that keep nine tenths of it.
  EXPECT_GE(plan.at("next")[0].at("separation").get<double>(), 0.9 * most - 1e-4);
  EXPECT_NE(text_of(folder.path() / "next.html").find("entry speed, kt"), std::string::npos);
}

TEST(Next, WithNothingToSeparateItSharpensWhatCouldBeSeen) {
  const Folder folder;
  folder.write("d.json", R"({"schema": "apc-diagnosis/1", "verdict": "nothing", "effects": [], "set90": [[]]})");
  const auto said = run(folder, {"next", joints, "--from", "d.json", "--threads", "1", "--speeds", "50 kt", "--masses",
                                 "20 t", "--json", "next.json"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto plan = nlohmann::json::parse(text_of(folder.path() / "next.json"));
  EXPECT_EQ(plan.at("purpose"), "sharpen");
  EXPECT_GT(plan.at("next")[0].at("separation").get<double>(), plan.at("separation_now").get<double>());
}

TEST(Next, SeparatesRivalsOfTheUsersChoice) {
  const Folder folder;
  const auto said = run(folder, {"next", joints, "--rivals", "inertial,wall_tear+slope,nothing", "--threads", "1",
                                 "--speeds", "50 kt", "--masses", "20 t"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  for (const char* part : {"inertial", "slope + wall_tear", "nothing missing"})
    EXPECT_NE(said.out.find(part), std::string::npos) << part << "\n" << said.out;
}

TEST(Next, BadInputIsOneMessage) {
  const Folder folder;
  folder.write("d.json", two_stand);
  folder.write("model.json", R"({"schema": "apc-model/1", "source": "x", "effects": []})");
  folder.write("unknown.json", R"({"schema": "apc-diagnosis/1", "effects": [], "set90": [["sems"]]})");
  folder.write("shape.json", R"({"schema": "apc-diagnosis/1", "effects": [], "set90": ["seams"]})");
  expect_refused(folder, {"next", joints, "--from", "none.json"}, {"none.json"});
  expect_refused(folder, {"next", joints, "--from", "model.json"}, {"model.json", "apc-diagnosis/1"});
  expect_refused(folder, {"next", joints, "--from", "unknown.json"}, {"sems", "seams"});
  expect_refused(folder, {"next", joints, "--from", "shape.json"}, {"shape.json", "set90"});
  expect_refused(folder, {"next", joints, "--from", "d.json", "--speeds", "30:20:5 kt"}, {"--speeds", "30:20:5 kt"});
  expect_refused(folder, {"next", joints, "--from", "d.json", "--speeds", "30 kg"}, {"--speeds"});
  expect_refused(folder, {"next", joints, "--from", "d.json", "--masses", "1:100000:1 kg"}, {"--masses", "40"});
  expect_refused(folder, {"next", joints}, {"--from", "--rivals"});
  expect_refused(folder, {"next", joints, "--rivals", "inertial,,slope"}, {"--rivals", "empty"});
  expect_refused(folder, {"next", joints, "--rivals", "inertia"}, {"inertial"});
  expect_refused(folder, {"next", "nowhere", "--from", "d.json"}, {"nowhere"});
}

}  // namespace
}  // namespace apc::scenarios
