#include "apc/report/page_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "apc/base/units.h"
#include "apc/report/brief.h"
#include "apc/report/page_parts.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

using simulation::GearSummary;

std::string signed_percent(double share) { return (share > 0 ? "+" : "") + percent(share, 1); }

const char* mood_of(double margin) { return margin < 0 ? "over" : margin < 0.1 ? "near" : ""; }

}  // namespace

std::string headline_cards(const OverrunRecord& record) {
  const auto& result = record.result;
  using simulation::Outcome;
  std::string out = "<div class=\"cards\">\n";
  if (result.outcome == Outcome::stopped)
    out +=
        card("good", "Outcome", "Stopped", fmt::format("after {} in the bed", both(result.stop_time, measure::time)));
  else if (result.outcome == Outcome::pitched_over)
    out += card("bad", "Outcome", "Pitched over", "at " + both(result.exit_speed, measure::speed));
  else if (result.outcome == Outcome::left_bed)
    out += card("bad", "Outcome", "Left the bed", "still at " + both(result.exit_speed, measure::speed));
  else
    out += card("bad", "Outcome", "Gear limit", "a gear passed its ultimate load");
  const auto& bed = record.model.bed;
  if (std::isfinite(result.stop_distance))
    out += card("", result.gear_failed() ? "Stop distance, if the gear had held" : "Stop distance",
                both(result.stop_distance, measure::distance),
                "of " + both(bed.length(), measure::distance) + " of bed; " +
                    both(result.runway_distance, measure::distance) + " from the pavement end");
  else
    out += card("bad", "Stop distance", "none", "the bed is " + both(bed.length(), measure::distance) + " long");
  out += card("", "Peak deceleration", both(result.peak_deceleration, measure::acceleration),
              "largest 0.1 s mean " + both(result.peak_deceleration_100ms, measure::acceleration));
  out += card("", "Mean deceleration", both(result.mean_deceleration, measure::acceleration), "v² / (2 × distance)");
  const auto worst = worst_margin(result);
  if (worst.gear.empty())
    out += card("", "Worst margin", "unknown", "the aircraft file gives no limits");
  else
    out += card(
        worst.margin < 0     ? "bad"
        : worst.margin < 0.1 ? "warn"
                             : "good",
        "Worst margin", signed_percent(worst.margin),
        fmt::format("{} {} {} of {} ({}), at {}", escaped(worst.gear), worst.load, both(worst.peak, measure::force),
                    both(worst.limit, measure::force), escaped(worst.rule), both(worst.distance, measure::distance)));
  return out + "</div>\n";
}

