#include "apc/base/file.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "apc/base/quantity.h"
#include "apc/base/require.h"

namespace apc {
namespace fs = std::filesystem;

namespace {

/// `path.PROCESS.COUNT.part`: no two writers share a name, so each renames its own whole file and the last one wins.
fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> count{0};
  fs::path part = path;
  part += concat(".", getpid(), ".", count++, ".part");
  return part;
}

}  // namespace

std::string read_text(const fs::path& path) {
  std::error_code error;
  require(fs::exists(path, error), path.string(), ": no such file");
  require(!fs::is_directory(path, error), path.string(), ": is a folder, a file is needed");
  std::ifstream stream(path, std::ios::binary);
  require(stream.good(), path.string(), ": cannot be opened for reading");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  require(!error, path.string(), ": cannot make the folder (", error.message(), ")");
  const auto part = temporary_name(path);
  try {
    write(part);
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
  fs::rename(part, path, error);
  if (!error) return;
  const auto why = error.message();
  fs::remove(part, error);
  throw InputError(concat(path.string(), ": cannot be written (", why, ")"));
}

void write_text(const fs::path& path, const std::string& text) {
  write_atomically(path, [&](const fs::path& part) {
    std::ofstream stream(part, std::ios::binary);
    require(stream.good(), path.string(), ": cannot be opened for writing. Choose another folder with -o");
    stream << text;
    stream.close();
    require(stream.good(), path.string(), ": writing failed. Is the disk full?");
  });
}

fs::path shipped(const fs::path& relative) {
  if (const char* root = std::getenv("APC_DATA")) return fs::path(root) / relative;
  if (const fs::path source(APC_SOURCE_DIR); fs::exists(source / relative)) return source / relative;
  return fs::path(APC_INSTALL_DATA) / relative;
}

std::vector<std::string> shipped_names(const fs::path& folder, const std::string& extension) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(shipped(folder), error)) {
    const auto name = entry.path().stem().string();
    // tires.json lies beside the aircraft as their library; nobody can choose it as one.
    if (entry.path().extension() == extension && name != "tires") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path resolve(const std::string& name, const fs::path& folder, const std::string& kind,
                 const std::string& extension) {
  require(!name.empty(), "the name of the ", kind, " is empty");
  std::error_code error;
  if (fs::is_regular_file(name, error)) return name;
  if (const auto path = shipped(folder) / (name + extension); fs::is_regular_file(path, error)) return path;
  require(!fs::is_directory(name, error), name, ": is a folder; the file of the ", kind, " is needed");
  const auto names = shipped_names(folder, extension);
  std::string list;
  for (const auto& each : names) list += (list.empty() ? "" : ", ") + each;
  const auto near = nearest(name, names.data(), names.size());
  throw InputError(concat(name, ": no such ", kind, ", neither a file nor a shipped name. ",
                          near.empty() ? std::string() : concat("Did you mean \"", near, "\"? "), "Shipped: ", list));
}

}  // namespace apc
