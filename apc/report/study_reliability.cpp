#include "apc/report/study_reliability.h"

#include <fmt/format.h>

#include <cmath>

#include "apc/base/units.h"
#include "apc/report/study_chart.h"
#include "apc/report/study_frame.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

std::string with_interval(const study::Estimate& estimate) {
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
        out += fmt::format("{} {}, ", study::scattered_names()[i], percent(each.arrest_indices[i].total, 0));
    out += fmt::format("unexplained (blocks, higher orders) {}\n", percent(each.arrest_unexplained, 0));
    out += fmt::format("    {} samples, {} overruns, {} the solver gave up\n", each.samples, each.runs, each.gave_up);
  }
  return out + fmt::format("\n  intervals 95 %; {}\n  {:.1f} s\n", assumptions, record.seconds);
}

std::string reliability_page(const ReliabilityRecord& record) {
  const Measure share{{"%", 0.01, 1}, {"%", 0.01, 1}};
  std::string header = "<h1>Reliability of " + escaped(record.design) + "</h1><p class=\"sub\">" + record.criterion +
                       " criterion; intervals 95 %</p>\n<div class=\"cards\">";
  std::string body = "<h2>Handled exit speeds</h2>\n<div class=\"plots\">\n";
  std::vector<std::vector<std::string>> rows, sobol;
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& each = record.results[k];
    if (k < 4)
      header += card(each.arrest_at_asked.value >= 0.975 ? "good" : "warn", escaped(record.cases[k]),
                     percent(each.arrest.value, 1),
                     "of overruns arrested; " + percent(each.intact.value, 1) + " without damage");
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
    body += figure(chart);
    rows.push_back({escaped(record.cases[k]), with_interval(each.arrest), with_interval(each.intact),
                    with_interval(each.arrest_at_asked), with_interval(each.intact_at_asked),
                    both(each.arrest_speed_975, measure::speed), both(each.intact_speed_975, measure::speed)});
    std::vector<std::string> line{escaped(record.cases[k])};
    for (const auto& index : each.arrest_indices)
      line.push_back(percent(index.first, 0) + " / " + percent(index.total, 0));
    line.push_back(percent(each.arrest_unexplained, 0));
    sobol.push_back(line);
  }
  body +=
      "</div>\n<h2>Probabilities</h2>\n" + table({"case", "arrest", "no damage", "arrest at the design speed",
                                                  "no damage there", "arrest, 97.5 % line", "no damage, 97.5 % line"},
                                                 rows, Cells::numbers);
  std::vector<std::string> headings{"case"};
  for (const char* name : study::scattered_names()) headings.emplace_back(name);
  headings.emplace_back("unexplained");
  body +=
      "<h2>What moves the arrested speed</h2>\n<p>Sobol indices, first order / total. Unexplained: scatter of single "
      "blocks and "
      "higher orders.</p>\n" +
      table(headings, sobol, Cells::numbers);
  body += "<h2>Assumptions</h2>\n<p>" + std::string(assumptions) + " Scatter: " + escaped(record.scatter.source) +
          ".</p>\n" + "<h2>How to make this study again</h2>\n" + manifest_section(record.manifest);
  return framed("Reliability of " + record.design, header + "</div>\n", body, "apc, the Arrestor Prediction Code.");
}

}  // namespace apc::report
