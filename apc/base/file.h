/// Whole files: read at once; written under a temporary name and renamed, so a reader never sees half a file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace apc {

/// Throws InputError when the file is missing, a folder, or unreadable.
std::string read_text(const std::filesystem::path&);

/// Writes beside `path` under a name of this writer's own (`.part`), then renames it; creates missing parent folders.
/// Writers of one path at the same time leave one of their whole files. On failure nothing is left behind (InputError).
void write_text(const std::filesystem::path&, const std::string& text);

/// Same promise for writers that need a file name (HDF5): `write(part)` fills the temporary file.
void write_atomically(const std::filesystem::path&, const std::function<void(const std::filesystem::path&)>& write);

/// Where shipped data lives. Searched in this order: $APC_DATA, the source tree this program was built from, the
/// install prefix's share/apc. `relative` is e.g. "aircraft/data".
std::filesystem::path shipped(const std::filesystem::path& relative);

/// A path to an existing file is taken as it is; any other word is a name under the shipped folder
/// (`B737-800` → aircraft/data/B737-800.json). InputError lists the names there are, with the nearest one.
std::filesystem::path resolve(const std::string& name_or_path, const std::filesystem::path& shipped_folder,
                              const std::string& kind, const std::string& extension = ".json");

/// Names (file stems, sorted) of the files with `extension` in a shipped folder.
std::vector<std::string> shipped_names(const std::filesystem::path& shipped_folder,
                                       const std::string& extension = ".json");

}  // namespace apc
