#include "apc/report/history_table.h"

#include <cmath>
#include <map>

#include "apc/base/hdf5.h"
#include "apc/base/require.h"

namespace apc::report {

std::vector<CsvColumn> history_table(const simulation::Result& result) {
  const auto& history = result.history;
  std::vector<CsvColumn> columns;
  const auto add = [&](const std::string& name, const char* unit, const std::vector<double>& values) {
    if (values.empty()) return;
    expect(values.size() == history.time.size(), "history column ", name, " has another length than time");
    columns.push_back({name, unit, values});
  };
  add("time", "s", history.time);
  add("distance", "m", history.distance);
  add("speed", "m/s", history.speed);
  add("deceleration", "m/s^2", history.deceleration);
  add("acceleration_x", "m/s^2", history.acceleration_x);
  add("acceleration_z", "m/s^2", history.acceleration_z);
  add("pitch", "rad", history.pitch);
  add("pitch_rate", "rad/s", history.pitch_rate);
  add("heave", "m", history.heave);
  for (std::size_t i = 0; i < history.gears.size(); ++i) {
    const auto& gear = history.gears[i];
    const auto prefix = (i < result.gears.size() ? result.gears[i].name : "gear" + std::to_string(i)) + "_";
    add(prefix + "drag", "N", gear.drag);
    add(prefix + "vertical", "N", gear.vertical);
    add(prefix + "stroke", "m", gear.stroke);
    add(prefix + "stroke_rate", "m/s", gear.stroke_rate);
    add(prefix + "penetration", "m", gear.penetration);
    add(prefix + "rut", "m", gear.rut);
    add(prefix + "bed_depth", "m", gear.bed_depth);
    add(prefix + "spin", "rad/s", gear.spin);
    add(prefix + "distance", "m", gear.distance);
  }
  add("dissipated", "J", history.dissipated);
  return columns;
}

namespace {

/// What identifies the run, as text: the same lines in both files.
std::map<std::string, std::string> identity(const OverrunRecord& record) {
  std::map<std::string, std::string> lines;
  lines["aircraft"] = record.model.aircraft.name;
  lines["bed"] = record.model.bed.name;
  lines["outcome"] = simulation::text(record.result.outcome);
  lines["entry_speed"] = concat(record.result.entry_speed, " m/s");
  lines["stop_distance"] = std::isfinite(record.result.stop_distance)
                               ? concat(record.result.stop_distance, " m from the bed's leading edge")
                               : "left the bed";
  lines["program"] = record.manifest.version;
  lines["command"] = record.manifest.command;
  for (const auto& file : record.manifest.files) lines["sha256 of " + file.path] = file.sha256;
  for (auto& [key, value] : lines)
    for (auto& letter : value)
      if (letter == '\n' || letter == '\r') letter = ' ';
  return lines;
}

}  // namespace

std::string history_csv(const OverrunRecord& record) {
  return csv_text(identity(record), history_table(record.result), 7);
}

void save_history(const OverrunRecord& record, const std::filesystem::path& path) {
  save_hdf5(path, [&](Hdf5Writer& writer) {
    for (const auto& column : history_table(record.result))
      writer.array("history/" + column.name, column.values, column.unit);
    writer.attribute("/", "schema", "apc-history/1");
    for (const auto& [key, value] : identity(record)) writer.attribute("/", key, value);
  });
}

}  // namespace apc::report
