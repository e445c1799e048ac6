// The scorer itself, on cases written here; and the score table of a folder of answers when one is named:
//   APC_CASES=… APC_ANSWERS=… validation_tests --gtest_filter=Score.TableOfAnswers
#include "scoring/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace scoring {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// A case with one true effect and no held-out runs.
fs::path make_case(const std::string& name, const std::string& kind, const std::string& effects,
                   const std::string& oracle) {
  const fs::path root = fs::temp_directory_path() / "apc_score_test" / "cases";
  write(root / name / "truth" / "truth.json",
        "{\"class\": \"" + kind + "\", \"verdict\": \"\", \"effects\": [" + effects + "]}");
  write(root / name / "truth" / "oracle.json", oracle);
  return root;
}

const char* const wall =
    R"({"id": "wall_tear", "law": "catalogue", "amplitude": "tau", "parameters": {"tau": "5000 N/m"}})";
const char* const decidable =
    R"({"decidable": true, "effects": [{"id": "wall_tear", "detectability": 11, "after_worst_rival": 8}],
  "work": {"run01": {"wall_tear": "100 kJ"}}})";

class Score : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(fs::temp_directory_path() / "apc_score_test"); }
  fs::path answers = fs::temp_directory_path() / "apc_score_test" / "answers";
};

TEST_F(Score, ARightAnswerScores) {
  const auto cases = make_case("a1", "M", wall, decidable);
  write(answers / "a1" / "diagnosis.json", R"({"verdict": "found", "effects": [{"id": "wall_tear", "probability": 0.9,
    "parameters": {"tau": "5500 N/m"}, "interval95": {"tau": ["4000 N/m", "7000 N/m"]}, "work": {"run01": "90 kJ"}}], "set90": [["wall_tear"]]})");
  const Table t = score(cases, answers);
  EXPECT_EQ(t.shares.at("1 first, M decidable").hits, 1);
  EXPECT_EQ(t.shares.at("2 truth in set90").hits, 1);
  EXPECT_EQ(t.shares.at("4 confident wrong").hits, 0);
  EXPECT_EQ(t.shares.at("7 interval holds the truth").hits, 1);
  EXPECT_NEAR(t.numbers.at("7 amplitude error, median"), 0.1, 1e-12);
  EXPECT_NEAR(t.numbers.at("7 work error, median"), 0.1, 1e-12);
  EXPECT_TRUE(t.failures.empty());
}

TEST_F(Score, AFalseAlarmAndAMissingAnswerCount) {
  make_case("n1", "N", "", "{}");
  const auto cases = make_case("n2", "N", "", "{}");
  write(answers / "n1.json", R"({"verdict": "found", "effects": [{"id": "inertial", "probability": 0.95}]})");
  const Table t = score(cases, answers);
  EXPECT_EQ(t.shares.at("3 false alarm").hits, 1);
  EXPECT_EQ(t.shares.at("4 confident wrong").hits, 1);
  EXPECT_EQ(t.shares.at("0 answered").hits, 1);
  EXPECT_EQ(t.shares.at("0 answered").of, 2);
}

TEST_F(Score, IntervalsAreClopperPearson) {
  const Share none{0, 59}, all{42, 42}, half{5, 10};
  EXPECT_NEAR(none.interval().second, 1.0 - std::pow(0.025, 1.0 / 59.0), 1e-6);
  EXPECT_NEAR(all.interval().first, std::pow(0.025, 1.0 / 42.0), 1e-6);
  EXPECT_NEAR(half.interval().first, 0.1871, 1e-4);  // exact binomial tables
  EXPECT_NEAR(half.interval().second, 0.8129, 1e-4);
}

TEST_F(Score, TableOfAnswers) {
  const char *cases = std::getenv("APC_CASES"), *folder = std::getenv("APC_ANSWERS");
  if (!cases || !folder) GTEST_SKIP() << "set APC_CASES and APC_ANSWERS to score a folder of answers";
  const Table t = score(cases, folder);
  for (const auto& line : t.failures) std::printf("%s\n", line.c_str());
  std::printf("%s", t.text.c_str());
  EXPECT_FALSE(t.text.empty());
}

}  // namespace
}  // namespace scoring
