#include <fmt/format.h>

#include <cmath>
#include <map>

#include "apc/base/curve.h"
#include "apc/report/study_chart.h"
#include "apc/report/study_frame.h"
#include "apc/report/study_record.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

using study::CaseResult;
using study::Criterion;

const Measure share{{"%", 0.01, 0}, {"%", 0.01, 0}};

std::string margin_cell(double margin) {
  if (!std::isfinite(margin)) return "-";
  const char* mood = margin < 0 ? "over" : margin < 0.1 ? "near" : "";
  return fmt::format("@{}|{}{}", mood, margin > 0 ? "+" : "", percent(margin, 1));
}

/// All cases of one model that differ only in speed, as one line.
struct Run {
  std::string name;
  std::vector<const CaseResult*> cases;
};

std::vector<Run> runs_of(const StudyRecord& record, std::size_t model) {
  std::map<std::vector<double>, std::size_t> known;
  std::vector<Run> out;
  const bool brakings = record.axes.brakings.size() > 1, strengths = record.axes.strengths.size() > 1;
  for (const auto& each : record.results) {
    if (each.input.model != model) continue;
    const auto& run = each.input.overrun;
    const auto [entry, fresh] = known.try_emplace({run.mass, run.braking, run.alterations.bed_strength}, out.size());
    if (fresh) {
      auto name = both(run.mass, measure::mass);
      if (brakings) name += ", braking " + number(run.braking, 2);
      if (strengths) name += ", strength " + percent(run.alterations.bed_strength, 0);
      out.push_back({name, {}});
    }
    out[entry->second].cases.push_back(&each);
  }
  return out;
}

/// A chart of one figure of each case over exit speed. `value` may give NaN.
template <class Value>
Chart over_speed(const std::vector<Run>& runs, const char* title, const Measure& measure, const Value& value) {
  Chart chart{title, measure::speed, measure, "exit speed", {}, {}, {}, {}, "", 0.0};
  ChartMarks over{"a gear load passes its limit", {}, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ChartLine line{runs[i].name, line_look(i), {}, {}};
    for (const auto* each : runs[i].cases) {
      line.x.push_back(each->input.overrun.entry_speed);
      line.y.push_back(each->failure.empty() ? value(each->result) : std::nan(""));
      if (each->failure.empty() && study::worst_margin(each->result, Criterion::limit) < 0)
        over.x.push_back(line.x.back()), over.y.push_back(line.y.back());
    }
    chart.lines.push_back(line);
  }
  if (!over.x.empty()) chart.marks.push_back(over);
  return chart;
}

using GearNumber = double simulation::GearSummary::*;

/// One load of one gear over exit speed, with its limits.
std::string load_chart(const std::vector<Run>& runs, std::size_t gear, const std::string& title, GearNumber peak,
                       GearNumber limit, GearNumber ultimate) {
  auto chart = over_speed(runs, "", measure::force, [&](const simulation::Result& result) {
    return gear < result.gears.size() ? result.gears[gear].*peak : std::nan("");
  });
  chart.title = title;
  chart.marks.clear();
  for (const auto& run : runs)
    for (const auto* each : run.cases) {
      if (!each->failure.empty() || gear >= each->result.gears.size() || !chart.levels.empty()) continue;
      const auto& summary = each->result.gears[gear];
      if (summary.*limit > 0) chart.levels.push_back({"limit", "limit", summary.*limit});
      if (ultimate && summary.*ultimate > 0) chart.levels.push_back({"ultimate", "ultimate", summary.*ultimate});
    }
  return figure(chart);
}

std::string model_section(const StudyRecord& record, std::size_t m) {
  const auto& model = record.models[m];
  const auto runs = runs_of(record, m);
  std::string out =
      fmt::format("<h2>{} in {}</h2>\n<div class=\"plots\">\n", escaped(model.aircraft.name), escaped(model.bed.name));
  auto distance = over_speed(runs, "Stop distance", measure::distance,
                             [](const simulation::Result& result) { return result.stop_distance; });
  distance.levels.push_back({"bed's end", "limit", model.bed.length()});
  out += figure(distance);
  auto exits = over_speed(runs, "Speed at the bed's end", measure::speed, [](const simulation::Result& result) {
    return std::isfinite(result.stop_distance) ? 0.0 : result.exit_speed;
  });
  bool leaves = false;
  for (const auto& line : exits.lines)
    for (const double speed : line.y) leaves = leaves || speed > 0;
  if (leaves) out += figure(exits);
  for (std::size_t g = 0; g < model.aircraft.gears.size(); ++g) {
    out += load_chart(runs, g, "Peak drag per " + model.aircraft.gears[g].name + " strut",
                      &simulation::GearSummary::peak_drag, &simulation::GearSummary::drag_limit,
                      &simulation::GearSummary::drag_ultimate);
    out += load_chart(runs, g, "Peak vertical load per " + model.aircraft.gears[g].name + " strut",
                      &simulation::GearSummary::peak_vertical, &simulation::GearSummary::vertical_limit, nullptr);
  }
  auto deceleration = over_speed(runs, "Peak deceleration", measure::acceleration,
                                 [](const simulation::Result& result) { return result.peak_deceleration; });
  deceleration.marks.clear();
  return out + figure(deceleration) + "</div>\n";
}

