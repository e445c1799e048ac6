/// The native container of a load table, schema "apc-load-table/1": numbers in SI with their unit, provenance and fit
/// quality as attributes, and the samples it was fitted to.
#include <cmath>
#include <memory>

#include "apc/base/hdf5.h"
#include "apc/base/require.h"
#include "loadtables/load_table_data.h"

namespace apc::loadtables {
namespace {

constexpr const char* schema = "apc-load-table/1";

void write_axis(Hdf5Writer& file, const std::string& path, const Axis& axis, const std::string& unit) {
  std::vector<double> nodes;
  for (int i = 0; i < axis.nodes; ++i) nodes.push_back(axis.node(i));
  file.array(path, nodes, unit);
}

Axis read_axis(const Hdf5Reader& file, const std::string& path) {
  const auto nodes = file.array(path).values;
  require(nodes.size() >= 4 && nodes.size() < 10000 && nodes.back() > nodes.front() && std::isfinite(nodes.back()) &&
              std::isfinite(nodes.front()),
          file.file(), ": \"", path, "\" is no axis of a load table. Make the table again with apc loads fit");
  return axis(nodes.front(), nodes.back(), static_cast<int>(nodes.size()));
}

void write_tire(Hdf5Writer& file, const TableTire& tire) {
  file.array("tire/curve_deflection", tire.curve_deflection, "m");
  file.array("tire/curve_load", tire.curve_load, "N");
  file.attribute("tire", "name", tire.name);
  for (const auto& [name, value] : {std::pair{"diameter_m", tire.diameter},
                                    {"width_m", tire.width},
                                    {"rated_load_N", tire.rated_load},
                                    {"rated_deflection_m", tire.rated_deflection},
                                    {"bottoming_load_N", tire.bottoming_load},
                                    {"bottoming_deflection_m", tire.bottoming_deflection}})
    file.attribute("tire", name, value);
}

TableTire read_tire(const Hdf5Reader& file) {
  TableTire tire;
  tire.name = file.text("tire", "name");
  tire.diameter = file.number("tire", "diameter_m");
  tire.width = file.number("tire", "width_m");
  tire.rated_load = file.number("tire", "rated_load_N");
  tire.rated_deflection = file.number("tire", "rated_deflection_m");
  tire.bottoming_load = file.number("tire", "bottoming_load_N");
  tire.bottoming_deflection = file.number("tire", "bottoming_deflection_m");
  tire.curve_deflection = file.array("tire/curve_deflection").values;
  tire.curve_load = file.array("tire/curve_load").values;
  return tire;
}

void write_samples(Hdf5Writer& file, const SampleSet& set) {
  const auto column = [&](const std::string& name, const std::string& unit, const auto& value) {
    std::vector<double> values;
    for (const auto& sample : set.samples) values.push_back(value(sample));
    file.array("samples/" + name, values, unit);
  };
  column("speed", "m/s", [](const Sample& s) { return s.contact.speed; });
  column("bed_depth", "m", [](const Sample& s) { return s.contact.bed_depth; });
  column("penetration", "m", [](const Sample& s) { return s.contact.penetration; });
  column("drag", "N", [](const Sample& s) { return s.load.drag; });
  column("vertical", "N", [](const Sample& s) { return s.load.vertical; });
  if (set.has_rut) column("rut_depth", "m", [](const Sample& s) { return s.load.rut_depth; });
  if (set.has_spin) column("spin_ratio", "1", [](const Sample& s) { return s.load.spin_ratio; });
  file.attribute("samples", "material", set.material);
  file.attribute("samples", "tire", set.tire);
  file.attribute("samples", "source", set.source);
  file.attribute("samples", "drag_rms", set.drag_rms);
  file.attribute("samples", "vertical_rms", set.vertical_rms);
}

SampleSet read_samples(const Hdf5Reader& file) {
  SampleSet set;
  set.material = file.text("samples", "material");
  set.tire = file.text("samples", "tire");
  set.source = file.text("samples", "source");
  set.drag_rms = file.number("samples", "drag_rms");
  set.vertical_rms = file.number("samples", "vertical_rms");
  set.has_rut = file.has("samples/rut_depth");
  set.has_spin = file.has("samples/spin_ratio");
  set.samples.resize(file.array("samples/speed").values.size());
  const auto column = [&](const std::string& name, const auto& assign) {
    const auto values = file.array("samples/" + name).values;
    require(values.size() == set.samples.size(), file.file(), ": \"samples/", name, "\" has ", values.size(),
            " values, the samples have ", set.samples.size(), ". Make the table again");
    for (std::size_t i = 0; i < values.size(); ++i) assign(set.samples[i], values[i]);
  };
  column("speed", [](Sample& s, double x) { s.contact.speed = x; });
  column("bed_depth", [](Sample& s, double x) { s.contact.bed_depth = x; });
  column("penetration", [](Sample& s, double x) { s.contact.penetration = x; });
  column("drag", [](Sample& s, double x) { s.load.drag = x; });
  column("vertical", [](Sample& s, double x) { s.load.vertical = x; });
  if (set.has_rut) column("rut_depth", [](Sample& s, double x) { s.load.rut_depth = x; });
  if (set.has_spin) column("spin_ratio", [](Sample& s, double x) { s.load.spin_ratio = x; });
  return set;
}

void write_quality(Hdf5Writer& file, const std::vector<FitQuality>& list) {
  for (const auto& each : list) {
    const auto group = "quality/" + each.response;
    file.attribute(group, "response", each.response);
    file.attribute(group, "points", static_cast<double>(each.points));
    file.attribute(group, "rms_relative", each.rms_relative);
    file.attribute(group, "loo_rms_relative", each.loo_rms_relative);
    file.attribute(group, "r2", each.r2);
    file.attribute(group, "loo_rms_to_axle", each.loo_rms_to_axle);
  }
}

std::vector<FitQuality> read_quality(const Hdf5Reader& file) {
  std::vector<FitQuality> list;
  for (const std::string name : {"drag", "vertical", "rut_depth", "spin_ratio"}) {
    const auto group = "quality/" + name;
    if (!file.has(group)) continue;
    list.push_back({name, static_cast<int>(file.number(group, "points")), file.number(group, "rms_relative"),
                    file.number(group, "loo_rms_relative"), file.number(group, "r2"),
                    file.number(group, "loo_rms_to_axle")});
  }
  return list;
}

std::array<double, 2> read_range(const Hdf5Reader& file, const std::string& path) {
  const auto values = file.array(path).values;
  require(values.size() == 2 && values[0] <= values[1], file.file(), ": \"", path,
          "\" is no range. Make the table again");
  return {values[0], values[1]};
}

}  // namespace

void save_table(const LoadTable& table, const std::filesystem::path& path) {
  const auto& data = table.data();
  save_hdf5(path, [&](Hdf5Writer& file) {
    file.attribute("/", "schema", schema);
    const auto& from = data.provenance;
    for (const auto& [name, text] : {std::pair{"material", from.material},
                                     {"tire", data.tire.name},
                                     {"source", from.source},
                                     {"command", from.command},
                                     {"date", from.date},
                                     {"version", from.version}})
      file.attribute("/", name, text);
    for (const auto& [name, number] : {std::pair{"friction", from.friction},
                                       {"spacing_m", from.spacing},
                                       {"runs", static_cast<double>(from.runs)},
                                       {"refused", static_cast<double>(from.refused)}})
      file.attribute("/", name, number);
    file.attribute("/", "growth_correction", data.growth_correction);
    write_axis(file, "axes/speed", data.speed, "m/s");
    write_axis(file, "axes/depth_scale", data.depth, "1");
    write_axis(file, "axes/relative_penetration", data.ratio, "1");
    file.attribute("axes", "depth_reference_m", DepthScale::reference);
    file.attribute("axes", "compaction", data.penetration.compaction);
    file.attribute("axes", "deflection_m", data.penetration.deflection);
    file.array("range/speed", {data.speeds[0], data.speeds[1]}, "m/s");
    file.array("range/bed_depth", {data.depths[0], data.depths[1]}, "m");
    file.array("range/relative_penetration", {data.ratios[0], data.ratios[1]}, "1");
    file.floats("coefficients", {data.coefficients.begin(), data.coefficients.end()}, "N, N, m, 1");
    file.attribute("/", "responses", "drag, vertical, rut_depth, 1 - spin_ratio");
    write_tire(file, data.tire);
    write_quality(file, data.quality);
    write_samples(file, data.samples);
  });
}

TableHead table_head(const std::filesystem::path& path) {
  try {
    const Hdf5Reader file(path);
    if (!file.has_attribute("/", "schema") || file.text("/", "schema") != schema) return {};
    return {file.text("/", "tire"), file.text("/", "material")};
  } catch (const InputError&) {
    return {};
  }
}

LoadTable load_table(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  const auto remedy = ". Is it a load table? Make one with apc loads fit, or import a CSV with apc loads import";
  require(file.has_attribute("/", "schema"), path.string(), ": is HDF5 but names no schema", remedy);
  const auto found = file.text("/", "schema");
  require(found == schema, path.string(), ": schema \"", found, "\" is not what is needed here (\"", schema, "\")",
          remedy);
  auto data = std::make_shared<LoadTable::Data>();
  auto& from = data->provenance;
  for (const auto& [name, text] : {std::pair{"material", &from.material},
                                   {"source", &from.source},
                                   {"command", &from.command},
                                   {"date", &from.date},
                                   {"version", &from.version}})
    *text = file.text("/", name);
  from.friction = file.number("/", "friction");
  from.spacing = file.number("/", "spacing_m");
  from.runs = static_cast<int>(file.number("/", "runs"));
  from.refused = static_cast<int>(file.number("/", "refused"));
  data->speed = read_axis(file, "axes/speed");
  data->depth = read_axis(file, "axes/depth_scale");
  data->ratio = read_axis(file, "axes/relative_penetration");
  require(file.number("axes", "depth_reference_m") == DepthScale::reference, path.string(),
          ": was made with another depth scale. Make the table again with apc loads fit");
  data->growth_correction = file.number("/", "growth_correction");
  data->tire = read_tire(file);
  data->penetration = penetration_scale(data->tire);
  data->penetration.compaction = file.number("axes", "compaction");
  data->penetration.deflection = file.number("axes", "deflection_m");
  data->speeds = read_range(file, "range/speed");
  data->depths = read_range(file, "range/bed_depth");
  data->ratios = read_range(file, "range/relative_penetration");
  const auto coefficients = file.floats("coefficients");
  const auto expected = static_cast<std::size_t>(data->speed.coefficients()) *
                        static_cast<std::size_t>(data->depth.coefficients()) *
                        static_cast<std::size_t>(data->ratio.coefficients()) * responses;
  require(coefficients.size() == expected, path.string(), ": holds ", coefficients.size(),
          " coefficients where its axes need ", expected, ". The file is damaged; make the table again");
  for (const float value : coefficients)
    require(std::isfinite(value), path.string(), ": holds a coefficient that is ",
            "not finite. The file is damaged; make the table again");
  data->coefficients.assign(coefficients.begin(), coefficients.end());
  data->quality = read_quality(file);
  data->samples = read_samples(file);
  return LoadTable(data);
}

}  // namespace apc::loadtables
