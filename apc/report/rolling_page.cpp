/// The page of one SPH run: loads along the travel, the section the tire left, every term of the energy account.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/report/page_parts.h"
#include "apc/report/plot.h"
#include "apc/report/rolling_record.h"
#include "apc/report/rut_section.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

std::vector<Plot> plots_of(const RollingRecord& record) {
  std::vector<Plot> plots;
  plots.push_back(
      {"Drag", measure::force, {{"drag", "main", record.drag_history}}, {{"steady", "total", record.drag}}});
  plots.push_back({"Vertical load",
                   measure::force,
                   {{"vertical", "nose", record.vertical_history}},
                   {{"steady", "total", record.vertical}}});
  plots.push_back(
      {"Spin ratio", measure::ratio, {{"spin", "third", record.spin_history}}, {{"free rolling", "total", 1.0}}});
  plots.push_back({"Tire deflection", measure::depth, {{"deflection", "total", record.deflection_history}}, {}});
  std::erase_if(plots, [&](const Plot& plot) { return plot.curves.front().values.size() != record.distance.size(); });
  if (!record.steady)
    for (auto& plot : plots) std::erase_if(plot.levels, [](const Level& level) { return level.name == "steady"; });
  return plots;
}

std::string shape_rows(const RollingRecord& record) {
  if (record.shape.empty()) return "";
  std::string out = "<table><tbody>\n";
  for (const auto& each : record.shape)
    out += row(each.name, std::isfinite(each.value) ? both(each.value, measure::depth) : "-");
  return out + "</tbody></table>\n";
}

std::string energy_rows(const RollingRecord& record) {
  double input = 0.0, largest = 0.0;
  for (const auto& term : record.energy_in) input += term.second;
  for (const auto* side : {&record.energy_in, &record.energy_out})
    for (const auto& term : *side) largest = std::max(largest, std::abs(term.second));
  std::string out =
      "<table class=\"energy\"><thead><tr><th></th><th>term, modelled half</th><th class=\"n\">kJ</th><th "
      "class=\"n\">share</th><th></th></tr></thead><tbody>\n";
  const auto rows = [&](const char* side, const std::vector<std::pair<std::string, double>>& terms) {
    for (const auto& [name, value] : terms)
      out += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"b\"><div "
          "class=\"fill{}\" style=\"width:{:.1f}%\"></div></td></tr>\n",
          side, escaped(name), number(value / 1e3, 2), input != 0 ? percent(value / input, 2) : "-",
          value < 0 ? " minus" : "", largest > 0 ? 100 * std::abs(value) / largest : 0.0);
  };
  rows("in", record.energy_in);
  rows("out", record.energy_out);
  return out +
         fmt::format("<tr><td></td><td>residual</td><td></td><td class=\"n\">{}</td><td></td></tr></tbody></table>\n",
                     percent(record.residual, 3));
}

}  // namespace

std::string rolling_page(const RollingRecord& record) {
  std::string out = page_head(record.tire + " in " + record.material);
  out += fmt::format(
      "<header><h1>{} in {}, {}</h1><p class=\"sub\">{} of bed, penetration {} ({} of the largest), "
      "particles {} apart, friction {}</p>\n{}<div class=\"cards\">\n",
      escaped(record.tire), escaped(record.material), both(record.speed, measure::speed),
      both(record.bed_depth, measure::depth), both(record.penetration, measure::depth),
      percent(record.maximum_penetration > 0 ? record.penetration / record.maximum_penetration : 0.0),
      both(record.spacing, measure::depth),
      number(record.friction, 2) + (record.fall != 0.0 ? ", sinking by " + number(record.fall, 3) + " of the way" : ""),
      switches_bar());
  out += card(record.steady ? "good" : "bad", "State", record.steady ? "Steady" : escaped(record.state),
              record.steady ? (record.fall != 0.0 ? "means around the penetration" : "loads settled")
                            : "not to be used as loads");
  out += card("", "Drag", both(record.drag, measure::force), "whole tire");
  out += card("", "Vertical", both(record.vertical, measure::force), "whole tire");
  out += card("", "Rut", both(record.rut_depth, measure::depth),
              "surface left behind: " + both(record.surface_left, measure::depth) + " below the top");
  out += card(std::abs(record.residual) > 0.01 ? "warn" : "good", "Energy residual", percent(record.residual, 2),
              "spin ratio " + number(record.spin_ratio, 3));
  out += "</div>\n";
  if (!record.message.empty() && !record.steady) out += "<p class=\"warning\">" + escaped(record.message) + "</p>\n";
  out += "</header>\n<main>\n<h2>Along the travel</h2>\n<div class=\"plots\">\n";
  const Abscissa axes{record.distance, record.time, "travel of the axle since rolling began",
                      "time since rolling began"};
  const auto plots = record.distance.size() > 1 ? plots_of(record) : std::vector<Plot>{};
  for (std::size_t i = 0; i < plots.size(); ++i) out += figure(plots[i], axes, i);
  out +=
      "</div>\n<h2>The rut behind the tire</h2>\n<p class=\"sub\">Particles of one slice, seen along the runway, to "
      "scale; the darker, the more crushed. Dashed: the surface, and what the undeformed wheel would cut.</p>\n";
  out += rut_section(record) + shape_rows(record);
  out += "\n<h2>Energy account</h2>\n" + energy_rows(record);
  out += "<h2>How to make this run again</h2>\n<table><tbody>\n";
  out += row("Command", "<code>" + escaped(record.manifest.command) + "</code>");
  out += row("Program", escaped(record.manifest.version));
  out += row("Page made", escaped(record.manifest.date));
  out +=
      row("Size", number(record.particles, 0) + " particles, " + number(record.steps, 0) + " steps, " +
                      number(record.particle_steps_per_s / 1e6, 2) + " million particle-steps per second, " +
                      number(record.wall_s, 1) + " s, " + number(record.bytes_per_particle, 0) + " bytes per particle");
  out += row("Quality", "largest compaction " + percent(record.compaction, 1) + "; sum of V W in the crushed foam " +
                            number(record.partition_mean, 3) + ", lowest " + number(record.partition_min, 3));
  out += row("Source", escaped(record.source));
  for (const auto& file : record.manifest.files) out += file_row(file);
  out +=
      "</tbody></table>\n</main>\n<footer>apc, the Arrestor Prediction Code. Loads are of the whole tire, steady, "
      "free-rolling, unbraked.</footer>\n";
  return out + page_end(plots.empty() ? no_series() : series(plots, axes));
}

}  // namespace apc::report