std::string matrix(const StudyRecord& record) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& each : record.results) {
    const auto& model = record.models[each.input.model];
    const auto& run = each.input.overrun;
    const auto& result = each.result;
    std::vector<std::string> row{
        escaped(model.aircraft.name),  escaped(model.bed.name), both(run.entry_speed, measure::speed),
        both(run.mass, measure::mass), number(run.braking, 2),  percent(run.alterations.bed_strength, 0)};
    if (!each.failure.empty()) {
      row.insert(row.end(), {"@open|solver gave up", "-", "-", "-", "-"});
    } else {
      const bool stopped = std::isfinite(result.stop_distance);
      row.push_back(stopped ? both(result.stop_distance, measure::distance)
                            : "@over|left at " + both(result.exit_speed, measure::speed));
      row.push_back(both(result.peak_deceleration, measure::acceleration));
      row.push_back(both(result.mean_deceleration, measure::acceleration));
      row.push_back(margin_cell(study::worst_margin(result, Criterion::limit)));
      row.push_back(margin_cell(study::worst_margin(result, Criterion::ultimate)));
    }
    rows.push_back(row);
  }
  return table({"aircraft", "bed", "exit speed", "mass", "braking", "strength", "stop", "peak", "mean", "worst margin",
                "to ultimate"},
               rows, Cells::numbers);
}

std::string envelope_section(const study::Envelope& envelope, double bed_length) {
  Chart chart{envelope.aircraft + ": length over depth by exit speed",
              measure::depth,
              measure::distance,
              "depth of the bed",
              {},
              {},
              {},
              {},
              "uniform depth behind a ramp of 50 ft; right of the red line a gear load passes its limit",
              0.0};
  for (std::size_t s = 0; s < envelope.speeds.size(); ++s)
    chart.lines.push_back(
        {both(envelope.speeds[s], measure::speed), line_look(s), envelope.depths, envelope.stop_distance[s]});
  ChartMarks over{"a gear load passes its limit", {}, {}};
  for (std::size_t s = 0; s < envelope.speeds.size(); ++s)
    for (std::size_t d = 0; d < envelope.depths.size(); ++d)
      if (envelope.margin[s][d] < 0)
        over.x.push_back(envelope.depths[d]), over.y.push_back(envelope.stop_distance[s][d]);
  if (!over.x.empty()) chart.marks.push_back(over);
  ChartLine limit{"a load at its limit", "limit", {}, {}};
  for (std::size_t s = 0; s < envelope.speeds.size(); ++s) {
    const double at = envelope.limit_depth[s];
    if (!std::isfinite(at)) continue;
    limit.x.push_back(at);
    limit.y.push_back(LinearCurve(envelope.depths, envelope.stop_distance[s])(at));
  }
  if (limit.x.size() > 1) chart.lines.push_back(limit);
  chart.highest = std::max(2.0 * bed_length, 300.0);
  return figure(chart);
}

}  // namespace

std::string study_page(const StudyRecord& record) {
  std::string names;
  for (const auto& model : record.models)
    if (names.find(model.aircraft.name) == std::string::npos)
      names += (names.empty() ? "" : ", ") + model.aircraft.name;
  std::size_t stopped = 0, over = 0, failed = 0;
  for (const auto& each : record.results) {
    if (!each.failure.empty()) {
      ++failed;
      continue;
    }
    stopped += std::isfinite(each.result.stop_distance);
    over += study::worst_margin(each.result, Criterion::limit) < 0;
  }
  const auto total = record.results.size();
  std::string header = "<h1>What if: " + escaped(names) + "</h1>\n<div class=\"cards\">";
  header += card("", "Overruns", std::to_string(total),
                 failed ? std::to_string(failed) + " the solver gave up" : "all solved");
  header += card(stopped == total ? "good" : "warn", "Stopped in the bed", std::to_string(stopped),
                 "of " + std::to_string(total));
  header +=
      card(over ? "warn" : "good", "Limit passed", std::to_string(over), "overruns with a gear load above its limit");
  header += "</div>\n";
  std::string body;
  for (std::size_t m = 0; m < record.models.size(); ++m) body += model_section(record, m);
  if (!record.envelopes.empty()) {
    body += "<h2>Design envelope</h2>\n<div class=\"plots\">\n";
    for (const auto& envelope : record.envelopes)
      body += envelope_section(envelope, record.models.front().bed.length());
    body += "</div>\n";
  }
  if (!record.tornados.empty()) {
    body +=
        "<h2>What matters</h2>\n<p>Each input moved down and up by itself; the bed is continued at its last depth, so "
        "that every case stops.</p>\n<div class=\"plots\">\n";
    for (const auto& tornado : record.tornados) {
      std::vector<TornadoRow> distance, margin;
      for (const auto& bar : tornado.bars) {
        distance.push_back({bar.input, bar.low, bar.high, bar.distance_low, bar.distance_high});
        margin.push_back({bar.input, bar.low, bar.high, bar.margin_low, bar.margin_high});
      }
      const auto where = tornado.aircraft + " in " + tornado.bed + ": ";
      body += tornado_figure(where + "stop distance", tornado.distance, measure::distance, distance);
      if (std::isfinite(tornado.margin)) body += tornado_figure(where + "worst margin", tornado.margin, share, margin);
    }
    body += "</div>\n";
  }
  body += "<h2>All overruns</h2>\n" + matrix(record) + "<h2>How to make this study again</h2>\n" +
          manifest_section(record.manifest);
  return framed(
      "What if: " + names, header, body,
      "apc, the Arrestor Prediction Code. Margin = limit / peak − 1, the smallest over gears and loads; distances from "
      "the bed's leading edge to the nose wheel.");
}

}  // namespace apc::report
