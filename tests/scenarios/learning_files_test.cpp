// The files of measured runs as a user meets them: described key by key, checked without running anything.
#include <gtest/gtest.h>

#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(PROJECT_DIR) / "designs/cases";

TEST(LearningFiles, AreDescribedKeyByKey) {
  const Folder folder;
  for (const auto& [schema, key] :
       {std::pair{"apc-case/1", "scatter.bed_strength"}, {"apc-run/1", "stop.value"}, {"apc-effect/1", "acts_on"}}) {
    const auto said = run(folder, {"describe", schema});
    EXPECT_EQ(said.exit_code, 0) << schema;
    EXPECT_NE(said.out.find(key), std::string::npos) << schema;
  }
}

TEST(LearningFiles, OfTheTutorialsPassTheCheck) {
  const Folder folder;
  std::vector<std::string> words{"check", (cases / "own_effect/hump.json").string()};
  for (const auto& entry : fs::directory_iterator(cases)) words.push_back((entry.path() / "case.json").string());
  ASSERT_EQ(words.size(), 7u);
  const auto said = run(folder, words);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_NE(said.out.find("FAA B727 in phenolic foam: two stops, 2 runs"), std::string::npos) << said.out;
}

TEST(LearningFiles, WithFaultsAreRefusedWithTheirPlace) {
  const Folder folder;
  fs::copy(cases / "faa_b727", folder.path() / "faa", fs::copy_options::recursive);
  const std::string good =
      with(with(text_of(folder.path() / "faa/case.json"), "../../../aircraft", fs::path(PROJECT_DIR) / "aircraft"),
           "../../../aircraft", fs::path(PROJECT_DIR) / "aircraft");
  folder.write("faa/case.json", good);
  EXPECT_EQ(run(folder, {"check", "faa/case.json"}).exit_code, 0);
  folder.write("faa/case.json", with(good, "\"bed_strength\": 0.3", "\"bed_strength\": 30"));
  expect_refused(folder, {"compare", "faa"}, {"bed_strength", "30", "0.04"});
  folder.write("faa/case.json", with(good, "\"runs/from_50_kt.json\",", ""));
  EXPECT_EQ(run(folder, {"check", "faa/case.json"}).exit_code, 0);
  // A run of which nothing is known is set aside; with no other left the case is refused, and says why.
  const auto one = text_of(folder.path() / "faa/runs/from_60_kt.json");
  folder.write("faa/runs/from_60_kt.json", with(one, "\"stop\"", "\"stopp\""));
  expect_refused(folder, {"compare", "faa"}, {"no usable run", "from_60_kt", "stop"});
}

}  // namespace
}  // namespace apc::scenarios
