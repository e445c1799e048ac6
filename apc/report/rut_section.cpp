#include "apc/report/rut_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/report/label_places.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

constexpr double left = 58, right = 14, top = 16, bottom = 62;
constexpr double widest = 700, highest = 420;  ///< of the drawing itself, px

std::string axis_ticks(const Axis& across, const Axis& up, const Scale& scale) {
  std::string out;
  const double base = up.pixel_low, edge = across.pixel_low;
  const int room = std::max(4, static_cast<int>((across.pixel_high - across.pixel_low) / 70));
  for (const auto& tick : ticks(across.low, across.high, scale, room))
    out += fmt::format(
        "<path class=\"zero\" d=\"M{0},{1}v5\"/><text class=\"tick\" x=\"{0}\" y=\"{2}\" "
        "text-anchor=\"middle\">{3}</text>",
        pixel(across(tick.value)), pixel(base), pixel(base + 18), tick.label);
  for (const auto& tick : ticks(up.low, up.high, scale, 7))
    out += fmt::format(
        "<path class=\"zero\" d=\"M{0},{1}h-5\"/><text class=\"tick\" x=\"{2}\" y=\"{3}\" "
        "text-anchor=\"end\">{4}</text>",
        pixel(edge), pixel(up(tick.value)), pixel(edge - 8), pixel(up(tick.value) + 4), tick.label);
  return out + fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\">across the rut, {}; up from the surface</text>",
                           pixel(left), pixel(base + 36), scale.unit);
}

/// How dark a particle is that has lost `compaction` of its volume.
double shade(double compaction) { return 0.10 + 0.75 * std::clamp(compaction / 0.9, 0.0, 1.0); }

std::string grains(const RollingRecord& record, const Axis& across, const Axis& up) {
  const double scale = across(1.0) - across(0.0), wide = record.spacing * scale;
  std::string out;
  for (std::size_t i = 0; i < record.section_y.size(); ++i) {
    const double high = std::max(1.0, wide * std::clamp(1.0 - record.section_compaction[i], 0.0, 1.0));
    for (const double side : {-1.0, 1.0})
      out += fmt::format("<rect class=\"grain\" fill-opacity=\"{:.2f}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                         shade(record.section_compaction[i]), pixel(across(side * record.section_y[i]) - 0.5 * wide),
                         pixel(up(record.section_z[i]) - 0.5 * high), pixel(wide), pixel(high));
  }
  return out;
}

std::string shades(double x, double y) {
  std::string out = fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\">crushed by</text>", pixel(x), pixel(y));
  double at = x + 76;
  for (const double compaction : {0.0, 0.5, 0.85}) {
    out += fmt::format(
        "<rect class=\"grain\" fill-opacity=\"{:.2f}\" x=\"{}\" y=\"{}\" width=\"16\" height=\"11\"/><text "
        "class=\"axis\" x=\"{}\" y=\"{}\">{}</text>",
        shade(compaction), pixel(at), pixel(y - 10), pixel(at + 20), pixel(y), percent(compaction));
    at += 62;
  }
  return out;
}

}  // namespace

std::string rut_section(const RollingRecord& record) {
  if (record.section_y.empty()) return "";
  const double half = *std::max_element(record.section_y.begin(), record.section_y.end()) + 0.5 * record.spacing;
  const double peak = *std::max_element(record.section_z.begin(), record.section_z.end()) + record.spacing;
  const double low = -record.bed_depth, high = std::clamp(peak, 0.08 * record.bed_depth, 0.4 * record.bed_depth);
  const double scale = std::min(widest / (2.0 * half), highest / (high - low));
  const double wide = 2.0 * half * scale, tall = (high - low) * scale;
  const double shift = std::max(0.0, 0.5 * (300.0 - wide));  // room for the words under a narrow section
  const Axis across{-half, half, left + shift, left + shift + wide}, up{low, high, top + tall, top};
  const double width = left + right + std::max(wide, 300.0), height = top + tall + bottom;
  const double begin = across.pixel_low, end = across.pixel_high;
  const double words_end = std::max(end, width - right);  // beside a narrow section

  std::string out = fmt::format(
      "<svg class=\"rest\" style=\"max-width:{0}px\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"section behind "
      "the tire\">",
      pixel(width), pixel(height));
  out += "<clipPath id=\"rut\"><path d=\"" +
         fmt::format("M{},{}H{}V{}H{}Z", pixel(begin), top, pixel(end), pixel(top + tall), pixel(begin)) +
         "\"/></clipPath><g clip-path=\"url(#rut)\">" + grains(record, across, up) + "</g>";
  out += fmt::format("<path class=\"pavement\" d=\"M{},{}H{}\"/>", pixel(begin), pixel(up(low)), pixel(end));

  std::vector<double> y, z;
  for (std::size_t i = record.wheel_y.size(); i-- > 0;) y.push_back(-record.wheel_y[i]), z.push_back(record.wheel_z[i]);
  for (std::size_t i = 0; i < record.wheel_y.size(); ++i)
    y.push_back(record.wheel_y[i]), z.push_back(record.wheel_z[i]);
  out += "<path class=\"level main\" d=\"" + path(y, z, across, up) + "\"/>";

  LabelPlaces places({begin, top, words_end, top + tall});
  std::vector<double> at_x, at_y;
  for (std::size_t i = 0; i < y.size(); ++i) at_x.push_back(across(y[i])), at_y.push_back(up(z[i]));
  places.avoid_curve(at_x, at_y);
  for (const auto& [level, name] :
       {std::pair{0.0, "surface"}, std::pair{-record.penetration, "lowest point of the wheel"}}) {
    const double at = up(level);
    out += fmt::format("<path class=\"level nose\" d=\"M{},{}H{}\"/>", pixel(begin), pixel(at), pixel(words_end));
    const auto place = places.at_level(at, letters_of(name));
    out += fmt::format("<text class=\"name nose\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", pixel(place.x),
                       pixel(place.y), place.anchor, name);
  }
  out += either("g", axis_ticks(across, up, measure::depth.field), axis_ticks(across, up, measure::depth.si));
  out += shades(left, height - 8);
  return out + "</svg>";
}

}  // namespace apc::report
