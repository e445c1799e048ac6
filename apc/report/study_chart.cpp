#include "apc/report/study_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/report/label_places.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

constexpr double width = 440, height = 260, left = 60, right = 12, top = 12, bottom = 42;

struct Range {
  double low = 1e300, high = -1e300;
  void see(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
};

Range range_along(const Chart& chart) {
  Range range;
  for (const auto& line : chart.lines)
    for (const double value : line.x) range.see(value);
  for (const auto& line : chart.verticals) range.see(line.value);
  if (range.high < range.low) range = {0.0, 1.0};
  if (range.high - range.low <= 0) range.low -= chart.along.si.factor, range.high += chart.along.si.factor;
  return range;
}

Range range_up(const Chart& chart) {
  Range range{0.0, 0.0};
  for (const auto& line : chart.lines)
    for (const double value : line.y) range.see(value);
  for (const auto& level : chart.levels) range.see(level.value);
  if (chart.highest > 0) range.high = std::min(range.high, chart.highest);
  if (range.high - range.low <= 0) range.high = range.low + chart.up.si.factor;
  const double air = 0.06 * (range.high - range.low);
  return {range.low < 0 ? range.low - air : 0.0, range.high + air};
}

std::string grid_up(const Axis& up, const Scale& scale, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(up.low, up.high, scale, 5))
    out += fmt::format(
        "<path class=\"{}\" d=\"M{},{}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
        std::abs(tick.value) < 1e-12 ? "zero" : "grid", left, pixel(up(tick.value)), width - right, left - 6,
        pixel(up(tick.value) + 4), tick.label);
  return out + "</g>";
}

std::string grid_along(const Axis& across, const Scale& scale, const std::string& title, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(across.low, across.high, scale, 6))
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0},{1}V{2}\"/><text class=\"tick\" x=\"{0}\" y=\"{3}\" text-anchor=\"middle\">{4}"
        "</text>",
        pixel(across(tick.value)), top, height - bottom, height - bottom + 16, tick.label);
  return out + fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}, {}</text></g>",
                           pixel(0.5 * (left + width - right)), height - 6, escaped(title), scale.unit);
}

/// Lines across and upright with their names, which keep clear of the curves and of each other.
std::string levels(const Chart& chart, const Axis& across, const Axis& up) {
  LabelPlaces places({left, top, width - right, height - bottom});
  for (const auto& line : chart.lines) {
    auto x = line.x, y = line.y;
    for (double& value : x) value = across(value);
    for (double& value : y) value = value > up.high ? std::nan("") : up(value);
    places.avoid_curve(x, y);
  }
  for (const auto& level : chart.levels) places.avoid_level(up(level.value));
  for (const auto& line : chart.verticals)
    places.avoid_curve({across(line.value), across(line.value)}, {top, height - bottom});
  std::string out;
  for (const auto& level : chart.levels) {
    if (level.value > up.high) continue;
    const auto field = shown(level.value, chart.up, UnitSystem::field),
               si = shown(level.value, chart.up, UnitSystem::si);
    const auto place =
        places.at_level(up(level.value), letters_of(level.name) + 1 + std::max(letters_of(field), letters_of(si)));
    out += fmt::format(
        "<path class=\"level {0}\" d=\"M{1},{2}H{3}\"/><text class=\"name {0}\" x=\"{4}\" y=\"{5}\" "
        "text-anchor=\"{6}\">{7} {8}</text>",
        level.look, left, pixel(up(level.value)), width - right, pixel(place.x), pixel(place.y), place.anchor,
        escaped(level.name), either("tspan", field, si));
  }
  for (const auto& line : chart.verticals) {
    const double at = across(line.value);
    const auto place = places.at_vertical(at, letters_of(line.name));
    out += fmt::format(
        "<path class=\"level {0}\" d=\"M{1},{2}V{3}\"/><text class=\"name {0}\" x=\"{4}\" y=\"{5}\" "
        "text-anchor=\"{6}\">{7}</text>",
        line.look, pixel(at), top, height - bottom, pixel(place.x), pixel(place.y), place.anchor, escaped(line.name));
  }
  return out;
}

std::string legend(const Chart& chart) {
  std::string out;
  for (const auto& line : chart.lines)
    out += fmt::format(
        "<span class=\"key\"><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><path class=\"curve {}\" "
        "d=\"M1,4H21\"/></svg>{}</span> ",
        line.look, line.name);
  for (const auto& marks : chart.marks)
    out +=
        "<span class=\"key\"><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><circle class=\"ring\" cx=\"11\" cy=\"4\" "
        "r=\"3.2\"/></svg>" +
        escaped(marks.name) + "</span> ";
  return "<span class=\"keys\">" + out + "</span>";
}

}  // namespace

