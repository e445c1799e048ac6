#include "apc/report/brief.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace apc::report {
namespace {

using simulation::GearSummary;

void add_outcome(std::string& out, const OverrunRecord& record, UnitSystem units) {
  const auto& result = record.result;
  for (const auto& addition : additions(record)) out += "  with           " + addition + "\n";
  using simulation::Outcome;
  const char* held = result.gear_failed() ? " (if the gear had held)" : "";
  if (result.outcome == Outcome::gear_limit || result.outcome == Outcome::pitched_over)
    out += "  " + result.message + "\n";
  if (std::isfinite(result.stop_distance))
    out += fmt::format("  stop           {} into the bed, {} from the pavement end, {} after entry{}\n",
                       shown(result.stop_distance, measure::distance, units),
                       shown(result.runway_distance, measure::distance, units),
                       shown(result.stop_time, measure::time, units), held);
  else
    out += fmt::format(
        "  {}   at {}, {} after entry{}\n", result.outcome == Outcome::pitched_over ? "pitched over" : "left the bed",
        shown(result.exit_speed, measure::speed, units), shown(result.stop_time, measure::time, units), held);
  out += fmt::format("  deceleration   peak {}, largest 0.1 s mean {}, mean {}\n",
                     shown(result.peak_deceleration, measure::acceleration, units),
                     shown(result.peak_deceleration_100ms, measure::acceleration, units),
                     shown(result.mean_deceleration, measure::acceleration, units));
  out += fmt::format("  pitch          {} to {}\n", shown(result.lowest_pitch, measure::angle, units),
                     shown(result.peak_pitch, measure::angle, units));
  const auto worst = worst_margin(result);
  if (worst.gear.empty())
    out += "  worst margin   no limit is known\n";
  else
    out += fmt::format("  worst margin   {}: {} {} {} of {} at {} ({})\n", percent(worst.margin, 1), worst.gear,
                       worst.load, shown(worst.peak, measure::force, units), shown(worst.limit, measure::force, units),
                       shown(worst.distance, measure::distance, units), worst.rule);
}

void add_load_row(std::string& out, const char* gear, const char* load, double peak, double at, double limit,
                  double margin, const std::string& rule, UnitSystem units) {
  out += fmt::format("  {:<7}{:<11}{:>14}{:>12}{:>14}{:>10}  {}\n", gear, load, shown(peak, measure::force, units),
                     shown(at, measure::distance, units), limit > 0 ? shown(limit, measure::force, units) : "-",
                     limit > 0 ? percent(margin, 1) : "-", rule);
}

void add_gears(std::string& out, const OverrunRecord& record, UnitSystem units) {
  out += fmt::format("\n  {:<7}{:<11}{:>14}{:>12}{:>14}{:>10}  {}\n", "gear", "per strut", "peak", "at", "limit",
                     "margin", "rule");
  for (const auto& gear : record.result.gears) {
    add_load_row(out, gear.name.c_str(), "drag", gear.peak_drag, gear.peak_drag_distance, gear.drag_limit,
                 gear.drag_margin, gear.drag_rule, units);
    if (gear.drag_ultimate > 0)
      add_load_row(out, "", "  ultimate", gear.peak_drag, gear.peak_drag_distance, gear.drag_ultimate,
                   gear.ultimate_margin, "", units);
    add_load_row(out, "", "vertical", gear.peak_vertical, gear.peak_vertical_distance, gear.vertical_limit,
                 gear.vertical_margin, gear.vertical_rule, units);
    out += fmt::format("  {:<7}stroke {} of {}{}; penetration {}, rut {}\n", "",
                       shown(gear.peak_stroke, measure::depth, units), shown(gear.stroke, measure::depth, units),
                       gear.bottomed ? " (bottomed)" : "", shown(gear.peak_penetration, measure::depth, units),
                       shown(gear.peak_rut, measure::depth, units));
  }
}

void add_energy(std::string& out, const OverrunRecord& record, UnitSystem units) {
  const double entry = entry_energy(record.result);
  out +=
      fmt::format("\n  energy         {} of motion at entry; where it went:\n", shown(entry, measure::energy, units));
  for (const auto& [key, value] : energy_sinks(record.result))
    out += fmt::format("    {:<24}{:>20}{:>10}\n", energy_name(key), shown(value, measure::energy, units),
                       percent(entry > 0 ? value / entry : 0.0, 2));
  if (const auto residual = record.result.energy.find("residual"); residual != record.result.energy.end())
    out += fmt::format("    {:<24}{:>20.1e}\n", "residual, relative", residual->second);
}

/// In SI whatever the report's units: derivatives are compared with the result file's numbers. A row per result, a
/// column per input.
void add_sensitivities(std::string& out, const OverrunRecord& record) {
  if (record.sensitivities.empty()) return;
  using simulation::Sensitivity;
  const auto row = [&](const std::string& name, const auto& value) {
    out += fmt::format("  {:<34}", name);
    for (const auto& each : record.sensitivities) {
      const double slope = value(each.by);
      out += fmt::format("{:>24}", std::isfinite(slope) ? fmt::format("{:.5g}", slope) : std::string("-"));
    }
    out += "\n";
  };
  out += fmt::format("\n  {:<34}", "derivative by one unit of");
  for (const auto& [by, unit] : record.sensitivities)
    out += fmt::format("{:>24}", by.parameter + (unit == "1" ? "" : ", " + unit));
  out += "\n";
  for (const auto& [name, member] : std::initializer_list<std::pair<const char*, double Sensitivity::*>>{
           {"stop, m", &Sensitivity::stop_distance},
           {"exit speed, m/s", &Sensitivity::exit_speed},
           {"time, s", &Sensitivity::stop_time},
           {"peak deceleration, m/s^2", &Sensitivity::peak_deceleration},
           {"largest 0.1 s mean, m/s^2", &Sensitivity::peak_deceleration_100ms},
           {"mean deceleration, m/s^2", &Sensitivity::mean_deceleration},
           {"lowest pitch, rad", &Sensitivity::lowest_pitch},
           {"highest pitch, rad", &Sensitivity::peak_pitch}})
    row(name, [m = member](const Sensitivity& by) { return by.*m; });
  using Gear = Sensitivity::Gear;
  const auto& gears = record.sensitivities.front().by.gears;
  for (std::size_t g = 0; g < gears.size(); ++g)
    for (const auto& [name, member] :
         std::initializer_list<std::pair<const char*, double Gear::*>>{{"drag, N", &Gear::peak_drag},
                                                                       {"mean drag, N", &Gear::mean_drag},
                                                                       {"vertical, N", &Gear::peak_vertical},
                                                                       {"drag margin", &Gear::drag_margin},
                                                                       {"ultimate margin", &Gear::ultimate_margin},
                                                                       {"vertical margin", &Gear::vertical_margin},
                                                                       {"stroke, m", &Gear::peak_stroke},
                                                                       {"penetration, m", &Gear::peak_penetration},
                                                                       {"rut, m", &Gear::peak_rut},
                                                                       {"tire load, N", &Gear::peak_tire_load}})
      row(gears[g].name + " " + name, [g, m = member](const Sensitivity& by) { return by.gears[g].*m; });
  for (const auto& [key, value] : record.sensitivities.front().by.energy)
    row("energy " + energy_name(key) + ", J", [&key = key](const Sensitivity& by) { return by.energy.at(key); });
}

}  // namespace

