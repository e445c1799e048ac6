#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "apc/base/units.h"
#include "apc/learning/missing_force.h"

namespace apc::learning {
namespace {

/// Missing force against one coordinate: dots, means of ten classes with twice their standard error, and what is left
/// with the effects added (open circles).
std::string against(const std::vector<MissingForce>& points, const char* title,
                    const std::function<double(const MissingForce&)>& coordinate, double reach) {
  double low = 1e300, high = -1e300;
  for (const auto& p : points) low = std::min(low, coordinate(p)), high = std::max(high, coordinate(p));
  if (!(high > low)) return "";
  constexpr double left = 46.0, wide = 290.0, middle = 84.0, half = 70.0;
  const auto X = [&](double x) { return left + wide * (x - low) / (high - low); };
  const auto Y = [&](double v) { return middle - half * std::clamp(v / reach, -1.0, 1.0); };
  std::string svg = fmt::format("<svg viewBox='0 0 350 190' role='img' aria-label='Missing force against {}'>", title);
  for (const double v : {-reach, 0.0, reach})
    svg += fmt::format(
        "<line x1='{0:.0f}' x2='{1:.0f}' y1='{2:.1f}' y2='{2:.1f}' stroke='var(--line)'/><text x='{3:.0f}' y='{4:.1f}' "
        "text-anchor='end'>{5:+.2f}</text>",
        left, left + wide, Y(v), left - 4.0, Y(v) + 4.0, v);
  svg += "<g class='dots' opacity='0.35'>";
  for (const auto& p : points)
    svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='1.3'/>", X(coordinate(p)), Y(p.missing));
  svg += "</g>";
  constexpr int classes = 10;
  for (int k = 0; k < classes; ++k) {
    double n = 0.0, x = 0.0, sum = 0.0, square = 0.0, rest = 0.0;
    for (const auto& p : points) {
      const int at = std::min(classes - 1, static_cast<int>(classes * (coordinate(p) - low) / (high - low)));
      if (at != k) continue;
      n += 1.0, x += coordinate(p), sum += p.missing, square += p.missing * p.missing, rest += p.left;
    }
    if (n < 4.0) continue;
    const double mean = sum / n, error = 2.0 * std::sqrt(std::max(0.0, square / n - mean * mean) / n);
    svg += fmt::format(
        "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}' stroke='var(--model)' stroke-width='2'/><circle "
        "cx='{0:.1f}' cy='{3:.1f}' r='3.5' fill='var(--model)'/>",
        X(x / n), Y(mean - error), Y(mean + error), Y(mean));
    if (std::isfinite(rest))
      svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='none' stroke='var(--ink)' stroke-width='1.4'/>",
                         X(x / n), Y(rest / n));
  }
  return svg + fmt::format(
                   "<text x='{:.0f}' y='172'>{:.3g}</text><text x='{:.0f}' y='172' text-anchor='end'>{:.3g}</text>"
                   "<text x='{:.0f}' y='186' text-anchor='middle'>{}</text></svg>",
                   left, low, left + wide, high, left + 0.5 * wide, title);
}

std::string bars(const std::vector<Attribution>& list) {
  std::string svg = fmt::format("<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='What the missing force follows'>",
                                22.0 * static_cast<double>(list.size()) + 8.0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double y = 22.0 * static_cast<double>(i) + 4.0;
    svg += fmt::format(
        "<text x='220' y='{0:.0f}' text-anchor='end'>{1}</text><rect x='230' y='{2:.0f}' width='{3:.1f}' height='15' "
        "class='bar'/><text x='{4:.0f}' y='{0:.0f}'>{5:.0f} %</text>",
        y + 12.0, list[i].coordinate, y, std::max(1.0, 400.0 * list[i].share), 238.0 + 400.0 * list[i].share,
        100.0 * list[i].share);
  }
  return svg + "</svg>";
}

}  // namespace

std::string missing_force_charts(const Study& study) {
  const auto points = missing_forces(study);
  const double pitch = joint_pitch(study);
  const auto list = attributions(points, pitch);
  if (list.empty()) return "";
  double mean = 0.0, square = 0.0;
  for (const auto& p : points) mean += p.missing / static_cast<double>(points.size());
  for (const auto& p : points) square += std::pow(p.missing - mean, 2) / static_cast<double>(points.size());
  std::string html = fmt::format(
      "<h2>What the missing force follows</h2><p>Means over 0.1 s inside the bed, over the weight (1 = the aircraft's "
      "weight); root mean square {:.3f} around a mean of {:+.3f}. Bars: share of that variance taken by ten classes of "
      "one coordinate, adjusted for their number; shares overlap, because in a stop everything falls together.</p>",
      std::sqrt(square), mean);
  if (!study.along) html += "<p>Shown is what the fitted background (blocks, tables, instruments) could not take.</p>";
  html += bars(list);
  std::vector<double> sizes;
  for (const auto& p : points) sizes.push_back(std::abs(p.missing));
  std::sort(sizes.begin(), sizes.end());
  const double reach = std::max(0.02, sizes[sizes.size() * 98 / 100]);
  html +=
      "<p>Missing force over weight: dots, one reading each; full circles, means of ten classes with twice their "
      "standard error";
  html += study.along && !study.diagnosis.augmented.empty()
              ? "; open circles, what is left with the effects the diagnosis would add.</p>"
              : ".</p>";
  html += "<div style='display:grid;grid-template-columns:repeat(auto-fit,minmax(300px,1fr));gap:8px'>";
  html += against(
      points, "speed, m/s", [](const MissingForce& m) { return m.speed; }, reach);
  html += against(
      points, "place of the nose wheel, m", [](const MissingForce& m) { return m.place; }, reach);
  html += against(
      points, "penetration of the main tires, mm", [](const MissingForce& m) { return m.penetration / units::mm; },
      reach);
  const std::string within = fmt::format("place within {:.2f} m, m", pitch);
  html += against(
      points, within.c_str(), [pitch](const MissingForce& m) { return std::fmod(m.place, pitch); }, reach);
  html += against(
      points, "vertical load of the main gear, kN", [](const MissingForce& m) { return m.vertical / units::kN; },
      reach);
  html += against(
      points, "time since the leading edge, s", [](const MissingForce& m) { return m.time; }, reach);
  return html + "</div>";
}

}  // namespace apc::learning
