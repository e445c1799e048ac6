/// Long work killed at any moment, without a chance to tidy up, continues where it was and ends with the same answer.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

/// Starts the words, kills the program after each of the pauses, and runs them to the end.
Said killed_and_continued(const Folder& folder, const std::vector<std::string>& words, const std::vector<int>& pauses) {
  for (const int milliseconds : pauses) {
    Running program(folder, words);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.kill();
    program.wait();
  }
  return run(folder, words);
}

/// The design without what differs from start to start: the clock, and the overruns this start simulated itself.
nlohmann::json lasting(const Folder& folder) {
  auto design = nlohmann::json::parse(text_of(folder.path() / "d/design.json"));
  for (const char* key : {"runs", "gave_up", "seconds", "provenance"}) design.erase(key);
  return design;
}

TEST(Resume, ADesignKilledAtAnyMomentEndsWithTheSameBed) {
  const std::vector<std::string> words{"design", "--fleet", "acrp29_crj_200", "-o", "d"};
  const Folder whole, killed;
  ASSERT_EQ(run(whole, words).exit_code, 0);
  const auto said = killed_and_continued(killed, words, {150, 400, 700, 1000});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(text_of(killed.path() / "d/bed.json"), text_of(whole.path() / "d/bed.json"));
  EXPECT_EQ(lasting(killed), lasting(whole));
}

TEST(Resume, ADesignStartedAgainSimulatesNothingTwice) {
  const std::vector<std::string> words{"design", "--fleet", "acrp29_crj_200", "-o", "d"};
  const Folder folder;
  ASSERT_EQ(run(folder, words).exit_code, 0);
  const auto first = lasting(folder);
  ASSERT_EQ(run(folder, words).exit_code, 0);
  const auto again = nlohmann::json::parse(text_of(folder.path() / "d/design.json"));
  EXPECT_EQ(again.at("runs"), 0);
  EXPECT_EQ(lasting(folder), first);
}

TEST(Resume, AStudyKilledAtAnyMomentEndsWithTheSameTable) {
  const std::vector<std::string> words{"study",    "--aircraft", "CRJ-200",  "--bed", "emas_18in_50psi",
                                       "--speeds", "40:80:1",    "--masses", "0.8,1", "--braking",
                                       "0,0.25",   "-o",         "s"};
  const Folder whole, killed;
  ASSERT_EQ(run(whole, words).exit_code, 0);
  const auto said = killed_and_continued(killed, words, {60, 120, 200});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(text_of(killed.path() / "s/study.csv"), text_of(whole.path() / "s/study.csv"));
}

TEST(Resume, AStoreOfOtherWorkIsRefusedAndLeftAlone) {
  const Folder folder;
  ASSERT_EQ(
      run(folder, {"study", "--aircraft", "CRJ-200", "--bed", "emas_18in_50psi", "--speeds", "40:50:5", "-o", "s"})
          .exit_code,
      0);
  const auto before = text_of(folder.path() / "s/cases.store");
  const auto said =
      run(folder, {"study", "--aircraft", "B737-800", "--bed", "emas_18in_50psi", "--speeds", "40:50:5", "-o", "s"});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.err.find("cases.store"), std::string::npos) << said.err;
  EXPECT_EQ(text_of(folder.path() / "s/cases.store"), before);
}

TEST(Study, SaysWhichCasesTheSolverGaveUpInAndEndsWithThree) {
  const Folder folder;
  auto plane = text_of(PROJECT_DIR "/aircraft/data/B737-800.json");
  auto kite = with(plane, "\"CL\": 0.25", "\"CL\": 3.5");  // flies at 110 kt, rolls at 40
  ASSERT_NE(kite, plane);
  folder.write("kite.json", kite);
  const std::vector<std::string> words{"study", "--aircraft", "kite.json", "--bed", "emas_18in_50psi", "--speeds"};
  const auto study = [&](const char* speeds) {
    auto all = words;
    all.insert(all.end(), {speeds, "-o", "s"});
    return run(folder, all);
  };
  EXPECT_EQ(study("40").exit_code, 0);
  const auto said = study("40, 110");
  EXPECT_EQ(said.exit_code, 3) << said.err;
  EXPECT_NE(said.err.find("gave up in 1 of 2 cases"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("110 kt"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("it would fly"), std::string::npos) << said.err;
  const auto table = text_of(folder.path() / "s/study.csv");
  EXPECT_NE(table.find("gave_up"), std::string::npos);
  EXPECT_NE(table.find("speed_above"), std::string::npos);
}

}  // namespace
}  // namespace apc::scenarios
