/// HDF5 files with plain groups, numeric arrays and text attributes; every dataset carries its "unit".
/// Written under a temporary name and renamed (`save_hdf5`); reading refuses truncated and foreign files with one
/// message.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace apc {

/// A dense array, row-major: the last dimension varies fastest.
struct Array {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// An HDF5 file open for writing. Paths are "group/name"; groups are made as needed.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path&);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;
  void array(const std::string& path, const Array&, const std::string& unit);
  void array(const std::string& path, const std::vector<double>&, const std::string& unit);
  void floats(const std::string& path, const std::vector<float>&, const std::string& unit);
  void integers(const std::string& path, const std::vector<std::int64_t>&);
  void attribute(const std::string& group, const std::string& name, const std::string& text);
  void attribute(const std::string& group, const std::string& name, double number);
  std::int64_t handle() const { return file_; }  ///< hid_t, for layouts this class does not know (VTKHDF)

 private:
  std::int64_t file_;
};

class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path&);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;
  bool has(const std::string& path) const;
  bool has_attribute(const std::string& group, const std::string& name) const;
  Array array(const std::string& path) const;
  std::vector<float> floats(const std::string& path) const;
  std::vector<std::int64_t> integers(const std::string& path) const;
  std::string text(const std::string& group, const std::string& name) const;
  double number(const std::string& group, const std::string& name) const;
  std::vector<std::string> members(const std::string& group) const;
  const std::string& file() const { return name_; }

 private:
  std::string name_;
  std::int64_t file_;
};

/// Atomic save: `write` fills a temporary file that is renamed to `path` when it is complete.
void save_hdf5(const std::filesystem::path& path, const std::function<void(Hdf5Writer&)>& write);

}  // namespace apc
