#include "sph_backend/snapshot_vtu.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <numbers>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc::sph {
namespace {

/// One VTU file with raw appended data.
class Vtu {
 public:
  Vtu(std::size_t points, std::size_t cells) : points_(points), cells_(cells) {}

  template <class T>
  std::string array(const char* name, const std::vector<T>& values, int components = 1) {
    const char* type = sizeof(T) == 1 ? "UInt8" : std::is_integral_v<T> ? "Int32" : "Float32";
    std::string tag = concat("<DataArray type=\"", type, "\" Name=\"", name, "\" NumberOfComponents=\"", components,
                             "\" format=\"appended\" offset=\"", data_.size(), "\"/>\n");
    const std::uint32_t bytes = static_cast<std::uint32_t>(values.size() * sizeof(T));
    append(&bytes, sizeof bytes);
    append(values.data(), bytes);
    return tag;
  }

  std::string text(const std::string& points, const std::string& cells, const std::string& point_data) const {
    return concat(
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
               "byte_order=\"LittleEndian\">\n",
               "<UnstructuredGrid>\n<Piece NumberOfPoints=\"", points_, "\" NumberOfCells=\"", cells_,
               "\">\n<PointData>\n", point_data, "</PointData>\n<Points>\n", points, "</Points>\n<Cells>\n", cells,
               "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_") +
           data_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  void append(const void* from, std::size_t bytes) { data_.append(static_cast<const char*>(from), bytes); }
  std::size_t points_, cells_;
  std::string data_;
};

std::string particles_vtu(const RollingRun& run) {
  const Particles& p = run.bed.particles;
  std::vector<float> position, velocity, compaction, pressure, work;
  std::vector<std::int32_t> id, connectivity, offsets;
  std::vector<std::uint8_t> types, held;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0) continue;
    const float s = p.stretch[i];
    for (const auto* v : {&p.x, &p.y, &p.z}) position.push_back(static_cast<float>((*v)[i]));
    for (const auto* v : {&p.vx, &p.vy, &p.vz}) velocity.push_back(static_cast<float>((*v)[i]));
    compaction.push_back(1.0f - 1.0f / (s * s * s));
    pressure.push_back(-(p.stress[0][i] + p.stress[1][i] + p.stress[2][i]) / 3.0f);
    work.push_back(p.work[i]);
    held.push_back(p.hold[i]);
    connectivity.push_back(static_cast<std::int32_t>(id.size()));
    id.push_back(p.id[i]);
    offsets.push_back(static_cast<std::int32_t>(id.size()));
    types.push_back(1);  // vertex
  }
  Vtu file(id.size(), id.size());
  const std::string points = file.array("position", position, 3);
  const std::string cells =
      file.array("connectivity", connectivity) + file.array("offsets", offsets) + file.array("types", types);
  const std::string data = file.array("velocity", velocity, 3) + file.array("compaction", compaction) +
                           file.array("pressure", pressure) + file.array("work", work) + file.array("id", id) +
                           file.array("held", held);
  return file.text(points, cells, data);
}

std::string tire_vtu(const RollingRun& run) {
  const Tire& tire = run.tire;
  const AxleState axle = run.path.at(run.bed.time);
  const int around = tire.grid.around, rows = tire.grid.across + 1;
  std::vector<float> position, deflection;
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < rows; ++j) {
      const double alpha = 2.0 * std::numbers::pi * i / around - tire.angle, u = tire.u[tire.node(i, j)];
      const double r = tire.ring_radius[j] - u;
      for (const double v :
           {axle.x + r * std::sin(alpha), tire.outline.lateral * j / tire.grid.across, axle.z - r * std::cos(alpha)})
        position.push_back(static_cast<float>(v));
      deflection.push_back(static_cast<float>(u));
      if (j + 1 == rows) continue;
      const int next = (i + 1) % around;
      for (const int n : {i * rows + j, next * rows + j, next * rows + j + 1, i * rows + j + 1})
        connectivity.push_back(n);
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
      types.push_back(9);  // quadrilateral
    }
  Vtu file(deflection.size(), types.size());
  const std::string points = file.array("position", position, 3);
  const std::string cells =
      file.array("connectivity", connectivity) + file.array("offsets", offsets) + file.array("types", types);
  const std::string data = file.array("deflection", deflection);
  return file.text(points, cells, data);
}

std::string numbered(const char* what, std::size_t number) {
  char name[40];
  std::snprintf(name, sizeof name, "%s_%04zu.vtu", what, number);
  return name;
}

}  // namespace

double SnapshotSeries::resume(double time) {
  std::ifstream series(folder_ / "run.pvd");
  const std::string head = "<DataSet timestep=\"", part = "\" part=\"0\"";
  for (std::string line; std::getline(series, line);) {
    if (!line.starts_with(head) || line.find(part) == std::string::npos) continue;
    const double at = std::strtod(line.c_str() + head.size(), nullptr);
    if (at <= time) times_.push_back(at);
  }
  return times_.empty() ? -1.0 : times_.back();
}

void SnapshotSeries::write(const RollingRun& run) {
  const std::size_t n = times_.size();
  write_text(folder_ / numbered("particles", n), particles_vtu(run));
  write_text(folder_ / numbered("tire", n), tire_vtu(run));
  times_.push_back(run.bed.time);
  std::string series = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t k = 0; k < times_.size(); ++k) {
    series += concat("<DataSet timestep=\"", times_[k], "\" part=\"0\" file=\"", numbered("particles", k), "\"/>\n");
    series += concat("<DataSet timestep=\"", times_[k], "\" part=\"1\" file=\"", numbered("tire", k), "\"/>\n");
  }
  write_text(folder_ / "run.pvd", series + "</Collection>\n</VTKFile>\n");
}

}  // namespace apc::sph