std::vector<std::string> additions(const OverrunRecord& record) {
  std::vector<std::string> list;
  for (const auto& applied : record.overrun.alterations.effects) {
    std::string one = fmt::format("{} ({}):", applied.effect.title, applied.effect.id);
    for (std::size_t i = 0; i < applied.values.size(); ++i) {
      const auto& parameter = applied.effect.parameters[i];
      one += fmt::format(" {} {:.4g}{}{}", parameter.name, applied.values[i], parameter.unit.empty() ? "" : " ",
                         parameter.unit);
    }
    list.push_back(std::move(one));
  }
  if (record.overrun.sinking.counts())
    list.push_back(fmt::format("response to the rate of sinking, {:.3g} times the rigid wheel's",
                               record.overrun.sinking.vertical));
  return list;
}

std::string energy_name(const std::string& key) {
  static const std::map<std::string, std::string> names{{"kinetic", "motion at entry"},
                                                        {"kinetic_left", "motion left"},
                                                        {"potential", "potential"},
                                                        {"bed", "bed"},
                                                        {"tires", "tires"},
                                                        {"oleo_gas", "strut gas"},
                                                        {"oleo_damping", "strut damping"},
                                                        {"strut_friction", "strut friction"},
                                                        {"stops", "strut stops"},
                                                        {"brakes", "brakes"},
                                                        {"wheel_slip", "wheel slip"},
                                                        {"bogie_damping", "bogie damping"},
                                                        {"aero", "air"},
                                                        {"thrust", "thrust"}};

  const auto found = names.find(key);
  if (found != names.end()) return found->second;
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

double entry_energy(const simulation::Result& result) {
  const auto given = result.energy.find("kinetic");
  return given != result.energy.end() ? given->second : 0.5 * result.mass * std::pow(result.entry_speed, 2);
}

std::vector<std::pair<std::string, double>> energy_sinks(const simulation::Result& result) {
  std::vector<std::pair<std::string, double>> sinks;
  for (const auto& [key, value] : result.energy)
    if (key != "residual" && key != "kinetic" && std::abs(value) > 1e-6 * entry_energy(result))
      sinks.emplace_back(key, value);
  std::stable_sort(sinks.begin(), sinks.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.second) > std::abs(b.second); });
  return sinks;
}

