/// The project's own files, read for the tests of its shape.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace apc::architecture {

struct SourceFile {
  std::string path;  ///< from the project's root, "apc/bed/bed.cpp"
  std::vector<std::string> lines;
};

inline std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Files with one of the extensions in these top-level folders, sorted by path.
inline std::vector<SourceFile> files_in(const std::vector<std::string>& folders,
                                        const std::vector<std::string>& extensions) {
  const std::filesystem::path root(PROJECT_DIR);
  std::vector<SourceFile> files;
  for (const auto& folder : folders) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension().string();
      if (!entry.is_regular_file() || std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
        continue;
      files.push_back({entry.path().lexically_relative(root).generic_string(), lines_of(entry.path())});
    }
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

inline const std::vector<std::string>& code_folders() {
  static const std::vector<std::string> folders{"apc", "aircraft", "loadtables", "sph_backend"};
  return folders;
}

inline const std::vector<std::string>& code_extensions() {
  static const std::vector<std::string> extensions{".h", ".cpp", ".inl"};
  return extensions;
}

}  // namespace apc::architecture