std::string line_look(std::size_t i) {
  static const char* const looks[] = {"nose", "main", "third", "fourth", "total"};
  return (i / 5 % 2 ? "rut-" : "") + std::string(looks[i % 5]);
}

std::string figure(const Chart& chart) {
  const auto along = range_along(chart), upwards = range_up(chart);
  const Axis across{along.low, along.high, left, width - right}, up{upwards.low, upwards.high, height - bottom, top};
  std::string out =
      fmt::format("<figure class=\"plot\"><figcaption><b>{}</b>, {} {}<span class=\"reading\">{}</span></figcaption>\n",
                  escaped(chart.title), both_units(chart.up), legend(chart), chart.note);
  out += fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width, height, escaped(chart.title));
  out += grid_up(up, chart.up.field, "field") + grid_up(up, chart.up.si, "si");
  out += grid_along(across, chart.along.field, chart.along_title, "field") +
         grid_along(across, chart.along.si, chart.along_title, "si");
  for (const auto& line : chart.lines) {
    auto y = line.y;
    for (double& value : y)
      if (value > upwards.high) value = std::nan("");
    out += fmt::format("<path class=\"curve {}\" d=\"{}\"/>", line.look, path(line.x, y, across, up));
    if (line.x.size() <= 12)
      for (std::size_t i = 0; i < y.size(); ++i)
        if (std::isfinite(y[i]))
          out += fmt::format("<circle class=\"dot {}\" cx=\"{}\" cy=\"{}\" r=\"2.4\"/>", line.look,
                             pixel(across(line.x[i])), pixel(up(y[i])));
  }
  for (const auto& marks : chart.marks)
    for (std::size_t i = 0; i < marks.x.size(); ++i)
      if (std::isfinite(marks.y[i]) && marks.y[i] <= upwards.high)
        out += fmt::format("<circle class=\"ring\" cx=\"{}\" cy=\"{}\" r=\"5\"/>", pixel(across(marks.x[i])),
                           pixel(up(marks.y[i])));
  return out + levels(chart, across, up) + "</svg></figure>\n";
}

std::string tornado_figure(const std::string& title, double centre, const Measure& measure,
                           const std::vector<TornadoRow>& rows) {
  constexpr double row = 31, names = 128, column = 50;  // two columns of values stand beside the bars
  const double tall = 34 + row * static_cast<double>(rows.size());
  Range range;
  range.see(centre);
  for (const auto& each : rows) range.see(each.low), range.see(each.high);
  const double air = 0.04 * std::max(range.high - range.low, 1e-6 * std::abs(centre) + 1e-9);
  const Axis across{range.low - air, range.high + air, names + column, width - column - 4};
  std::string out = fmt::format(
      "<figure class=\"plot\"><figcaption><b>{}</b>, {}<span class=\"reading\">now {}</span></figcaption>\n",
      escaped(title), both_units(measure), both(centre, measure));
  out += fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width, pixel(tall), escaped(title));
  const auto written = [&](double value, double x, double y, const char* look) {
    return fmt::format("<text class=\"tick name {}\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", look, pixel(x),
                       pixel(y),
                       either("tspan", number(value / measure.field.factor, measure.field.digits),
                              number(value / measure.si.factor, measure.si.digits)));
  };
  double y = 24;
  out += fmt::format(
      "<text class=\"tick name nose\" x=\"{}\" y=\"16\" text-anchor=\"end\">low</text>"
      "<text class=\"tick name main\" x=\"{}\" y=\"16\" text-anchor=\"end\">high</text>",
      pixel(names + column - 6), pixel(width - 2));
  for (const auto& each : rows) {
    out += fmt::format(
        "<text x=\"{0}\" y=\"{1}\" text-anchor=\"end\">{2}</text><text class=\"tick\" x=\"{0}\" y=\"{3}\" "
        "text-anchor=\"end\">{4} … {5}</text>",
        names, pixel(y + 9), escaped(each.name), pixel(y + 22), escaped(each.low_name), escaped(each.high_name));
    const auto bar = [&](double value, const char* look, double top_of) {
      if (!std::isfinite(value)) return;
      const double from = std::min(across(centre), across(value)), wide = std::abs(across(value) - across(centre));
      out += fmt::format("<rect class=\"tornado {}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"9\"/>", look, pixel(from),
                         pixel(top_of), pixel(std::max(wide, 0.8)));
    };
    bar(each.low, "low", y), bar(each.high, "high", y + 10);
    out += written(each.low, names + column - 6, y + 14, "nose") + written(each.high, width - 2, y + 14, "main");
    y += row;
  }
  out += fmt::format("<path class=\"zero\" d=\"M{0},18V{1}\"/>", pixel(across(centre)), pixel(y));
  return out + "</svg></figure>\n";
}

}  // namespace apc::report