std::string gear_table(const OverrunRecord& record) {
  const auto& gears = record.result.gears;
  std::string out = "<div class=\"wide\"><table><thead><tr><th>per strut</th>";
  for (const auto& gear : gears)
    out += fmt::format("<th class=\"n\">{}<br>{} × {} wheels</th>", escaped(gear.name), gear.struts, gear.wheels);
  out += "</tr></thead><tbody>\n";
  const auto add = [&](const char* name, const std::function<std::string(const GearSummary&)>& cell,
                       const std::function<double(const GearSummary&)>& margin = {}) {
    out += fmt::format("<tr><th>{}</th>", name);
    for (const auto& gear : gears)
      out += fmt::format("<td class=\"n {}\">{}</td>", margin ? mood_of(margin(gear)) : "", cell(gear));
    out += "</tr>\n";
  };
  const auto part = [&](const char* name) {
    out += fmt::format("<tr class=\"part\"><th colspan=\"{}\">{}</th></tr>\n", gears.size() + 1, name);
  };
  const auto limit = [](double value) { return value > 0 ? both(value, measure::force) : std::string("-"); };
  const auto margin = [](double value, double known) { return known > 0 ? signed_percent(value) : std::string("-"); };
  const auto rule = [](const std::string& text) {
    return "<span class=\"rule\">" + (text.empty() ? "-" : escaped(text)) + "</span>";
  };
  part("Drag");
  add("peak", [](const GearSummary& g) { return both(g.peak_drag, measure::force); });
  add("at distance", [](const GearSummary& g) { return both(g.peak_drag_distance, measure::distance); });
  add("mean in the bed", [](const GearSummary& g) { return both(g.mean_drag, measure::force); });
  add("limit", [&](const GearSummary& g) { return limit(g.drag_limit); });
  add(
      "margin to the limit", [&](const GearSummary& g) { return margin(g.drag_margin, g.drag_limit); },
      [](const GearSummary& g) { return g.drag_limit > 0 ? g.drag_margin : 1.0; });
  add("ultimate", [&](const GearSummary& g) { return limit(g.drag_ultimate); });
  add(
      "margin to ultimate", [&](const GearSummary& g) { return margin(g.ultimate_margin, g.drag_ultimate); },
      [](const GearSummary& g) { return g.drag_ultimate > 0 ? g.ultimate_margin : 1.0; });
  add("rule", [&](const GearSummary& g) { return rule(g.drag_rule); });
  part("Vertical load");
  add("peak", [](const GearSummary& g) { return both(g.peak_vertical, measure::force); });
  add("at distance", [](const GearSummary& g) { return both(g.peak_vertical_distance, measure::distance); });
  add("ultimate", [&](const GearSummary& g) { return limit(g.vertical_ultimate); });
  add("static, at rest", [](const GearSummary& g) { return both(g.static_vertical, measure::force); });
  add("limit", [&](const GearSummary& g) { return limit(g.vertical_limit); });
  add(
      "margin to the limit", [&](const GearSummary& g) { return margin(g.vertical_margin, g.vertical_limit); },
      [](const GearSummary& g) { return g.vertical_limit > 0 ? g.vertical_margin : 1.0; });
  add("rule", [&](const GearSummary& g) { return rule(g.vertical_rule); });
  part("Failure and lift-off");
  add("failed by", [](const GearSummary& g) {
    return g.failed_by.empty()
               ? std::string("held")
               : (g.failed_by == "drag" ? "drag, " : "vertical load, ") + both(g.failed_at, measure::distance);
  });
  add("off the ground", [](const GearSummary& g) {
    return g.airborne > 0 ? both(g.airborne, measure::time) + " from " + both(g.lifted_at, measure::distance)
                          : std::string("never");
  });
  add("largest tire load", [](const GearSummary& g) {
    return both(g.peak_tire_load, measure::force) + (g.tire_bottomed ? " (bottomed)" : "");
  });
  part("Strut and rut");
  add("peak stroke",
      [](const GearSummary& g) { return both(g.peak_stroke, measure::depth) + (g.bottomed ? " (bottomed)" : ""); });
  add("available stroke", [](const GearSummary& g) { return both(g.stroke, measure::depth); });
  add("deepest penetration", [](const GearSummary& g) { return both(g.peak_penetration, measure::depth); });
  add("deepest rut", [](const GearSummary& g) { return both(g.peak_rut, measure::depth); });
  return out + "</tbody></table></div>\n";
}

std::string energy_table(const OverrunRecord& record) {
  const double entry = entry_energy(record.result);
  const auto terms = energy_sinks(record.result);
  const double largest = terms.empty() ? 0.0 : std::abs(terms.front().second);
  std::string out = fmt::format(
      "<p class=\"sub\">Motion at the bed's edge: {}.</p><table class=\"energy\"><thead><tr><th>"
      "sink or store</th><th class=\"n\">{}</th><th class=\"n\">share</th><th></th></tr>"
      "</thead><tbody>\n",
      both(entry, measure::energy), both_units(measure::energy));
  for (const auto& [key, value] : terms)
    out += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"b\"><div class=\"fill{}\" "
        "style=\"width:{:.1f}%\"></div></td></tr>\n",
        escaped(energy_name(key)), both_numbers(value, measure::energy), entry > 0 ? percent(value / entry, 2) : "-",
        value < 0 ? " minus" : "", largest > 0 ? 100 * std::abs(value) / largest : 0.0);
  if (const auto residual = record.result.energy.find("residual"); residual != record.result.energy.end())
    out += fmt::format("<tr><td>residual, relative</td><td class=\"n\">{:.1e}</td><td></td><td></td></tr>\n",
                       residual->second);
  return out + "</tbody></table>\n";
}

