#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/report/study_record.h"

namespace apc::report {
namespace {

using study::Criterion;

std::string margin_text(double margin) {
  return std::isfinite(margin) ? (margin > 0 ? "+" : "") + percent(margin, 1) : std::string("-");
}

void add_case(std::string& out, const study::CaseResult& each, UnitSystem units) {
  const auto& run = each.input.overrun;
  out += fmt::format("  {:>10} {:>13} {:>8} {:>8}", shown(run.entry_speed, measure::speed, units),
                     shown(run.mass, measure::mass, units), number(run.braking, 2),
                     percent(run.alterations.bed_strength, 0));
  if (!each.failure.empty()) {
    out += "  solver gave up: " + each.failure + "\n";
    return;
  }
  const auto& result = each.result;
  const bool stopped = std::isfinite(result.stop_distance);
  out += fmt::format(" {:>12} {:>12} {:>10} {:>10} {:>10}\n",
                     stopped ? shown(result.stop_distance, measure::distance, units)
                     : result.outcome == simulation::Outcome::pitched_over ? "fell over at"
                                                                           : "left at",
                     stopped ? "" : shown(result.exit_speed, measure::speed, units),
                     shown(result.peak_deceleration, measure::acceleration, units),
                     margin_text(study::worst_margin(result, Criterion::limit)),
                     margin_text(study::worst_margin(result, Criterion::ultimate)));
}

/// The gear that failed first, by what; and of all gears the worst share of time in the bed: inside, outside by cause.
std::string failure_and_coverage(const simulation::Result& result) {
  const simulation::GearSummary* first = nullptr;
  for (const auto& gear : result.gears)
    if (!gear.failed_by.empty() && (!first || gear.failed_time < first->failed_time)) first = &gear;
  simulation::CoverageSummary worst;
  for (const auto& each : result.coverage) {
    worst.inside = std::min(worst.inside, each.inside);
    worst.speed_below = std::max(worst.speed_below, each.speed_below);
    worst.speed_above = std::max(worst.speed_above, each.speed_above);
    worst.depth_outside = std::max(worst.depth_outside, each.depth_outside);
    worst.penetration_outside = std::max(worst.penetration_outside, each.penetration_outside);
  }
  return fmt::format("{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g}", first ? first->name : "",
                     first ? first->failed_by : "", worst.inside, worst.speed_below, worst.speed_above,
                     worst.depth_outside, worst.penetration_outside);
}

}  // namespace

std::string study_brief(const StudyRecord& record, UnitSystem units) {
  std::string out;
  for (std::size_t m = 0; m < record.models.size(); ++m) {
    const auto& model = record.models[m];
    out += fmt::format("{} in \"{}\", {} long\n", model.aircraft.name, model.bed.name,
                       shown(model.bed.length(), measure::distance, units));
    out += fmt::format("  {:>10} {:>13} {:>8} {:>8} {:>12} {:>12} {:>10} {:>10} {:>10}\n", "exit speed", "mass",
                       "braking", "strength", "stop", "", "peak", "limit", "ultimate");
    for (const auto& each : record.results)
      if (each.input.model == m) add_case(out, each, units);
    out += "\n";
  }
  for (const auto& tornado : record.tornados) {
    out += fmt::format("What matters: {} in \"{}\" from {}, stop {} (bed continued), worst margin {}\n",
                       tornado.aircraft, tornado.bed, shown(tornado.entry_speed, measure::speed, units),
                       shown(tornado.distance, measure::distance, units), margin_text(tornado.margin));
    for (const auto& bar : tornado.bars)
      out += fmt::format("  {:<18} {:>28} {:>12} {:>12}   margin {:>8} {:>8}\n", bar.input, bar.low + " … " + bar.high,
                         shown(bar.distance_low, measure::distance, units),
                         shown(bar.distance_high, measure::distance, units), margin_text(bar.margin_low),
                         margin_text(bar.margin_high));
    out += "\n";
  }
  std::size_t failed = 0;
  for (const auto& each : record.results) failed += each.failure.empty() ? 0 : 1;
  return out + fmt::format("  {} cases, {} of them from an earlier start, {} the solver gave up; {:.1f} s\n",
                           record.results.size(), record.remembered, failed, record.seconds);
}

std::string study_csv(const StudyRecord& record) {
  std::string out =
      "# schema: apc-study/1\naircraft,bed,entry_speed [m/s],mass [kg],braking,strength,outcome,stop_distance [m],"
      "runway_distance [m],exit_speed [m/s],peak_deceleration [m/s^2],mean_deceleration [m/s^2],worst_margin,"
      "worst_ultimate_margin,failed_gear,failed_by,inside_tables,speed_below,speed_above,depth_outside,"
      "penetration_outside\n";
  const auto plain = [](std::string text) {
    for (char& letter : text)
      if (letter == ',' || letter == '"') letter = ' ';
    return text;
  };
  const auto value = [](double number) {
    return std::isfinite(number) ? fmt::format("{:.7g}", number) : std::string();
  };
  for (const auto& each : record.results) {
    const auto& model = record.models[each.input.model];
    const auto& run = each.input.overrun;
    const auto& result = each.result;
    const bool good = each.failure.empty();
    out += fmt::format("{},{},{},{},{},{},{},", plain(model.aircraft.name), plain(model.bed.name),
                       value(run.entry_speed), value(run.mass), value(run.braking), value(run.alterations.bed_strength),
                       good ? simulation::text(result.outcome) : "gave_up");
    if (good)
      out += fmt::format("{},{},{},{},{},{},{},", value(result.stop_distance), value(result.runway_distance),
                         value(result.exit_speed), value(result.peak_deceleration), value(result.mean_deceleration),
                         value(study::worst_margin(result, Criterion::limit)),
                         value(study::worst_margin(result, Criterion::ultimate))) +
             failure_and_coverage(result) + "\n";
    else
      out += ",,,,,,,,,,,,,\n";
  }
  return out;
}

}  // namespace apc::report
