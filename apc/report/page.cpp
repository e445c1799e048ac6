#include "apc/report/page.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "apc/report/bed_section.h"
#include "apc/report/brief.h"
#include "apc/report/page_parts.h"
#include "apc/report/page_tables.h"
#include "apc/report/plot.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

using simulation::History;

std::vector<double> picked(const std::vector<double>& column, const std::vector<std::size_t>& rows,
                           double factor = 1.0) {
  std::vector<double> out;
  if (column.empty()) return out;
  for (const auto row : rows) out.push_back(factor * column[row]);
  return out;
}

/// What the page shows over distance and time.
std::vector<Plot> plots_of(const OverrunRecord& record, const std::vector<std::size_t>& rows) {
  const auto& result = record.result;
  const auto& history = result.history;
  std::vector<Plot> plots;
  plots.push_back(
      {"Speed",
       measure::speed,
       {{"speed", "total", picked(history.speed, rows)}},
       {},
       both(result.entry_speed, measure::speed) + " at the bed's edge, " +
           (std::isfinite(result.stop_distance) ? "at rest after " + both(result.stop_distance, measure::distance)
                                                : both(result.exit_speed, measure::speed) + " at its end")});
  plots.push_back({"Deceleration",
                   measure::acceleration,
                   {{"deceleration", "total", picked(history.deceleration, rows)}},
                   {{"mean", "total", result.mean_deceleration}}});
  // One curve per gear from a column of its history; `share` turns the group's load into a strut's.
  const auto per_gear = [&](const char* title, const Measure& in, const std::vector<double> History::Gear::*column,
                            const std::function<double(const simulation::GearSummary&)>& share) {
    Plot plot{title, in, {}, {}};
    for (std::size_t i = 0; i < history.gears.size(); ++i)
      plot.curves.push_back(
          {result.gears[i].name, gear_look(i), picked(history.gears[i].*column, rows, share(result.gears[i]))});
    return plot;
  };
  const auto one = [](const simulation::GearSummary&) { return 1.0; };
  const auto per_strut = [](const simulation::GearSummary& gear) { return 1.0 / std::max(1, gear.struts); };
  const auto drag = per_gear("", measure::force, &History::Gear::drag, per_strut);
  for (std::size_t i = 0; i < history.gears.size(); ++i) {
    Plot plot{"Drag per " + result.gears[i].name + " strut", measure::force, {drag.curves[i]}, {}};
    if (result.gears[i].drag_limit > 0) plot.levels.push_back({"limit", "limit", result.gears[i].drag_limit});
    if (result.gears[i].drag_ultimate > 0)
      plot.levels.push_back({"ultimate", "ultimate", result.gears[i].drag_ultimate});
    plots.push_back(plot);
  }
  auto vertical = per_gear("Vertical load per strut", measure::force, &History::Gear::vertical, per_strut);
  for (std::size_t i = 0; i < result.gears.size(); ++i)
    if (result.gears[i].vertical_limit > 0)
      vertical.levels.push_back({result.gears[i].name + " limit", gear_look(i), result.gears[i].vertical_limit});
  plots.push_back(vertical);
  auto stroke = per_gear("Strut stroke", measure::depth, &History::Gear::stroke, one);
  for (std::size_t i = 0; i < result.gears.size(); ++i)
    if (result.gears[i].stroke > 0)
      stroke.levels.push_back({result.gears[i].name + " available", gear_look(i), result.gears[i].stroke});
  plots.push_back(stroke);
  auto depth = per_gear("Penetration, rut dashed", measure::depth, &History::Gear::penetration, one);
  for (std::size_t i = 0; i < history.gears.size(); ++i)
    depth.curves.push_back({result.gears[i].name + " rut", "rut-" + gear_look(i), picked(history.gears[i].rut, rows)});
  plots.push_back(depth);
  plots.push_back({"Pitch, nose up", measure::angle, {{"pitch", "total", picked(history.pitch, rows)}}, {}});
  Plot energy{"Energy", measure::energy, {{"motion", "total", {}}}, {}};
  for (const auto row : rows) energy.curves[0].values.push_back(0.5 * result.mass * std::pow(history.speed[row], 2));
  if (!history.dissipated.empty()) energy.curves.push_back({"dissipated", "main", picked(history.dissipated, rows)});
  energy.note = both(entry_energy(result), measure::energy) + " at the bed's edge";
  plots.push_back(energy);
  for (auto& plot : plots) std::erase_if(plot.curves, [](const Curve& curve) { return curve.values.empty(); });
  std::erase_if(plots, [](const Plot& plot) { return plot.curves.empty(); });
  return plots;
}

/// The rows to draw: thinned, and without most of the roll before the bed.
std::vector<std::size_t> shown_rows(const History& history) {
  auto rows = thinned_rows(history, 500);
  if (rows.empty()) return rows;
  const double from = -0.08 * history.distance.back();
  std::erase_if(rows, [&](std::size_t row) { return history.distance[row] < from; });
  return rows;
}

}  // namespace

std::string page(const OverrunRecord& record) {
  const auto& result = record.result;
  std::string out = page_head(record.model.aircraft.name + " in " + record.model.bed.name);
  out += fmt::format(
      "<header><h1>{}, {} at the bed's edge</h1><p class=\"sub\">{} · {}</p>\n", escaped(record.model.aircraft.name),
      both(result.entry_speed, measure::speed), escaped(record.model.bed.name),
      result.outcome == simulation::Outcome::gear_limit || result.outcome == simulation::Outcome::pitched_over
          ? escaped(result.message)
          : both(result.mass, measure::mass) + " of " + escaped(record.model.aircraft.name));
  out += switches_bar() + headline_cards(record);
  for (const auto& addition : additions(record)) out += "<p class=\"warning\">with " + escaped(addition) + "</p>\n";
  for (const auto& warning : result.warnings) out += "<p class=\"warning\">" + escaped(warning) + "</p>\n";
  out += "</header>\n<main>\n<h2>Bed section</h2>\n<div class=\"wide\">" + bed_section(record) + "</div>\n";
  if (const auto wheels = wheels_at_rest(record); !wheels.empty())
    out += "<div class=\"plots\">\n" + wheels + "</div>\n";

  std::string data = no_series();
  if (const auto rows = shown_rows(result.history); rows.size() > 1) {
    const Abscissa axes{picked(result.history.distance, rows), picked(result.history.time, rows)};
    const auto plots = plots_of(record, rows);
    out += "<h2>Histories</h2>\n<div class=\"plots\">\n";
    for (std::size_t i = 0; i < plots.size(); ++i) out += figure(plots[i], axes, i);
    out += "</div>\n";
    data = series(plots, axes);
  }
  out += "<h2>Gear loads and margins</h2>\n" + gear_table(record);
  out += "<h2>Energy by sink</h2>\n" + energy_table(record);
  out += "<h2>Load tables: were they used inside their range?</h2>\n" + coverage_table(record);
  out += "<h2>Inputs and sources</h2>\n" + inputs_table(record);
  out += "<h2>How to make this run again</h2>\n" + manifest_table(record);
  out +=
      "</main>\n<footer>apc, the Arrestor Prediction Code. Loads per strut; margin = limit / peak − 1; distances "
      "from the bed's leading edge to the nose wheel; 0.1 s means smooth the peak deceleration.</footer>\n";
  return out + page_end(data);
}

}  // namespace apc::report
