#include "apc/report/bed_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apc/report/svg.h"

namespace apc::report {
namespace {

constexpr double width = 1160, left = 62, right = 18;

/// Where a gear stands, in bed distance (leading axle, then the ones behind it), and how deep.
struct Stand {
  std::vector<double> axles;
  double penetration = 0.0, rut = 0.0, radius = 0.5;
};

double wheel_radius(const OverrunRecord& record, std::size_t gear) {
  const auto& tires = record.model.aircraft.tires;
  const auto tire = tires.find(record.model.aircraft.gears[gear].tire);
  return tire == tires.end() ? 0.5 : tire->second.radius();
}

Stand last_stand(const OverrunRecord& record, std::size_t gear) {
  const auto& data = record.model.aircraft.gears[gear];
  const auto& history = record.result.history.gears[gear];
  Stand stand;
  stand.radius = wheel_radius(record, gear);
  if (history.distance.empty()) return stand;
  for (int axle = 0; axle < data.axles; ++axle)
    stand.axles.push_back(history.distance.back() - axle * data.axle_spacing);
  stand.penetration = history.penetration.empty() ? 0.0 : history.penetration.back();
  stand.rut = history.rut.empty() ? 0.0 : history.rut.back();
  return stand;
}

/// Places along the runway where the bed's outline bends, and a little either side of its ends.
std::vector<double> outline(const bed::Bed& bed, double from, double to) {
  std::vector<double> x{from};
  for (const double at : bed.distance)
    if (at > from && at < to) {
      if (at == bed.distance.front()) x.push_back(at - 1e-6);
      x.push_back(at);
      if (at == bed.distance.back()) x.push_back(at + 1e-6);
    }
  x.push_back(to);
  return x;
}

double base_at(const bed::Bed& bed, double x) { return bed.top_at(x) - bed.depth_at(x); }

/// The material as a closed outline and the pavement line, drawn between `from` and `to`.
std::string ground(const bed::Bed& bed, double from, double to, const Axis& across, const Axis& up) {
  const auto x = outline(bed, from, to);
  std::vector<double> top, base;
  for (const double at : x) top.push_back(bed.top_at(at)), base.push_back(base_at(bed, at));
  auto ring = path(x, top, across, up);
  for (std::size_t i = x.size(); i-- > 0;) ring += "L" + pixel(across(x[i])) + "," + pixel(up(base[i]));
  return fmt::format(
      "<path class=\"foam\" d=\"{}Z\"/><path class=\"pavement\" d=\"{}\"/><path class=\"surface\" "
      "d=\"{}\"/>",
      ring, path(x, base, across, up), path(x, top, across, up));
}

std::string wheel(double x, double z, double radius, const Axis& across, const Axis& up, const std::string& look) {
  return fmt::format("<ellipse class=\"wheel {}\" cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"/>", look, pixel(across(x)),
                     pixel(up(z)), pixel(across(x + radius) - across(x)), pixel(up(z) - up(z + radius)));
}

/// Wheels, struts and a beam at the height of the centre of gravity: what the model knows of an aircraft.
std::string aircraft_at_rest(const OverrunRecord& record, const Axis& across, const Axis& up) {
  const auto& plane = record.model.aircraft;
  const auto& history = record.result.history;
  std::string out;
  const double nose = history.distance.back(), height = plane.cg_height;
  const double centre = nose - record.result.cg_behind_nose_gear;
  const double beam = height + (history.heave.empty() ? 0.0 : history.heave.back());
  const double tilt = history.pitch.empty() ? 0.0 : history.pitch.back();
  const auto beam_at = [&](double x) { return beam + (x - centre) * std::tan(tilt); };
  double rear = nose;
  for (std::size_t i = 0; i < plane.gears.size(); ++i) {
    const auto stand = last_stand(record, i);
    if (stand.axles.empty()) continue;
    const double middle = 0.5 * (stand.axles.front() + stand.axles.back());
    rear = std::min(rear, middle);
    const double axle = record.model.bed.top_at(stand.axles.front()) - stand.penetration + stand.radius;
    out += fmt::format("<path class=\"strut\" d=\"M{0},{1}L{0},{2}\"/>", pixel(across(middle)), pixel(up(axle)),
                       pixel(up(beam_at(middle))));
    for (const double x : stand.axles) out += wheel(x, axle, stand.radius, across, up, gear_look(i));
  }
  out += fmt::format("<path class=\"beam\" d=\"M{},{}L{},{}\"/>", pixel(across(rear)), pixel(up(beam_at(rear))),
                     pixel(across(nose)), pixel(up(beam_at(nose))));
  const double cx = across(centre), cy = up(beam);
  return out + fmt::format(
                   "<circle class=\"cg\" cx=\"{0}\" cy=\"{1}\" r=\"5\"/><path class=\"cg-mark\" "
                   "d=\"M{0},{1}h5a5,5 0 0 0 -5,-5ZM{0},{1}h-5a5,5 0 0 0 5,5Z\"/>",
                   pixel(cx), pixel(cy));
}

std::string distance_axis(const Axis& across, double y, double grid_top, const Scale& scale, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(across.low, across.high, scale, 12))
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0},{1}V{2}\"/><text class=\"tick\" x=\"{0}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4}</text>",
        pixel(across(tick.value)), pixel(grid_top), pixel(y), pixel(y + 17), tick.label);
  return out + fmt::format(
                   "<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">distance from the bed's "
                   "leading edge, {}</text></g>",
                   pixel(0.5 * (left + width - right)), pixel(y + 36), scale.unit);
}