std::string coverage_text(const simulation::CoverageSummary& coverage) {
  auto text = percent(coverage.inside, 1) + " of the time inside";
  const auto add = [&](double share, const char* what) {
    if (share > 0) text += fmt::format("; {} {}", what, percent(share, 1));
  };
  add(coverage.speed_below, "speed below the range");
  add(coverage.speed_above, "speed above it");
  add(coverage.depth_outside, "bed depth outside");
  add(coverage.penetration_outside, "penetration outside");
  return text;
}

std::string headline(const OverrunRecord& record, UnitSystem units) {
  return fmt::format("{} leaves the runway into \"{}\", {} at the bed's edge", record.model.aircraft.name,
                     record.model.bed.name, shown(record.result.entry_speed, measure::speed, units));
}

std::string brief(const OverrunRecord& record, UnitSystem units) {
  const auto& result = record.result;
  std::string out;
  for (const auto& warning : result.warnings) out += "warning: " + warning + "\n";
  if (!result.warnings.empty()) out += "\n";
  out += headline(record, units) + "\n";
  out +=
      fmt::format("  mass {}, centre of gravity {} behind the nose gear\n\n", shown(result.mass, measure::mass, units),
                  shown(result.cg_behind_nose_gear, measure::distance, units));
  add_outcome(out, record, units);
  add_gears(out, record, units);
  add_energy(out, record, units);
  add_sensitivities(out, record);
  out += "\n";
  for (const auto& coverage : result.coverage)
    out += fmt::format("  load table     {:<6}{}: {}\n", coverage.gear, coverage.tire, coverage_text(coverage));
  const auto& solver = result.solver;
  out += fmt::format("  solver         {}, rtol {:.0e}: {} steps, {} right-hand sides, {:.3f} s\n", solver.method,
                     solver.rtol, number(static_cast<double>(solver.steps), 0),
                     number(static_cast<double>(solver.rhs_calls), 0), solver.wall_s);
  for (const auto& file : record.manifest.files)
    out += fmt::format("  {:<15}{}  sha256 {}\n", file.role, file.path, file.sha256.substr(0, 12));
  return out;
}

}  // namespace apc::report
