#include "apc/base/hdf5.h"

#include <hdf5.h>

#include <utility>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc {
namespace {

/// Closes an HDF5 handle of any kind at the end of its scope.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

void quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

void write_text_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.size() + 1);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  expect(attribute.good() && H5Awrite(attribute, type, text.c_str()) >= 0, "HDF5 attribute ", name);
}

void write_dataset(hid_t file, const std::string& path, hid_t memory, hid_t stored, const std::vector<hsize_t>& shape,
                   const void* data, const std::string& unit) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  hsize_t count = 1;
  for (const auto n : shape) count *= n;
  if (count > 256) {  // measured elsewhere: shuffle + gzip 1 packs our data as well as gzip 9 at a third of the time
    std::vector<hsize_t> chunk = shape;
    while (chunk[0] > 1 && count / shape[0] * chunk[0] > 131072) chunk[0] = (chunk[0] + 1) / 2;
    H5Pset_chunk(layout, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(layout);
    H5Pset_deflate(layout, 1);
  }
  const Handle set(H5Dcreate2(file, path.c_str(), stored, space, links, layout, H5P_DEFAULT), H5Dclose);
  require(set.good() && H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0, "HDF5: cannot write ", path,
          ". Is the disk full?");
  if (!unit.empty()) write_text_attribute(set, "unit", unit);
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path) {
  quiet();
  file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  require(file_ >= 0, path.string(), ": cannot be created");
}

Hdf5Writer::~Hdf5Writer() { H5Fclose(file_); }

void Hdf5Writer::array(const std::string& path, const Array& array, const std::string& unit) {
  write_dataset(file_, path, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, {array.shape.begin(), array.shape.end()},
                array.values.data(), unit);
}

void Hdf5Writer::array(const std::string& path, const std::vector<double>& values, const std::string& unit) {
  write_dataset(file_, path, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, {values.size()}, values.data(), unit);
}

void Hdf5Writer::floats(const std::string& path, const std::vector<float>& values, const std::string& unit) {
  write_dataset(file_, path, H5T_NATIVE_FLOAT, H5T_IEEE_F32LE, {values.size()}, values.data(), unit);
}

void Hdf5Writer::integers(const std::string& path, const std::vector<std::int64_t>& values) {
  write_dataset(file_, path, H5T_NATIVE_INT64, H5T_STD_I64LE, {values.size()}, values.data(), "");
}

namespace {

/// The object at `path`; a group that is not there yet is made, with the groups above it.
hid_t open_or_make(hid_t file, const std::string& path) {
  const bool root = path.empty() || path == "/";
  for (std::size_t slash = 0; !root && slash != std::string::npos;) {
    slash = path.find('/', slash + 1);
    const auto upper = path.substr(0, slash);
    if (H5Lexists(file, upper.c_str(), H5P_DEFAULT) <= 0)
      H5Gclose(H5Gcreate2(file, upper.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
  return H5Oopen(file, root ? "/" : path.c_str(), H5P_DEFAULT);
}

}  // namespace

void Hdf5Writer::attribute(const std::string& group, const std::string& name, const std::string& text) {
  const Handle object(open_or_make(file_, group), H5Oclose);
  write_text_attribute(object, name, text);
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name, double number) {
  const Handle object(open_or_make(file_, group), H5Oclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  expect(attribute.good() && H5Awrite(attribute, H5T_NATIVE_DOUBLE, &number) >= 0, "HDF5 attribute ", name);
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : name_(path.string()), file_(-1) {
  quiet();
  std::error_code error;
  require(std::filesystem::is_regular_file(path, error), name_, ": no such file");
  require(H5Fis_hdf5(path.c_str()) > 0, name_, ": is not an HDF5 file (truncated, or another format)");
  file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  require(file_ >= 0, name_, ": is a damaged HDF5 file (truncated while being copied?). Make or copy it again");
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(file_); }

bool Hdf5Reader::has(const std::string& path) const {
  for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1))
    if (slash > 0 && H5Lexists(file_, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5Reader::has_attribute(const std::string& group, const std::string& name) const {
  return H5Aexists_by_name(file_, group.empty() ? "/" : group.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

namespace {

template <class Value>
std::vector<Value> read_dataset(const Hdf5Reader& reader, hid_t file, const std::string& path, hid_t memory,
                                std::vector<std::size_t>& shape) {
  require(reader.has(path), reader.file(), ": holds no \"", path, "\". Is it a file of another kind?");
  const Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  require(set.good(), reader.file(), ": \"", path, "\" is not a dataset");
  const Handle space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> extent(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  std::size_t count = 1;
  for (const auto n : extent) count *= n;
  shape.assign(extent.begin(), extent.end());
  std::vector<Value> values(count);
  require(H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, reader.file(), ": \"", path,
          "\" cannot be read (damaged file). Make or copy it again");
  return values;
}

}  // namespace

Array Hdf5Reader::array(const std::string& path) const {
  Array result;
  result.values = read_dataset<double>(*this, file_, path, H5T_NATIVE_DOUBLE, result.shape);
  return result;
}

std::vector<float> Hdf5Reader::floats(const std::string& path) const {
  std::vector<std::size_t> shape;
  return read_dataset<float>(*this, file_, path, H5T_NATIVE_FLOAT, shape);
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path) const {
  std::vector<std::size_t> shape;
  return read_dataset<std::int64_t>(*this, file_, path, H5T_NATIVE_INT64, shape);
}

std::string Hdf5Reader::text(const std::string& group, const std::string& name) const {
  require(has_attribute(group, name), name_, ": \"", group, "\" has no attribute \"", name,
          "\". Is it a file of another kind?");
  const Handle attribute(
      H5Aopen_by_name(file_, group.empty() ? "/" : group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) <= 0, name_, ": attribute \"", name,
          "\" is not a fixed text");
  std::string text(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, text.data()) >= 0, name_, ": attribute \"", name, "\" cannot be read");
  return text.substr(0, text.find('\0'));
}

double Hdf5Reader::number(const std::string& group, const std::string& name) const {
  require(has_attribute(group, name), name_, ": \"", group, "\" has no attribute \"", name,
          "\". Is it a file of another kind?");
  const Handle attribute(
      H5Aopen_by_name(file_, group.empty() ? "/" : group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  double value = 0.0;
  require(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0, name_, ": attribute \"", name, "\" is not a number");
  return value;
}

std::vector<std::string> Hdf5Reader::members(const std::string& group) const {
  std::vector<std::string> names;
  const Handle object(H5Gopen2(file_, group.empty() ? "/" : group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!object.good()) return names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names);
  return names;
}

void save_hdf5(const std::filesystem::path& path, const std::function<void(Hdf5Writer&)>& write) {
  write_atomically(path, [&](const std::filesystem::path& part) {
    Hdf5Writer writer(part);
    write(writer);
  });
}

}  // namespace apc