std::string depth_axis(const Axis& up, const Scale& scale, const char* system) {
  std::string out = fmt::format("<g class=\"{}\">", system);
  for (const auto& tick : ticks(up.low, up.high, scale, 4))
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0},{1}H{2}\"/><text class=\"tick\" x=\"{3}\" y=\"{4}\" "
        "text-anchor=\"end\">{5}</text>",
        left, pixel(up(tick.value)), width - right, left - 6, pixel(up(tick.value) + 4), tick.label);
  return out + fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text></g>", left - 6,
                           pixel(up.pixel_high - 8), scale.unit);
}

/// The floor of a gear's rut along the bed, thinned.
std::string rut(const OverrunRecord& record, std::size_t gear, const Axis& across, const Axis& up) {
  const auto& history = record.result.history.gears[gear];
  std::vector<double> x, z;
  double next = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < history.distance.size() && i < history.rut.size(); ++i) {
    if (history.distance[i] < next && i + 1 < history.distance.size()) continue;
    next = history.distance[i] + 0.15;
    if (history.distance[i] < -0.5) continue;
    x.push_back(history.distance[i]);
    z.push_back(record.model.bed.top_at(history.distance[i]) - history.rut[i]);
  }
  return fmt::format("<path class=\"curve {}\" d=\"{}\"/>", gear_look(gear), path(x, z, across, up));
}

/// A round factor that makes the bed's heights fill about `room` pixels.
double exaggeration(double pixels_per_metre, double heights, double room) {
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0})
    if (heights * pixels_per_metre * factor >= room) return factor;
  return 50.0;
}

/// Where the leading axle of each gear came to rest: the nose gear named to the right of its line, the others to the
/// left. A name runs over the gears behind it, so it stands a line of text higher than theirs.
std::string stop_marks(const OverrunRecord& record, const Axis& across, double from, double to) {
  std::string out;
  const auto gears = record.result.gears.size();
  for (std::size_t i = 0; i < record.result.gears.size(); ++i) {
    const auto stand = last_stand(record, i);
    if (stand.axles.empty()) continue;
    const double x = across(stand.axles.front());
    const bool ahead = (i == 0 && x < width - 170) || x < left + 170;
    const double y = to - (ahead && i == 0 ? 0.0 : 14.0 * static_cast<double>(gears - 1 - i));
    out += fmt::format(
        "<path class=\"stop {0}\" d=\"M{1},{2}V{3}\"/><text class=\"name {0}\" x=\"{4}\" y=\"{5}\" "
        "text-anchor=\"{6}\">{7} wheel {8}</text>",
        gear_look(i), pixel(x), pixel(from), pixel(y - 9), pixel(x + (ahead ? 5 : -5)), pixel(y),
        ahead ? "start" : "end", escaped(record.result.gears[i].name),
        either("tspan", shown(stand.axles.front(), measure::distance, UnitSystem::field),
               shown(stand.axles.front(), measure::distance, UnitSystem::si)));
  }
  return out;
}

}  // namespace

std::string gear_look(std::size_t gear) {
  const char* const looks[] = {"nose", "main", "third", "fourth"};
  return looks[std::min<std::size_t>(gear, 3)];
}

