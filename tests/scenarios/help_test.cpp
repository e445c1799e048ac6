/// What the program says about itself.
#include <gtest/gtest.h>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

TEST(Help, EveryCommandExplainsItself) {
  const Folder folder;
  for (const char* command : {"simulate", "check", "describe", "list"}) {
    const auto said = run(folder, {command, "--help"});
    EXPECT_EQ(said.exit_code, 0) << command;
    EXPECT_NE(said.out.find("Usage: apc "), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("--json"), std::string::npos) << command;
  }
}

TEST(Help, ProgramListsItsCommandsAndExitCodes) {
  const Folder folder;
  const auto said = run(folder, {"--help"});
  EXPECT_EQ(said.exit_code, 0);
  for (const char* word : {"simulate", "check", "describe", "list", "3 a solver gave up"})
    EXPECT_NE(said.out.find(word), std::string::npos) << word;
  EXPECT_TRUE(run(folder, {"--version"}).out.starts_with("apc "));
}

TEST(Describe, DocumentsEveryFormatItLists) {
  const Folder folder;
  const auto list = run(folder, {"describe"});
  EXPECT_EQ(list.exit_code, 0);
  for (const char* schema :
       {"apc-aircraft/1", "apc-tire/1", "apc-bed/1", "apc-loads/1", "apc-sph/1", "apc-model/1", "apc-manifest/1"}) {
    EXPECT_NE(list.out.find(schema), std::string::npos) << schema;
    const auto said = run(folder, {"describe", schema});
    EXPECT_EQ(said.exit_code, 0);
    EXPECT_NE(said.out.find("required"), std::string::npos) << schema;
  }
}

TEST(List, NamesShippedDataThatPassesTheCheck) {
  const Folder folder;
  const auto aircraft = run(folder, {"list", "aircraft"});
  EXPECT_EQ(aircraft.exit_code, 0) << aircraft.err;
  for (const char* name : {"CRJ-200", "B737-800", "B747-400"})
    EXPECT_NE(aircraft.out.find(name), std::string::npos) << name;
  for (const char* kind : {"tires", "beds", "loads"}) EXPECT_EQ(run(folder, {"list", kind}).exit_code, 0) << kind;
  std::vector<std::string> words{"check"};
  for (const char* data : {"aircraft/data", "designs/beds", "loadtables/data"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(PROJECT_DIR) / data))
      if (entry.path().extension() == ".json" || entry.path().extension() == ".h5")
        words.push_back(entry.path().string());
  const auto said = run(folder, words);
  EXPECT_EQ(said.exit_code, 0) << said.err;
}

}  // namespace
}  // namespace apc::scenarios
