#include "apc/learning/along_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/base/markup.h"
#include "apc/base/units.h"

namespace apc::learning {
namespace {

constexpr double bin = 4.0;  ///< m, of the map

struct Point {
  double place = 0.0, value = 0.0;
};

std::vector<Point> accelerations(const AlongRun& a, const Eigen::VectorXd& values) {
  std::vector<Point> list;
  for (std::size_t i = 0; i < a.readings.size(); ++i)
    if (a.readings[i].is(Quantity::acceleration_x))
      list.push_back({a.motion.at(a.motion.place, 0.5 * (a.readings[i].from + a.readings[i].to)),
                      values[static_cast<Eigen::Index>(i)]});
  return list;
}

/// What the tables at the loads carried predict with the effects the diagnosis would add.
Eigen::VectorXd with_effects(const Study& study, std::size_t r) {
  const AlongRun& a = study.along->runs[r];
  const Run& run = study.background.runs[r];
  effects::Alterations alterations;
  alterations.conditions = run.conditions;
  alterations.effects = study.diagnosis.augmented;
  return read_off(a.readings, study.along->gears, run, a.motion,
                  balance_at_loads(*study.background.data, study.along->gears, run, a.motion, alterations),
                  run.overrun.entry_speed);
}

std::string line(const std::vector<Point>& points, const char* style, double reach, double lowest) {
  std::string svg = fmt::format("<polyline {} points='", style);
  for (const Point& p : points)
    if (p.place >= 0.0)
      svg += fmt::format("{:.1f},{:.1f} ", 50.0 + 640.0 * p.place / reach, 12.0 + 140.0 * p.value / lowest);
  return svg + "'/>";
}

std::string chart(const Study& study, std::size_t r, double reach) {
  const AlongRun& a = study.along->runs[r];
  const auto dots = accelerations(a, a.measured);
  double lowest = -1.0;
  for (const Point& p : dots) lowest = std::min(lowest, p.value);
  std::string svg = fmt::format("<svg viewBox='0 0 720 186' role='img' aria-label='Deceleration of {} along the bed'>",
                                escaped(study.background.runs[r].id));
  for (double g = 0.0; g > lowest / units::g0; g -= 0.2) {
    const double y = 12.0 + 140.0 * g * units::g0 / lowest;
    svg += fmt::format(
        "<line x1='50' x2='690' y1='{0:.1f}' y2='{0:.1f}' stroke='var(--line)'/><text x='46' y='{1:.1f}' "
        "text-anchor='end'>{2:.1f} g</text>",
        y, y + 4.0, std::abs(g));
  }
  svg += "<g class='dots'>";
  for (const Point& p : dots)
    if (p.place >= 0.0)
      svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='2'/>", 50.0 + 640.0 * p.place / reach,
                         12.0 + 140.0 * p.value / lowest);
  svg += "</g>" + line(accelerations(a, a.plain), "class='model'", reach, lowest);
  if (!study.diagnosis.augmented.empty())
    svg += line(accelerations(a, with_effects(study, r)), "class='model' stroke-dasharray='5 3'", reach, lowest);
  return svg + fmt::format(
                   "<text x='50' y='178'>0 m</text><text x='690' y='178' text-anchor='end'>nose wheel {:.0f} m "
                   "from the leading edge</text></svg>",
                   reach);
}

/// Colour of missing force over weight: red too much resistance in the model, blue too little; full at 0.1.
std::string colour(double share) {
  const double v = std::clamp(share / 0.1, -1.0, 1.0);
  return fmt::format("rgb({:.0f},{:.0f},{:.0f})", v < 0 ? 230 : 230 * (1 - v), 230 * (1 - std::abs(v)),
                     v > 0 ? 230 : 230 * (1 + v));
}

std::string map(const Study& study, double reach) {
  const auto& runs = study.along->runs;
  const double height = 24.0 * static_cast<double>(runs.size());
  std::string svg = fmt::format("<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='Missing force, run by distance'>",
                                height + 26.0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const AlongRun& a = runs[r];
    const double y = 24.0 * static_cast<double>(r) + 4.0;
    svg += fmt::format("<text x='60' y='{:.0f}' text-anchor='end'>{}</text>", y + 14.0,
                       escaped(study.background.runs[r].id));
    const auto missing =
        accelerations(a, a.plain - a.measured);  // model minus measured: a drag that is missing is positive
    double offset = 0.0;
    int before = 0;
    for (const Point& p : missing)
      if (p.place < 0.0) offset += p.value, ++before;
    offset = before > 3 ? offset / before : 0.0;
    for (double from = 0.0; from < reach; from += bin) {
      double sum = 0.0;
      int count = 0;
      for (const Point& p : missing)
        if (p.place >= from && p.place < from + bin) sum += p.value - offset, ++count;
      if (count == 0) continue;
      svg += fmt::format(
          "<rect x='{:.1f}' y='{:.0f}' width='{:.1f}' height='20' fill='{}'><title>{:.0f} m: {:+.3f}"
          "</title></rect>",
          66.0 + 640.0 * from / reach, y, 640.0 * std::min(bin, reach - from) / reach + 0.4,
          colour(sum / count / units::g0), from, sum / count / units::g0);
      // A sign, for print and eyes that see no colour.
      if (std::abs(sum / count / units::g0) > 0.03)
        svg += fmt::format("<text x='{:.1f}' y='{:.0f}' text-anchor='middle' style='fill:#111'>{}</text>",
                           66.0 + 640.0 * (from + 0.5 * std::min(bin, reach - from)) / reach, y + 14.0,
                           sum > 0.0 ? "+" : "−");
    }
  }
  return svg + fmt::format(
                   "<text x='66' y='{0:.0f}'>0 m</text><text x='706' y='{0:.0f}' text-anchor='end'>nose wheel "
                   "{1:.0f} m from the leading edge</text></svg>",
                   height + 20.0, reach);
}

}  // namespace

std::string along_charts(const Study& study) {
  if (!study.along) return "";
  double reach = 10.0;
  for (const AlongRun& a : study.along->runs) reach = std::max(reach, a.motion.place.back());
  std::string html =
      "<h2>Force at every place</h2><p>At the loads the wheels carried the load tables say what drag they took. Blue "
      "and +: "
      "resistance the tables lack, red and −: too much, full colour at 10 % of the weight, signs from 3 %; the "
      "accelerometer's reading before the bed is taken off.</p>" +
      map(study, reach) +
      "<p>Dots: measured acceleration. Line: the tables at the loads carried, nothing fitted. Dashed: with the effects "
      "the diagnosis would add.</p>";
  for (std::size_t r = 0; r < study.along->runs.size(); ++r)
    html += "<h3>" + escaped(study.background.runs[r].id) + "</h3>" + chart(study, r, reach);
  return html;
}

}  // namespace apc::learning
