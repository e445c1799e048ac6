#include "apc/study/store.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc::study {
namespace fs = std::filesystem;

std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 1469598103934665603ull;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ull;
  char out[17];
  std::snprintf(out, sizeof out, "%016llx", static_cast<unsigned long long>(hash));
  return out;
}

namespace {

const std::string format = "apc-store/1 ";

std::string line_of(const std::string& key, const std::string& value) {
  const auto body = key + "\t" + value;
  return fingerprint(body) + " " + body + "\n";
}

/// The whole file; empty when it is not there yet.
std::string content(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) ? read_text(path) : std::string();
}

}  // namespace

Store::Store(const fs::path& path, const std::string& identity) {
  read(path, identity);
  file_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  require(file_ >= 0, path.string(), ": cannot be written. Check the folder's permissions, or name another with -o");
}

Store::~Store() {
  if (file_ >= 0) ::close(file_);
}

void Store::read(const fs::path& path, const std::string& identity) {
  const auto text = content(path);
  const auto head = format + identity + "\n";
  if (text.empty() || (text.find('\n') == std::string::npos && head.starts_with(text))) {
    write_text(path, head);
    return;
  }
  require(text.starts_with(format), path.string(),
          ": is no store of finished cases. Move it away, or name another folder");
  require(
      text.starts_with(head), path.string(),
      ": belongs to other work (other inputs, options or program version). Repeat the command that made it, or name "
      "another folder with -o");
  std::size_t good = head.size();
  for (std::size_t end = text.find('\n', good); end != std::string::npos; end = text.find('\n', good)) {
    const auto line = text.substr(good, end - good);
    const auto tab = line.find('\t');
    if (line.size() < 18 || tab == std::string::npos || fingerprint(line.substr(17)) != line.substr(0, 16)) break;
    entries_[line.substr(17, tab - 17)] = line.substr(tab + 1);
    good = end + 1;
  }
  found_ = entries_.size();
  if (good < text.size()) fs::resize_file(path, good);  // the line that was being written when the process ended
}

void Store::put(const std::string& key, const std::string& value) {
  expect(key.find_first_of("\t\n") == std::string::npos && value.find('\n') == std::string::npos,
         "a store's entry is one line");
  const auto line = line_of(key, value);
  const std::lock_guard lock(guard_);
  if (!entries_.emplace(key, value).second || file_ < 0) return;
  require(::write(file_, line.data(), line.size()) == static_cast<ssize_t>(line.size()),
          "the store of finished cases cannot be written: the disk may be full");
}

std::optional<std::string> Store::find(const std::string& key) const {
  const std::lock_guard lock(guard_);
  const auto entry = entries_.find(key);
  return entry == entries_.end() ? std::nullopt : std::optional(entry->second);
}

}  // namespace apc::study