std::string bed_section(const OverrunRecord& record) {
  const auto& bed = record.model.bed;
  const auto& history = record.result.history;
  if (history.distance.empty()) return "";
  double rear = 0.0, highest = record.model.aircraft.cg_height;
  for (const auto& gear : record.model.aircraft.gears) rear = std::max(rear, gear.behind_nose_gear);
  const double from = -std::min(bed.setback, 20.0) - 1.0;
  const double to = std::max(bed.length(), history.distance.back()) + 4.0;
  const Axis across{from, to, left, width - right};
  const double scale = (width - right - left) / (to - from);  // pixels per metre

  const double lowest = -bed.maximum_depth() - 0.2;
  highest += bed.flush == bed::Flush::base ? bed.maximum_depth() : 0.0;
  const double scene = (highest + 1.2 - lowest) * scale;
  const Axis true_up{lowest, highest + 1.2, 22 + scene, 22};

  const double factor = exaggeration(scale, bed.maximum_depth(), 70);
  const double section_top = 22 + scene + 52;
  const double z_low = bed.flush == bed::Flush::top ? -1.12 * bed.maximum_depth() : -0.12 * bed.maximum_depth();
  const double z_high = bed.flush == bed::Flush::top ? 0.12 * bed.maximum_depth() : 1.12 * bed.maximum_depth();
  const double section_bottom = section_top + (z_high - z_low) * scale * factor;
  const Axis tall{z_low, z_high, section_bottom, section_top};

  std::string out = fmt::format(
      "<svg class=\"section\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"bed section with ruts and the aircraft "
      "at rest\">",
      width, pixel(section_bottom + 44));
  out += fmt::format(
      "<text class=\"axis\" x=\"{}\" y=\"12\">True scale: wheels, struts and a beam through the centre "
      "of gravity</text>",
      left);
  out += ground(bed, from, to, across, true_up) + aircraft_at_rest(record, across, true_up);
  out += distance_axis(across, section_bottom, section_top, measure::distance.field, "field") +
         distance_axis(across, section_bottom, section_top, measure::distance.si, "si") +
         depth_axis(tall, measure::depth.field, "field") + depth_axis(tall, measure::depth.si, "si");
  out += fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\">Section with the ruts, heights × {:.0f}</text>", left,
                     pixel(section_top - 22), factor);
  out += ground(bed, from, to, across, tall);
  for (std::size_t i = history.gears.size(); i-- > 0;) out += rut(record, i, across, tall);
  return out + stop_marks(record, across, section_bottom, section_top - 6) + "</svg>";
}

std::string wheels_at_rest(const OverrunRecord& record) {
  if (!std::isfinite(record.result.stop_distance)) return "";
  constexpr double view = 440;
  const auto& bed = record.model.bed;
  std::string out;
  for (std::size_t i = 0; i < record.result.history.gears.size(); ++i) {
    const auto stand = last_stand(record, i);
    if (stand.axles.empty()) continue;
    const double middle = 0.5 * (stand.axles.front() + stand.axles.back());
    const double span = std::max(3.4, stand.axles.front() - stand.axles.back() + 2.6);
    const Axis across{middle - 0.5 * span, middle + 0.5 * span, 0, view};
    const double top = bed.top_at(middle), centre = top - stand.penetration + stand.radius;
    const double low = std::min(base_at(bed, middle), centre - stand.radius) - 0.12;
    const double high = std::max(centre + stand.radius, top) + 0.28, tall = (high - low) * view / span;
    const Axis up{low, high, tall, 0};
    const auto clip = fmt::format("rest{}", i);
    out += fmt::format(
        "<figure class=\"plot\"><figcaption><b>{} wheel at rest</b>, true scale<span class=\"reading\">"
        "penetration {}, rut {}, bed {} deep</span></figcaption><svg class=\"rest\" viewBox=\"0 0 {} {}\" "
        "role=\"img\" aria-label=\"{} wheel at rest\"><defs><clipPath id=\"{}\"><rect x=\"0\" y=\"0\" "
        "width=\"{}\" height=\"{}\"/></clipPath></defs>",
        escaped(record.result.gears[i].name), both(stand.penetration, measure::depth), both(stand.rut, measure::depth),
        both(bed.depth_at(stand.axles.front()), measure::depth), view, tall, escaped(record.result.gears[i].name), clip,
        view, pixel(up(top - stand.rut)));
    out += ground(bed, across.low, across.high, across, up);
    // The rut behind the leading axle is open: paint it in the page's own colour up to the wheel.
    const auto& history = record.result.history.gears[i];
    std::vector<double> x, z;
    for (std::size_t row = 0; row < history.distance.size(); ++row)
      if (history.distance[row] >= across.low - 0.5) {
        x.push_back(history.distance[row]);
        z.push_back(bed.top_at(history.distance[row]) - history.rut[row]);
      }
    if (x.size() > 1)
      out += fmt::format("<path class=\"open\" d=\"{}L{},{}L{},{}Z\"/><path class=\"curve {}\" d=\"{}\"/>",
                         path(x, z, across, up), pixel(across(x.back())), pixel(up(bed.top_at(x.back()) + 0.01)),
                         pixel(across(x.front())), pixel(up(bed.top_at(x.front()) + 0.01)), gear_look(i),
                         path(x, z, across, up));
    for (const double at : stand.axles)
      out += "<g clip-path=\"url(#" + clip + ")\">" + wheel(at, centre, stand.radius, across, up, gear_look(i)) +
             "</g>" + wheel(at, centre, stand.radius, across, up, "undeformed");
    const double bar = measure::distance.si.factor;  // one metre, whatever the units
    out += fmt::format(
        "<path class=\"bar\" d=\"M12,16v-5h{0}v5\"/><text class=\"tick\" x=\"{1}\" y=\"26\" "
        "text-anchor=\"middle\">1 m = 3.28 ft</text></svg></figure>\n",
        pixel(across(across.low + bar) - across.pixel_low),
        pixel(12 + 0.5 * (across(across.low + bar) - across.pixel_low)));
  }
  return out;
}

}  // namespace apc::report
