#include <cmath>
#include <fstream>
#include <limits>

#include "apc/base/csv.h"
#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "loadtables/samples.h"

namespace apc::loadtables {
namespace {

std::string remark(const CsvTable& csv, const std::string& key) {
  const auto found = csv.remarks.find(key);
  require(found != csv.remarks.end() && !found->second.empty(), csv.file, ": the line \"# ", key,
          ": ...\" is missing. Add it above the header row");
  return found->second;
}

double relative_error(const CsvTable& csv, const std::string& key) {
  const auto found = csv.remarks.find(key);
  if (found == csv.remarks.end()) return 0.0;
  double value = std::numeric_limits<double>::quiet_NaN();
  try {
    value = parse_quantity(found->second, dimension::none);
  } catch (const InputError&) {
    // refused below, with the place
  }
  require(value >= 0.0 && value <= 1.0, csv.file, ": \"# ", key, ": ", found->second,
          "\" is no relative error. Write a number between 0 and 1, such as 0.03");
  return value;
}

}  // namespace

TableHead loads_csv_head(const std::filesystem::path& path) {
  // Only the remarks are wanted, and other CSV files may have any form.
  std::ifstream stream(path);
  TableHead head;
  bool loads = false;
  for (std::string line; std::getline(stream, line) && !line.empty() && line.front() == '#';) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    const auto trimmed = [](std::string text) {
      const auto first = text.find_first_not_of(" #\t\r"), last = text.find_last_not_of(" \t\r");
      return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
    };
    const auto key = trimmed(line.substr(0, colon)), value = trimmed(line.substr(colon + 1));
    if (key == "schema") loads = value.rfind("apc-loads/", 0) == 0;
    if (key == "tire") head.tire = value;
    if (key == "material") head.material = value;
  }
  return loads ? head : TableHead{};
}

SampleSet read_loads_csv(const std::filesystem::path& path) {
  const auto csv = read_csv(path);
  const auto schema = remark(csv, "schema");
  require(schema == "apc-loads/1", csv.file, ": schema \"", schema, "\" is not what is needed here (\"apc-loads/1\")");
  SampleSet set;
  set.material = remark(csv, "material");
  set.tire = remark(csv, "tire");
  set.source = remark(csv, "source");
  set.drag_rms = relative_error(csv, "drag_rms");
  set.vertical_rms = relative_error(csv, "vertical_rms");
  set.has_rut = csv.find("rut_depth") != nullptr;
  set.has_spin = csv.find("spin_ratio") != nullptr;

  const auto speed = csv.column("speed", dimension::speed), depth = csv.column("bed_depth", dimension::length),
             penetration = csv.column("penetration", dimension::length), drag = csv.column("drag", dimension::force),
             vertical = csv.column("vertical", dimension::force);
  const std::vector<double> none;
  const auto rut = set.has_rut ? csv.column("rut_depth", dimension::length) : none;
  const auto spin = set.has_spin ? csv.column("spin_ratio", dimension::none) : none;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    const Sample sample{{speed[i], depth[i], penetration[i]},
                        {drag[i], vertical[i], set.has_rut ? rut[i] : 0.0, set.has_spin ? spin[i] : 1.0}};
    const auto& [contact, load] = sample;
    const double sum = contact.speed + contact.bed_depth + contact.penetration + load.drag + load.vertical +
                       load.rut_depth + load.spin_ratio;
    if (std::isnan(sum)) continue;  // an empty cell: no sample
    const auto check = [&](bool ok, const char* what, double value, const char* unit, const char* why) {
      require(ok, csv.file, " data row ", i + 1, ": ", what, " ", value, " ", unit, " ", why);
    };
    check(std::isfinite(sum), "a value", sum, "", "is not finite. Leave the cell empty for no sample");
    check(contact.speed >= 0.0, "speed", contact.speed, "m/s", "is negative. Give forward speeds");
    check(contact.speed <= 200.0, "speed", contact.speed, "m/s", "is more than 200 m/s. Check the column's unit");
    check(contact.bed_depth >= 0.0, "bed_depth", contact.bed_depth, "m", "is negative. Depth is a thickness");
    check(contact.bed_depth <= 3.0, "bed_depth", contact.bed_depth, "m", "is more than 3 m. Check the column's unit");
    check(contact.penetration >= 0.0, "penetration", contact.penetration, "m",
          "is negative. It counts downward from the top surface");
    check(contact.penetration <= 3.0, "penetration", contact.penetration, "m",
          "is more than 3 m. Check the column's unit");
    check(load.drag >= 0.0, "drag", load.drag, "N", "is negative. Drag opposes motion and is positive");
    check(load.vertical >= 0.0, "vertical", load.vertical, "N", "is negative. It pushes the tire up and is positive");
    set.samples.push_back(sample);
  }
  require(!set.samples.empty(), csv.file, ": has no complete sample. Rows of numbers are needed below the header");
  return set;
}

void write_loads_csv(const SampleSet& set, const std::filesystem::path& path) {
  std::vector<CsvColumn> columns{{"speed", "kt", {}},
                                 {"bed_depth", "in", {}},
                                 {"penetration", "in", {}},
                                 {"drag", "kN", {}},
                                 {"vertical", "kN", {}}};
  if (set.has_rut) columns.push_back({"rut_depth", "in", {}});
  if (set.has_spin) columns.push_back({"spin_ratio", "", {}});
  for (const auto& [contact, load] : set.samples) {
    std::vector<double> row{contact.speed / units::kt, contact.bed_depth / units::in, contact.penetration / units::in,
                            load.drag / units::kN, load.vertical / units::kN};
    if (set.has_rut) row.push_back(load.rut_depth / units::in);
    if (set.has_spin) row.push_back(load.spin_ratio);
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  const auto number = [](double value) { return concat(value); };
  std::map<std::string, std::string> remarks{
      {"schema", "apc-loads/1"}, {"material", set.material}, {"tire", set.tire}, {"source", set.source}};
  if (set.drag_rms > 0.0) remarks["drag_rms"] = number(set.drag_rms);
  if (set.vertical_rms > 0.0) remarks["vertical_rms"] = number(set.vertical_rms);
  write_text(path, csv_text(remarks, columns, 10));
}

}  // namespace apc::loadtables
