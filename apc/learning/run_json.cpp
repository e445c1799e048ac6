#include "apc/learning/run_json.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "apc/base/csv.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::learning {
namespace {

/// "ax [g]" → {"ax", "g"}
std::pair<std::string, std::string> split_header(const std::string& header) {
  const auto open = header.find('[');
  if (open == std::string::npos) return {header, ""};
  std::string name = header.substr(0, open);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  const auto close = header.find(']', open);
  return {name, header.substr(open + 1, (close == std::string::npos ? header.size() : close) - open - 1)};
}

Channel read_channel(const Json& entry, const std::string& header) {
  Channel channel;
  std::tie(channel.column, channel.unit) = split_header(header);
  const std::string name = entry.text("quantity");
  const auto quantity = quantity_named(name);
  entry.check(quantity.has_value(), "quantity",
              "is no quantity this program knows. See the channel list of the file formats.");
  channel.quantity = *quantity;
  const Dimension dimension = dimension_of(channel.quantity);
  channel.noise = entry.quantity("noise", dimension);
  channel.bias = entry.quantity("bias", dimension, 0.0);
  channel.lag = entry.quantity("lag", dimension::time, 0.0);
  channel.scale = entry.number("scale", 0.003);
  channel.lever_arm = entry.quantity("lever_arm", dimension::length, 0.0);
  entry.check(channel.noise > 0.0, "noise", "must be positive.");
  return channel;
}

void read_signals(Run& run, const std::filesystem::path& path, const Aliases* aliases,
                  std::vector<DataRemark>& remarks) {
  const CsvTable table = read_csv(path);
  const std::string time_name = aliases ? aliases->time : "time";
  std::vector<double> time = table.column(time_name, dimension::time);
  if (aliases)
    for (double& t : time) t -= aliases->time_offset;
  std::vector<Channel> usable;
  for (Channel& channel : run.channels) {
    const CsvColumn* column = table.find(channel.column);
    if (!column) {
      remarks.push_back({run.id, channel.column, "column is missing from " + path.filename().string(),
                         DataRemark::Action::channel_dropped});
      continue;
    }
    if (column->unit != channel.unit)
      remarks.push_back({run.id, channel.column,
                         "unit is [" + column->unit + "] in the signals and [" + channel.unit +
                             "] in the run; the signals' is taken"});
    std::vector<double> values;
    try {
      values = table.column(channel.column, dimension_of(channel.quantity));
    } catch (const InputError& error) {
      remarks.push_back({run.id, channel.column, error.what(), DataRemark::Action::channel_dropped});
      continue;
    }
    const double factor =
        aliases && aliases->factors.contains(channel.column) ? aliases->factors.at(channel.column) : 1.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (std::isfinite(values[i]) && std::isfinite(time[i]))
        channel.time.push_back(time[i]), channel.value.push_back(factor * values[i]);
    if (channel.time.size() < 5) {
      remarks.push_back({run.id, channel.column, "has fewer than five samples", DataRemark::Action::channel_dropped});
      continue;
    }
    usable.push_back(std::move(channel));
  }
  run.channels = std::move(usable);
}

Survey read_survey(const std::filesystem::path& path, double noise) {
  const CsvTable table = read_csv(path);
  Survey survey;
  survey.noise = noise;
  survey.distance = table.column("distance", dimension::length);
  const std::vector<double> nothing(survey.distance.size(), std::numeric_limits<double>::quiet_NaN());
  survey.nose_rut = table.find("nose_rut") ? table.column("nose_rut", dimension::length) : nothing;
  survey.main_rut = table.find("main_rut") ? table.column("main_rut", dimension::length) : nothing;
  return survey;
}

}  // namespace

double years_between(const std::string& from, const std::string& to) {
  int y1 = 0, m1 = 0, d1 = 0, y2 = 0, m2 = 0, d2 = 0;
  if (std::sscanf(from.c_str(), "%d-%d-%d", &y1, &m1, &d1) != 3 ||
      std::sscanf(to.c_str(), "%d-%d-%d", &y2, &m2, &d2) != 3)
    return std::numeric_limits<double>::quiet_NaN();
  // Days of the proleptic Gregorian calendar (Fliegel and Van Flandern, CACM 11, 1968, 657).
  const auto day = [](int y, int m, int d) {
    const int a = (m - 14) / 12;
    return d - 32075 + 1461 * (y + 4800 + a) / 4 + 367 * (m - 2 - a * 12) / 12 - 3 * ((y + 4900 + a) / 100) / 4;
  };
  return (day(y2, m2, d2) - day(y1, m1, d1)) / 365.25;
}

