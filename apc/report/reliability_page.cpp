#include "apc/report/reliability_record.h"

#include <fmt/format.h>

#include <cmath>

#include "apc/base/units.h"
#include "apc/report/study_chart.h"
#include "apc/report/study_frame.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

std::string with_interval(const reliability::Estimate& estimate) {
  return fmt::format("{} ({} to {})", percent(estimate.value, 2), percent(estimate.low, 2), percent(estimate.high, 2));
}

/// Share of samples whose critical speed is at least v, over v.
ChartLine survival(const std::vector<double>& sorted, const std::string& name, const std::string& look) {
  ChartLine line{name, look, {}, {}};
  if (sorted.empty()) return line;
  const std::size_t steps = std::min<std::size_t>(sorted.size(), 200);
  line.x.push_back(0.9 * sorted.front()), line.y.push_back(1.0);
  for (std::size_t i = 0; i < steps; ++i) {
    const auto at = i * (sorted.size() - 1) / std::max<std::size_t>(1, steps - 1);
    line.x.push_back(sorted[at]);
    line.y.push_back(1.0 - static_cast<double>(at) / static_cast<double>(sorted.size()));
  }
  return line;
}

const char* const assumptions =
    "Exit speeds follow a Weibull distribution with 50 % of overruns at or below 40 kt and 90 % at or below 70 kt. The "
    "scatter of "
    "the inputs is an estimate unless a file with a source was given; it is listed in the record.";

}  // namespace

std::string reliability_brief(const ReliabilityRecord& record, UnitSystem units) {
  std::string out = fmt::format("Reliability of \"{}\", {} criterion\n\n", record.design, record.criterion);
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& each = record.results[k];
    out += fmt::format("  {}\n    arrest          {} of all overruns; {} at {}; 97.5 % line {}\n", record.cases[k],
                       with_interval(each.arrest), with_interval(each.arrest_at_asked),
                       shown(record.asked_speeds[k], measure::speed, units),
                       shown(each.arrest_speed_975, measure::speed, units));
    out += fmt::format("    without damage  {} of all overruns; {} at {}; 97.5 % line {}\n", with_interval(each.intact),
                       with_interval(each.intact_at_asked), shown(record.asked_speeds[k], measure::speed, units),
                       shown(each.intact_speed_975, measure::speed, units));
    out += "    moved by        ";
    for (std::size_t i = 0; i < each.arrest_indices.size(); ++i)
      if (each.arrest_indices[i].total > 0.02)
        out += fmt::format("{} {}, ", reliability::scattered_names()[i], percent(each.arrest_indices[i].total, 0));
    out += fmt::format("unexplained (blocks, higher orders) {}\n", percent(each.arrest_unexplained, 0));
    out += fmt::format("    {} samples, {} overruns, {} the solver gave up\n", each.samples, each.runs, each.gave_up);
  }
  return out + fmt::format("\n  intervals 95 %; {}\n  {:.1f} s\n", assumptions, record.seconds);
}

namespace {

std::string cell(const reliability::Estimate& estimate) {
  return fmt::format("{}<span class=\"range\">{} to {}</span>", percent(estimate.value, 2), percent(estimate.low, 2),
                     percent(estimate.high, 2));
}

std::string cards(const ReliabilityRecord& record) {
  std::string out = "<div class=\"cards\">";
  for (std::size_t k = 0; k < record.results.size() && k < 4; ++k) {
    const auto& each = record.results[k];
    out += card(each.arrest_at_asked.value >= 0.975 ? "good" : "warn", escaped(record.cases[k]),
                percent(each.arrest.value, 1),
                "of overruns arrested; " + percent(each.intact.value, 1) + " without damage");
  }
  if (record.results.size() == 1) {
    const auto& only = record.results.front();
    out += card("", "97.5 % line", both(only.arrest_speed_975, measure::speed),
                "from this speed 97.5 % of the samples are arrested");
    out += card(only.arrest_at_asked.value >= 0.975 ? "good" : "warn", "At the design speed",
                percent(only.arrest_at_asked.value, 1),
                "arrested from " + both(record.asked_speeds.front(), measure::speed) + "; " +
                    percent(only.intact_at_asked.value, 1) + " without damage");
  }
  return out + "</div>\n";
}

std::string speed_chart(const ReliabilityRecord& record, std::size_t k) {
  const Measure share{{"%", 0.01, 1}, {"%", 0.01, 1}};
  const auto& each = record.results[k];
  Chart chart{record.cases[k],
              measure::speed,
              share,
              "exit speed",
              {},
              {},
              {{"line at", "limit", 0.975}},
              {{"designed for", "total", record.asked_speeds[k]}},
              "share of samples that handle at least this speed",
              0.0};
  chart.lines = {survival(each.arrest_speeds, "arrested", "nose"),
                 survival(each.intact_speeds, "without damage", "main")};
  return figure(chart);
}

std::string probabilities(const ReliabilityRecord& record) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& each = record.results[k];
    rows.push_back({escaped(record.cases[k]), cell(each.arrest), cell(each.intact), cell(each.arrest_at_asked),
                    cell(each.intact_at_asked), both(each.arrest_speed_975, measure::speed),
                    both(each.intact_speed_975, measure::speed), std::to_string(each.samples),
                    std::to_string(each.gave_up)});
  }
  return "<h2>Probabilities</h2>\n<p>Below each probability its 95 % interval.</p>\n" +
         table({"case", "arrest", "no damage", "arrest at the design speed", "no damage there", "arrest, 97.5 % line",
                "no damage, 97.5 % line", "samples", "solver gave up"},
               rows, Cells::numbers);
}

std::string sobol(const ReliabilityRecord& record) {
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const std::string& name, const std::vector<reliability::SobolIndex>& indices,
                       double unexplained) {
    std::vector<std::string> line{name};
    for (const auto& index : indices) line.push_back(percent(index.first, 0) + " / " + percent(index.total, 0));
    line.push_back(percent(unexplained, 0));
    rows.push_back(line);
  };
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& each = record.results[k];
    row(escaped(record.cases[k]) + ": arrested", each.arrest_indices, each.arrest_unexplained);
    row(escaped(record.cases[k]) + ": without damage", each.intact_indices, each.intact_unexplained);
  }
  std::vector<std::string> headings{"speed"};
  for (const char* name : reliability::scattered_names()) headings.emplace_back(name);
  headings.emplace_back("unexplained");
  return "<h2>What moves the handled speeds</h2>\n<p>Sobol indices, first order / total. Unexplained: scatter of "
         "single "
         "blocks and higher orders.</p>\n" +
         table(headings, rows, Cells::numbers);
}

}  // namespace

std::string reliability_page(const ReliabilityRecord& record) {
  const auto header = "<h1>Reliability of " + escaped(record.design) + "</h1><p class=\"sub\">" + record.criterion +
                      " criterion</p>\n" + cards(record);
  std::string body = "<h2>Handled exit speeds</h2>\n<div class=\"plots\">\n";
  for (std::size_t k = 0; k < record.results.size(); ++k) body += speed_chart(record, k);
  body += "</div>\n" + probabilities(record) + sobol(record) + "<h2>Assumptions</h2>\n<p>" + std::string(assumptions) +
          " Scatter: " + escaped(record.scatter.source) + ".</p>\n" + "<h2>How to make this study again</h2>\n" +
          manifest_section(record.manifest);
  return framed("Reliability of " + record.design, header, body, "apc, the Arrestor Prediction Code.");
}

}  // namespace apc::report
