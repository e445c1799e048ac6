/// Who may include whom. CMake links libraries but cannot forbid an include; this reads every one.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "tests/architecture/source_tree.h"

namespace apc::architecture {
namespace {

/// Each layer with the layers it may include; a folder may always include itself.
const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::set<std::string> data{"apc/base", "aircraft", "loadtables", "apc/bed"};
  static const auto with = [](std::set<std::string> below, const std::set<std::string>& more) {
    below.insert(more.begin(), more.end());
    return below;
  };
  static const auto effects = data, simulation = with(effects, {"apc/effects"}),
                    above = with(simulation, {"apc/simulation"});
  static const auto report = with(above, {"apc/learning", "apc/study", "apc/design", "apc/reliability", "apc/site"});
  static const std::map<std::string, std::set<std::string>> table{
      {"apc/base", {}},
      {"aircraft", {"apc/base"}},
      {"loadtables", {"apc/base"}},
      {"sph_backend", {"apc/base"}},
      {"apc/bed", {"apc/base"}},
      {"apc/site", {"apc/base", "apc/bed"}},
      {"apc/effects", effects},
      {"apc/simulation", simulation},
      {"apc/learning", above},
      {"apc/study", above},
      {"apc/design", with(above, {"apc/study"})},
      {"apc/reliability", with(above, {"apc/study"})},
      {"apc/report", report},
      {"apc/cli", with(report, {"apc/report", "sph_backend"})},
      {"apc/python", with(report, {"apc/report", "apc/cli"})},
  };
  return table;
}

/// "apc/bed/bed.h" → "apc/bed"; "aircraft/tire.h" → "aircraft".
std::string layer_of(const std::string& path) {
  const auto first = path.find('/');
  if (first == std::string::npos) return "";
  if (path.substr(0, first) != "apc") return path.substr(0, first);
  const auto second = path.find('/', first + 1);
  return second == std::string::npos ? "apc" : path.substr(0, second);
}

/// Every `#include` of a file: what stands between the quotes or brackets.
std::vector<std::string> includes_of(const SourceFile& file) {
  static const std::regex form("^\\s*#\\s*include\\s*[\"<]([^\">]+)[\">]");
  std::vector<std::string> found;
  std::smatch match;
  for (const auto& line : file.lines)
    if (std::regex_search(line, match, form)) found.push_back(match[1]);
  return found;
}

bool ends_with_any(const std::string& path, const std::vector<std::string>& ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const std::string& end) { return path.ends_with(end); });
}

TEST(Architecture, LayersIncludeOnlyTheLayersBelowThem) {
  std::size_t checked = 0;
  for (const auto& file : files_in(code_folders(), code_extensions())) {
    const auto layer = layer_of(file.path);
    ASSERT_TRUE(allowed().contains(layer)) << file.path << ": the folder is in no layer of this test's table";
    for (const auto& include : includes_of(file)) {
      const auto target = layer_of(include);
      if (!allowed().contains(target)) continue;  // a library
      ++checked;
      EXPECT_TRUE(target == layer || allowed().at(layer).contains(target))
          << file.path << " may not include " << include;
    }
  }
  EXPECT_GT(checked, 50u) << "the test reads nothing";
}

TEST(Architecture, EachLibraryIsKnownInOnePlaceOnly) {
  for (const auto& file : files_in(code_folders(), code_extensions())) {
    for (const auto& include : includes_of(file)) {
      const auto only = [&](const char* library, bool ok) {
        EXPECT_TRUE(ok || !include.starts_with(library)) << file.path << " may not include " << include;
      };
      only("nlohmann/json.hpp", ends_with_any(file.path, {"_json.cpp", "apc/base/json.cpp"}));
      only("nlohmann/json_fwd.hpp", ends_with_any(file.path, {"_json.cpp", "_json.h", "apc/base/json.h"}));
      only("hdf5", ends_with_any(file.path, {"_hdf5.cpp", "apc/base/hdf5.cpp"}));
      only("H5", ends_with_any(file.path, {"_hdf5.cpp", "apc/base/hdf5.cpp"}));
      const bool solver = file.path.starts_with("apc/simulation/cvode");
      for (const char* library : {"cvodes/", "cvode/", "sundials/", "nvector/", "sunmatrix/", "sunlinsol/"})
        only(library, solver);
      only("CLI/", layer_of(file.path) == "apc/cli");
      only("pybind11/", layer_of(file.path) == "apc/python");
      only("nlopt", layer_of(file.path) == "apc/design");
    }
  }
}

}  // namespace
}  // namespace apc::architecture