Aliases load_aliases(const std::filesystem::path& path) {
  const Json file = read_json(path);
  file.schema("apc-aliases/1");
  Aliases aliases;
  aliases.time = split_header(file.text("time", "time")).first;
  aliases.time_offset = file.quantity("time_offset", dimension::time, 0.0);
  const Json columns = file.object("columns");
  for (const std::string& header : columns.keys()) {
    const Json entry = columns.object(header);
    const Channel channel = read_channel(entry, header);
    aliases.factors[channel.column] = entry.number("factor", 1.0);
    aliases.columns[channel.column] = channel;
  }
  file.finish();
  return aliases;
}

Run load_run(const std::filesystem::path& path, const aircraft::Aircraft& aircraft, const bed::Bed& bed,
             const Aliases* aliases, std::vector<DataRemark>& remarks) {
  const Json file = read_json(path);
  file.schema("apc-run/1");
  Run run;
  run.file = path;
  run.id = file.text("id", path.stem().string());
  require(file.text("rig", "") == "", path.string(),
          " /rig: single-wheel rig runs are compared on their own, not as overruns. Leave it out of \"runs\".");
  run.mass_known = file.has("mass");
  simulation::Overrun& o = run.overrun;
  o.mass = file.quantity("mass", dimension::mass, aircraft.mass);
  o.cg_behind_nose_gear = file.quantity("cg_behind_nose_gear", dimension::length, aircraft.cg_behind_nose_gear);
  o.pitch_inertia = file.quantity("pitch_inertia", dimension::inertia, aircraft.pitch_inertia * o.mass / aircraft.mass);
  o.entry_speed = file.object("entry").quantity("speed", dimension::speed);
  file.check(o.entry_speed > 1.0 && o.entry_speed < 150.0, "entry",
             "has a speed no overrun enters a bed with (1–150 m/s).");
  file.check(o.mass > 0.2 * aircraft.mass && o.mass < 5.0 * aircraft.mass, "mass", "is no mass of this aircraft.");
  o.braking = file.number("braking", 0.0);
  o.thrust = file.quantity("thrust", dimension::force, 0.0);
  o.headwind = file.quantity("wind", dimension::speed, 0.0);
  run.conditions.temperature = file.quantity("temperature", dimension::temperature, 293.15);
  run.lane = file.text("lane", run.id);
  run.date = file.text("date", "");
  const double years = years_between(bed.built, run.date);
  run.conditions.years = std::isfinite(years) ? years : 0.0;
  const auto fallback = [&](double value) { return value; };
  run.uncertainty = {run.mass_known ? 0.01 * o.mass : 0.15 * o.mass, 0.02, 0.03 * o.pitch_inertia, 0.2, 0.8, 0.01};
  if (file.has("uncertainty")) {
    const Json u = file.object("uncertainty");
    if (run.mass_known) run.uncertainty.mass = u.quantity("mass", dimension::mass, fallback(run.uncertainty.mass));
    run.uncertainty.cg = u.quantity("cg_behind_nose_gear", dimension::length, run.uncertainty.cg);
    run.uncertainty.pitch_inertia = u.quantity("pitch_inertia", dimension::inertia, run.uncertainty.pitch_inertia);
    run.uncertainty.entry_speed = u.quantity("entry_speed", dimension::speed, run.uncertainty.entry_speed);
    run.uncertainty.wind = u.quantity("wind", dimension::speed, run.uncertainty.wind);
    run.uncertainty.clock = u.quantity("clock", dimension::time, run.uncertainty.clock);
  }
  if (!run.mass_known) remarks.push_back({run.id, "", "no mass given: the aircraft file's is taken, ±15 %"});
  if (file.has("channels")) {
    const Json channels = file.object("channels");
    for (const std::string& header : channels.keys()) {
      try {
        run.channels.push_back(read_channel(channels.object(header), header));
      } catch (const InputError& error) {
        remarks.push_back({run.id, header, error.what(), DataRemark::Action::channel_dropped});
      }
    }
  } else if (aliases) {
    for (const auto& [column, channel] : aliases->columns) run.channels.push_back(channel);
  }
  if (file.has("signals")) read_signals(run, path.parent_path() / file.text("signals"), aliases, remarks);
  if (file.has("survey")) {
    try {
      run.survey = read_survey(path.parent_path() / file.text("survey"),
                               file.quantity("survey_noise", dimension::length, 0.015));
    } catch (const InputError& error) {
      remarks.push_back({run.id, "survey", error.what(), DataRemark::Action::channel_dropped});
    }
  }
  if (file.has("stop")) {
    run.stop = file.object("stop").quantity("value", dimension::length);
    run.stop_noise = file.object("stop").quantity("noise", dimension::length, 0.3);
  }
  if (file.has("exit")) run.exit_speed = file.object("exit").quantity("speed", dimension::speed);
  return run;
}

}  // namespace apc::learning
