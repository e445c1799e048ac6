/// Habits that keep the code readable: SI names inside, short files, and a project that speaks of itself alone.
#include <gtest/gtest.h>

#include <regex>

#include "tests/architecture/source_tree.h"

namespace apc::architecture {
namespace {

TEST(Architecture, UnitsInNamesStandOnlyAtTheEdges) {
  // SI has bare names inside; a name such as speed_kt marks a value in another unit and belongs where files and people
  // are met.
  const std::regex suffix(
      "\\b[A-Za-z][A-Za-z0-9_]*_(kt|kts|ft|lbf|lbs|psi|kip|kN|kPa|MPa|mm|deg|rpm|mph|lbm|inch|inches)\\b");
  for (const auto& file : files_in(code_folders(), code_extensions())) {
    const bool edge = file.path.starts_with("apc/report/") || file.path.starts_with("apc/cli/") ||
                      file.path.find("_json.") != std::string::npos || file.path == "apc/base/units.h" ||
                      file.path == "apc/base/quantity.cpp" ||
                      file.path == "apc/site/airports.cpp";  // names the columns of a foreign format
    if (edge) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto code = file.lines[i].substr(0, file.lines[i].find("//"));
      std::smatch match;
      EXPECT_FALSE(std::regex_search(code, match, suffix)) << file.path << ":" << i + 1 << ": \"" << match.str()
                                                           << "\" names a unit; inside, values are SI and names bare";
    }
  }
}

TEST(Architecture, NoFileIsLongerThan400Lines) {
  for (const auto& file : files_in({"apc", "aircraft", "loadtables", "sph_backend", "tests"}, code_extensions()))
    EXPECT_LE(file.lines.size(), 400u) << file.path << ": split it by meaning";
}

TEST(Architecture, HeadersSayFirstWhatTheyAre) {
  for (const auto& file : files_in(code_folders(), {".h"})) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines.front().starts_with("///")) << file.path << ": its first line is no description";
  }
}

TEST(Architecture, StartSectionHasExactlyTwoCommands) {
  const auto readme = lines_of(std::filesystem::path(PROJECT_DIR) / "README.md");
  ASSERT_FALSE(readme.empty()) << "README.md is missing";
  const auto start = std::find(readme.begin(), readme.end(), "## Start");
  ASSERT_NE(start, readme.end()) << "README.md has no section \"## Start\"";
  const auto section_end =
      std::find_if(start + 1, readme.end(), [](const std::string& line) { return line.starts_with("## "); });
  std::vector<std::string> fenced;
  bool inside = false;
  int fences = 0;
  for (auto line = start + 1; line != section_end; ++line) {
    if (line->starts_with("```")) {
      inside = !inside, ++fences;
    } else if (inside) {
      fenced.push_back(*line);
    }
  }
  EXPECT_EQ(fences, 2) << "one fenced block is wanted";
  ASSERT_EQ(fenced.size(), 2u);
  for (const auto& line : fenced) EXPECT_NE(line.find_first_not_of(' '), std::string::npos);
}

TEST(Architecture, TheProjectSpeaksOfItselfAlone) {
  // Written in two halves, so that this file does not hold what it looks for.
  const std::vector<std::string> words{std::string("sub") + "agent",     std::string("language ") + "model",
                                       std::string("this ") + "session", std::string("issue ") + "#",
                                       std::string("/tm") + "p/",        std::string("/wor") + "k/",
                                       std::string("shared") + "/"};
  const std::vector<std::string> text{".h", ".cpp", ".inl", ".md", ".json", ".txt", ".cmake", ".csv"};
  auto files = files_in({"apc", "aircraft", "loadtables", "sph_backend", "designs", "tests"}, text);
  for (const char* top : {"README.md", "CMakeLists.txt", "CMakePresets.json"})
    files.push_back({top, lines_of(std::filesystem::path(PROJECT_DIR) / top)});
  for (const auto& file : files)
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      for (const auto& word : words)
        EXPECT_EQ(file.lines[i].find(word), std::string::npos)
            << file.path << ":" << i + 1 << ": \"" << word << "\" has no place here";
}

}  // namespace
}  // namespace apc::architecture
