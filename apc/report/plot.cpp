#include "apc/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/report/label_places.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

// The drawing's own pixels; the page scales it. Text is sized so that it is legible on a phone.
constexpr double width = 440, height = 236, left = 58, right = 10, top = 10, bottom = 40;

struct Range {
  double low = 0.0, high = 0.0;
};

/// Zero, all curves and all levels, with a little air above and below.
Range vertical_range(const Plot& plot) {
  Range range;
  for (const auto& curve : plot.curves)
    for (const double value : curve.values)
      if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
  for (const auto& level : plot.levels) range = {std::min(range.low, level.value), std::max(range.high, level.value)};
  if (range.high - range.low <= 0) range.high = range.low + plot.measure.si.factor;
  const double air = 0.06 * (range.high - range.low);
  const bool names_on_top = !plot.levels.empty();  // the name of the highest level needs a line of text above it
  return {range.low < 0 ? range.low - air : 0.0, range.high + (names_on_top ? 2.0 : 1.0) * air};
}

std::string horizontal_grid(const Axis& up, const Scale& scale, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(up.low, up.high, scale, 5)) {
    const auto y = pixel(up(tick.value));
    out += fmt::format(
        "<path class=\"{}\" d=\"M{},{}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">"
        "{}</text>",
        std::abs(tick.value) < 1e-12 ? "zero" : "grid", left, y, width - right, left - 6, pixel(up(tick.value) + 4),
        tick.label);
  }
  return out + "</g>";
}

std::string foot(const Axis& across, const Scale& scale, const std::string& title, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(across.low, across.high, scale, 6)) {
    const auto x = pixel(across(tick.value));
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0},{1}V{2}\"/><text class=\"tick\" x=\"{0}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4}</text>",
        x, top, height - bottom, height - bottom + 16, tick.label);
  }
  return out + fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}, {}</text></g>",
                           pixel(0.5 * (left + width - right)), height - 5, title, scale.unit);
}

std::string curves(const Plot& plot, const std::vector<double>& x, const Axis& across, const Axis& up) {
  std::string out;
  for (const auto& curve : plot.curves)
    out += fmt::format("<path class=\"curve {}\" d=\"{}\"/>", curve.look, path(x, curve.values, across, up));
  return out;
}

/// Level lines with their names, which keep clear of the curves over distance and over time and of each other.
std::string levels(const Plot& plot, const Abscissa& axes, const Axis& along, const Axis& during, const Axis& up) {
  LabelPlaces places({left, top, width - right, height - bottom});
  const auto drawn = [](const std::vector<double>& values, const Axis& axis) {
    auto out = values;
    for (double& value : out) value = axis(value);
    return out;
  };
  for (const auto& curve : plot.curves) {
    const auto y = drawn(curve.values, up);
    places.avoid_curve(drawn(axes.distance, along), y), places.avoid_curve(drawn(axes.time, during), y);
  }
  for (const auto& level : plot.levels) places.avoid_level(up(level.value));
  std::string out;
  for (const auto& level : plot.levels) {
    const auto field = shown(level.value, plot.measure, UnitSystem::field),
               si = shown(level.value, plot.measure, UnitSystem::si);
    const double y = up(level.value);
    const auto place = places.at_level(y, letters_of(level.name) + 1 + std::max(letters_of(field), letters_of(si)));
    out += fmt::format(
        "<path class=\"level {0}\" d=\"M{1},{2}H{3}\"/><text class=\"name {0}\" x=\"{4}\" y=\"{5}\" "
        "text-anchor=\"{6}\">{7} {8}</text>",
        level.look, left, pixel(y), width - right, pixel(place.x), pixel(place.y), place.anchor, escaped(level.name),
        either("tspan", field, si));
  }
  return out;
}

/// "peak nose 21,300 lbf at 131.2 ft": what one would look for, without a script.
std::string extremes(const Plot& plot, const Abscissa& axes) {
  std::string out;
  for (const auto& curve : plot.curves) {
    if (curve.look.starts_with("rut-")) continue;
    const auto peak = std::max_element(curve.values.begin(), curve.values.end(), [](double a, double b) {
      return std::abs(std::isfinite(a) ? a : 0.0) < std::abs(std::isfinite(b) ? b : 0.0);
    });
    if (peak == curve.values.end()) continue;
    const auto row = static_cast<std::size_t>(peak - curve.values.begin());
    out += (out.empty() ? "" : " · ") + escaped(plot.curves.size() > 1 ? curve.name + " " : "") +
           both(*peak, plot.measure) +
           (plot.curves.size() > 1 ? "" : " at " + both(axes.distance[row], measure::distance));
  }
  return (plot.curves.size() > 1 ? "Largest: " : "Largest ") + out;
}

std::string legend(const Plot& plot) {
  std::string out;
  for (const auto& curve : plot.curves)
    if (!curve.look.starts_with("rut-"))
      out += fmt::format(
          "<span class=\"key\"><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><path class=\"curve {}\" "
          "d=\"M1,4H21\"/></svg>{}</span>",
          curve.look, escaped(curve.name));
  return plot.curves.size() < 2 ? "" : "<span class=\"keys\">" + out + "</span>";
}

}  // namespace

std::string figure(const Plot& plot, const Abscissa& axes, std::size_t number) {
  const auto range = vertical_range(plot);
  const Axis up{range.low, range.high, height - bottom, top};
  const Axis along{axes.distance.front(), axes.distance.back(), left, width - right};
  const Axis during{axes.time.front(), axes.time.back(), left, width - right};
  std::string out = fmt::format(
      "<figure class=\"plot\"><figcaption><span class=\"title\"><span><b>{}</b>{}{}</span>{}</span><span "
      "class=\"reading\">{}</span></figcaption>\n",
      escaped(plot.title), *plot.measure.si.unit ? ", " : "", both_units(plot.measure), legend(plot),
      plot.note.empty() ? extremes(plot, axes) : plot.note);
  out += fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" data-plot=\"{}\" "
      "data-frame=\"{},{},{},{}\" data-range=\"{:.6g},{:.6g}\" data-factor=\"{:.9g},{:.9g}\" data-digits=\"{},{}\" "
      "data-unit=\"{}|{}\">",
      width, height, escaped(plot.title), number, left, width - right, top, height - bottom, range.low, range.high,
      plot.measure.field.factor, plot.measure.si.factor, plot.measure.field.digits, plot.measure.si.digits,
      plot.measure.field.unit, plot.measure.si.unit);
  out += horizontal_grid(up, plot.measure.field, "field") + horizontal_grid(up, plot.measure.si, "si");
  out += "<g class=\"by-distance\">" + foot(along, measure::distance.field, axes.place, "field") +
         foot(along, measure::distance.si, axes.place, "si") + curves(plot, axes.distance, along, up) + "</g>";
  out += "<g class=\"by-time\">" + foot(during, measure::time.si, axes.moment, "either") +
         curves(plot, axes.time, during, up) + "</g>";
  return out + levels(plot, axes, along, during, up) + "<g class=\"cursor\"></g></svg></figure>\n";
}

}  // namespace apc::report
