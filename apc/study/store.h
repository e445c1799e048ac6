/// What long work has finished so far, on disk: a text file that only ever grows by whole lines. A process killed at
/// any moment loses at most the line it was writing; the next start reads the rest and drops the torn end.
///
///     apc-store/1 <identity>
///     <checksum> <key> TAB <value>
///
/// `identity` names the work (a hash of its inputs and the program's version): a store is never continued by other
/// work.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace apc::study {

class Store {
 public:
  /// Keeps everything in memory only.
  Store() = default;
  /// Opens `path` or creates it. InputError when it belongs to other work or is no store at all.
  Store(const std::filesystem::path& path, const std::string& identity);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Keys and values must hold no line break; keys no tab. Safe to call from several threads.
  void put(const std::string& key, const std::string& value);
  std::optional<std::string> find(const std::string& key) const;
  /// Entries found on disk when the store was opened.
  std::size_t found() const { return found_; }

 private:
  void read(const std::filesystem::path&, const std::string& identity);

  std::unordered_map<std::string, std::string> entries_;
  mutable std::mutex guard_;
  std::size_t found_ = 0;
  int file_ = -1;
};

/// 64 bits of FNV-1a as 16 hexadecimal digits: a name for inputs, no protection against malice.
std::string fingerprint(const std::string& text);

}  // namespace apc::study