std::string coverage_table(const OverrunRecord& record) {
  std::string out =
      "<div class=\"wide\"><table><thead><tr><th>gear</th><th>tire</th><th class=\"n\">inside the table</th><th "
      "class=\"n\">"
      "too slow</th><th class=\"n\">too fast</th><th class=\"n\">depth outside</th><th class=\"n\">sunk "
      "outside</th></tr></thead><tbody>\n";
  for (const auto& each : record.result.coverage)
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        escaped(each.gear), escaped(each.tire), percent(each.inside, 1), percent(each.speed_below, 1),
        percent(each.speed_above, 1), percent(each.depth_outside, 1), percent(each.penetration_outside, 1));
  out +=
      "</tbody></table></div>\n<div class=\"wide\"><table><thead><tr><th>table</th><th>material</th><th "
      "class=\"n\">runs</th>"
      "<th class=\"n\">drag, leave-one-out</th><th class=\"n\">vertical, leave-one-out</th></tr></thead><tbody>\n";
  std::vector<std::string> seen;
  for (const auto& table : record.model.tables) {
    const auto& name = table.tire().name;
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
    seen.push_back(name);
    const auto error = [&](const char* response) {
      for (const auto& quality : table.quality())
        if (quality.response == response) return percent(quality.loo_rms_relative, 1);
      return std::string("-");
    };
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        escaped(name), escaped(table.provenance().material), table.provenance().runs, error("drag"), error("vertical"));
  }
  return out +
         "</tbody></table></div>\n<p class=\"sub\">Shares of the time in the bed. Outside its fitted range a table "
         "continues smoothly; what it says there is extrapolation.</p>\n";
}

std::string inputs_table(const OverrunRecord& record) {
  const auto& overrun = record.overrun;
  const auto& bed = record.model.bed;
  const auto& plane = record.model.aircraft;
  std::string out = "<div class=\"two\"><table><tbody>\n";
  out += row("Aircraft", escaped(plane.name));
  out += row("Mass", both(record.result.mass, measure::mass));
  out += row("Centre of gravity", both(record.result.cg_behind_nose_gear, measure::distance) +
                                      " behind the nose gear, " + both(plane.cg_height, measure::distance) + " high");
  out += row("Entry speed", both(overrun.entry_speed, measure::speed));
  const double inside = overrun.braking_in_bed < 0 ? overrun.braking : overrun.braking_in_bed;
  out += row("Braking",
             fmt::format("friction {} before the bed, {} inside it", number(overrun.braking, 2), number(inside, 2)));
  out += row("Thrust", both(overrun.thrust, measure::force));
  out += row("Headwind", both(overrun.headwind, measure::speed));
  out += "</tbody></table><table><tbody>\n";
  out += row("Bed", escaped(bed.name));
  out +=
      row("Material", escaped(bed.material) + (bed.nominal ? ", " + both(bed.nominal->strength, measure::pressure) +
                                                                 ", " + both(bed.nominal->density, measure::density) +
                                                                 ", full at " + percent(bed.nominal->bottoming_strain)
                                                           : ""));
  out += row("Size", both(bed.length(), measure::distance) + " × " + both(bed.width, measure::distance) + ", up to " +
                         both(bed.maximum_depth(), measure::depth) + " deep, " + both(bed.volume(), measure::volume));
  out += row("Set-back", both(bed.setback, measure::distance) + " from the pavement end");
  out +=
      row("Flush", bed.flush == bed::Flush::top ? "surface level with the pavement" : "base level with the pavement");
  out += row("Grade", percent(bed.grade, 2));
  out += "</tbody></table></div>\n<table><tbody>\n";
  for (const auto& file : record.manifest.files)
    if (!file.source.empty()) out += row("Source, " + escaped(file.role), escaped(file.source));
  return out + "</tbody></table>\n";
}

std::string manifest_table(const OverrunRecord& record) {
  const auto& solver = record.result.solver;
  std::string out = "<table><tbody>\n";
  out += row("Command", "<code>" + escaped(record.manifest.command) + "</code>");
  out += row("Program", escaped(record.manifest.version));
  out += row("Page made", escaped(record.manifest.date));
  out += row("Solver",
             fmt::format("{}, relative tolerance {:.0e}: {} steps, {} right-hand sides, {} Jacobians, {} rejected "
                         "steps, {:.3f} s",
                         escaped(solver.method), solver.rtol, number(static_cast<double>(solver.steps), 0),
                         number(static_cast<double>(solver.rhs_calls), 0), solver.jacobians, solver.error_test_failures,
                         solver.wall_s));
  for (const auto& file : record.manifest.files) out += file_row(file);
  return out + "</tbody></table>\n";
}

}  // namespace apc::report
