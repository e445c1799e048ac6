/// `apc reliability`: killed at any moment it goes on where it was; what is wrong with its input is told at once.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/design_files.h"
#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

nlohmann::json record_without_clock(const Folder& folder, const std::string& name) {
  auto record = nlohmann::json::parse(text_of(folder.path() / name));
  record.erase("seconds");
  record.erase("provenance");
  return record;
}

TEST(ReliabilityProgram, KilledItLosesNothingFinishedAndEndsWithTheSameNumbers) {
  const Folder folder;
  make_design(folder);
  const std::vector<std::string> words{"reliability", "--design", "d/design.json", "--samples", "600", "--quiet"};
  auto whole = words, torn = words;
  whole.insert(whole.end(), {"-o", "whole"});
  torn.insert(torn.end(), {"-o", "torn"});
  ASSERT_EQ(run(folder, whole).exit_code, 0);

  const auto store = folder.path() / "torn/case_1.store";
  std::size_t kept = 0;
  for (int kills = 0; kills < 3; ++kills) {
    Running program(folder, torn);
    const auto before = kept;
    for (int i = 0; i < 3000 && !program.ended(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      const auto text = text_of(store);
      kept = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
      if (kept > before + 40) break;
    }
    program.kill();
    program.wait();
    EXPECT_GT(kept, before);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "torn/reliability.json"));
  ASSERT_LT(kept, 600u) << "nothing was left to do: the test kills too late";
  std::ofstream(store, std::ios::app) << "0123456789abcdef half a li";  // as a write cut short would leave it
  const auto said = run(folder, torn);
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(record_without_clock(folder, "torn/reliability.json"),
            record_without_clock(folder, "whole/reliability.json"));
}

TEST(ReliabilityProgram, RefusesWhatIsWrong) {
  const Folder folder;
  make_design(folder);
  const auto scatter = [&](const std::string& more) {
    return folder.write("s.json", R"({"schema": "apc-scatter/1", "source": "test")" + more + "}");
  };
  const auto with_scatter = [&](const std::string& more, const std::vector<std::string>& mentions) {
    scatter(more);
    expect_refused(folder, {"reliability", "--design", "d/design.json", "--scatter", "s.json"}, mentions);
    expect_refused(folder, {"check", "s.json"}, mentions);
  };
  with_scatter(R"(, "mass": 3)", {"s.json", "/mass", "0 to 0.3"});
  with_scatter(R"(, "braking": [0.3, 0.1])", {"/braking", "[0, 0.25]"});
  with_scatter(R"(, "years": [0])", {"/years", "two numbers"});
  with_scatter(R"(, "correlation": 2)", {"/correlation", "no unit"});
  with_scatter(R"(, "strenght": 0.1)", {"strenght", "strength"});
  expect_refused(folder, {"reliability", "--design", "d/design.json", "--samples", "7"}, {"--samples", "7"});
  expect_refused(folder, {"reliability", "--design", "d/bed.json"}, {"d/bed.json", "is no design"});
  auto old = text_of(folder.path() / "d/design.json");
  folder.write("old.json", with(old, "apc-design/1", "apc-design/0"));
  expect_refused(folder, {"reliability", "--design", "old.json"}, {"old.json", "apc-design/0", "another version"});
  expect_refused(folder, {"report", "--design", "old.json"}, {"old.json", "apc-design/0", "another version"});
  folder.write("none.json", with(old, "\"feasible\": true", "\"feasible\": false"));
  expect_refused(folder, {"reliability", "--design", "none.json"}, {"none.json", "/feasible", "Relax"});
}

}  // namespace
}  // namespace apc::scenarios
