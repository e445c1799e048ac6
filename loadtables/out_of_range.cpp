#include "loadtables/out_of_range.h"

#include <algorithm>
#include <cmath>

#include "loadtables/table_point.h"

namespace apc::loadtables {
namespace {

/// Chain rule from the axes of a table to speed, bed depth and penetration.
struct Axes {
  double direction = 1.0, u_by_depth = 0.0, scale_by_depth = 0.0;  ///< 0 in a bed of no depth or less
};
Axes axes_of(const LoadTable::Data& data, const TireContact& contact) {
  Axes axes;
  axes.direction = contact.speed < 0.0 ? -1.0 : 1.0;
  if (contact.bed_depth < 0.0) return axes;
  axes.u_by_depth = DepthScale::slope(contact.bed_depth);
  axes.scale_by_depth = data.penetration.slope(contact.bed_depth);
  return axes;
}

/// Responses and their slopes by the relative penetration, at a ratio on the axis or at the edge.
struct Sums {
  Sloped value[responses], by_ratio[responses];  ///< derivatives by speed, bed depth; ratio held
};
Sums sums_at(const LoadTable::Data& data, const Axes& axes, double speed, double u, double ratio) {
  const auto v = weights(data.speed, speed), depth = weights(data.depth, u);
  auto r = weights(data.ratio, ratio);
  SplineSums point, steep;
  evaluate(data, v, depth, r, point);
  std::copy(r.slope, r.slope + 4, r.value);  // the same sum over slopes along r: what the slope itself changes by
  evaluate(data, v, depth, r, steep);
  Sums sums;
  for (std::size_t m = 0; m < responses; ++m) {
    sums.value[m] = {point.value[m], axes.direction * point.by_v[m], point.by_u[m] * axes.u_by_depth, 0.0};
    sums.by_ratio[m] = {point.by_r[m], axes.direction * steep.by_v[m], steep.by_u[m] * axes.u_by_depth, 0.0};
  }
  return sums;
}
Sums sums_at_edge(const LoadTable::Data& data, const EdgeSheet& sheet, const Axes& axes, double speed, double u) {
  const auto v = weights(data.speed, speed), depth = weights(data.depth, u);
  double plain[EdgeSheet::numbers], by_v[EdgeSheet::numbers], by_u[EdgeSheet::numbers];
  sheet.sum(v.value, v.first, depth.value, depth.first, plain);
  sheet.sum(v.slope, v.first, depth.value, depth.first, by_v);
  sheet.sum(v.value, v.first, depth.slope, depth.first, by_u);
  const auto sloped = [&](std::size_t m) {
    return Sloped{plain[m], axes.direction * by_v[m], by_u[m] * axes.u_by_depth, 0.0};
  };
  Sums sums;
  for (std::size_t m = 0; m < responses; ++m) sums.value[m] = sloped(m), sums.by_ratio[m] = sloped(responses + m);
  return sums;
}

/// Keeps drag, vertical and rut positive where a linear continuation along speed or depth would not.
template <class SumsAt>
void keep_positive(const LoadTable::Data& data, const Axes& axes, const Place& at, const SumsAt& sums_of, Sums& sums) {
  const double speed = std::clamp(at.speed, data.speed.low, data.speed.high()),
               u = std::clamp(at.u, data.depth.low, data.depth.high());
  if (speed == at.speed && u == at.u) return;
  auto edge = axes;
  if (speed != at.speed) edge.direction = 0.0;
  if (u != at.u) edge.u_by_depth = 0.0;
  const auto inside = sums_of(edge, speed, u);
  for (std::size_t m = drag; m <= rut_depth; ++m) {
    if (sums.value[m].value >= 0.5 * inside.value[m].value || inside.value[m].value <= 0.0) continue;
    const Sloped z = sums.value[m] / inside.value[m];
    const double fading = std::exp(2.0 * z.value - 1.0);  // φ′(z) = 2 φ(z)
    const Sloped of_line = chain(fading, 2.0 * fading, z, 0.0, z);
    sums.value[m] = inside.value[m] * (0.5 * of_line);
    // Of φ(line/edge) · edge by the ratio.
    sums.by_ratio[m] = of_line * sums.by_ratio[m] + (0.5 * of_line - z * of_line) * inside.by_ratio[m];
  }
}

LoadWithSlopes as_load(const Sloped (&r)[responses]) {
  const auto slopes = [](const Sloped& x) { return Slopes{x.d[0], x.d[1], x.d[2]}; };
  return {{r[drag].value, r[vertical].value, r[rut_depth].value, 1.0 - r[slip].value},
          slopes(r[drag]),
          slopes(r[vertical]),
          slopes(r[rut_depth]),
          slopes(0.0 - r[slip])};
}

}  // namespace

bool out_of_range(const LoadTable::Data& data, const TireContact& contact) {
  const auto at = place(data, contact);
  return beyond(data.speed, at.speed) || beyond(data.depth, at.u) || beyond_ratio(data.ratio, at.ratio);
}

LoadWithSlopes load_out_of_range(const LoadTable::Data& data, const Edge& edge, const TireContact& contact) {
  const auto at = place(data, contact);
  const auto axes = axes_of(data, contact);
  const Sloped scale{at.scale, 0.0, axes.scale_by_depth, 0.0};
  const Sloped penetration{contact.penetration, 0.0, 0.0, 1.0};
  const bool through = beyond_ratio(data.ratio, at.ratio);
  const auto sums_of = [&](const Axes& of, double speed, double u) {
    return through ? sums_at_edge(data, edge.sheet, of, speed, u) : sums_at(data, of, speed, u, at.ratio);
  };
  auto sums = sums_of(axes, at.speed, at.u);
  keep_positive(data, axes, at, sums_of, sums);
  Sloped out[responses];
  if (through) {
    AtEdge<Sloped> there;
    for (std::size_t m = 0; m < responses; ++m)
      there.value[m] = sums.value[m], there.slope[m] = sums.by_ratio[m] / scale;
    const Sloped depth{std::max(contact.bed_depth, 0.0), 0.0, contact.bed_depth < 0.0 ? 0.0 : 1.0, 0.0};
    crushed_through(edge.base, there, depth, penetration - last_ratio(data.ratio) * scale, out);
  } else {
    const Sloped moving = penetration / scale;  // the ratio, which moves with penetration and depth
    for (std::size_t m = 0; m < responses; ++m)
      out[m] = chain(sums.value[m].value, 1.0, sums.value[m], sums.by_ratio[m].value, moving);
  }
  return as_load(out);
}

TireLoad plain_load_out_of_range(const LoadTable::Data& data, const Edge& edge, const TireContact& contact) {
  const auto at = place(data, contact);
  if (beyond(data.speed, at.speed) || beyond(data.depth, at.u) || !beyond_ratio(data.ratio, at.ratio))
    return load_out_of_range(data, edge, contact).load;
  const auto v = weights(data.speed, at.speed), u = weights(data.depth, at.u);
  double sums[EdgeSheet::numbers], out[responses];
  edge.sheet.sum(v.value, v.first, u.value, u.first, sums);
  AtEdge<double> there;
  for (std::size_t m = 0; m < responses; ++m) there.value[m] = sums[m], there.slope[m] = sums[responses + m] / at.scale;
  crushed_through(edge.base, there, std::max(contact.bed_depth, 0.0),
                  contact.penetration - last_ratio(data.ratio) * at.scale, out);
  return {out[drag], out[vertical], out[rut_depth], 1.0 - out[slip]};
}

}  // namespace apc::loadtables
