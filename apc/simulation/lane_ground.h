/// The ground under rows of several runs side by side: plain tables in vectors, everything rarer (ruts, altered ground,
/// the bed before its last piece) lane by lane through the scalar code.
#pragma once

#include "apc/simulation/lane_block.h"
#include "apc/simulation/motion.h"
#include "apc/simulation/plant_lanes.h"

namespace apc::simulation {

template <int W>
GroundUnder<Lanes<W>> ground_under(const PlantLanes<W>& plant, const AroundLanes<W>& around, int index,
                                   const Lanes<W>& distance, const Lanes<W>& half_patch) {
  using V = Lanes<W>;
  const auto inside = around.in_bed[index] & around.present;
  const auto &first = plant.profile.first, &last = plant.profile.last;
  const V ahead = distance + half_patch, behind = distance - half_patch, zero(0.0);
  const auto level = inside & (behind >= last.from) & (ahead <= last.to);
  GroundUnder<V> under;
  under.depth.value = select(level, last.depth + last.slope * (distance - last.from), zero);
  under.depth.slope = under.inclination.value = select(level, last.slope, zero);
  auto others = inside & !level;
  if (!any(others)) return under;
  const auto before = others & (ahead <= first.from);
  under.depth.value = select(before, first.depth, under.depth.value);
  const auto ramp = others & (behind > first.from) & (ahead < first.to);
  others = others & !(before | ramp);
  if (any(ramp)) {  // as Profile::inclination has it
    const auto at = [&](const V& x) { return first.depth + first.slope * (x - first.from); };
    under.depth.value = select(ramp, at(distance), under.depth.value);
    under.depth.slope = select(ramp, first.slope, under.depth.slope);
    under.inclination.value = select(ramp, (at(ahead) - at(behind)) * (0.5 / half_patch), under.inclination.value);
  }
  if (any(others)) {
    alignas(64) double out[4 * W] = {};
    for (int lane = 0; lane < W; ++lane)
      if (others[lane]) lane_profile(*plant.plant[lane], distance[lane], half_patch[lane], out + lane, W);
    const V* o = reinterpret_cast<const V*>(out);
    under.depth.value = select(others, o[0], under.depth.value);
    under.depth.slope = select(others, o[1], under.depth.slope);
    under.inclination.value = select(others, o[2], under.inclination.value);
    under.inclination.slope = select(others, o[3], under.inclination.slope);
  }
  return under;
}

/// Load, what the row behind will find, and slopes by speed, depth, penetration and distance, as in GroundLoad.
template <class V>
struct GroundLanes {
  V value[7];
  V slope[4][4];
};

/// RutLog::at for the lanes in `wanted`: entries lane by lane, the cubic between them side by side.
template <int W>
struct RutLanes {
  Lanes<W> value[4], depth_slope;
};
template <int W>
RutLanes<W> read_ruts(const AroundLanes<W>& around, int index, int leader, const Mask<W>& wanted,
                      const Lanes<W>& distance) {
  using V = Lanes<W>;
  alignas(64) double from[W] = {}, to[W], a[4][W] = {}, b[4][W] = {}, by_a[4][W] = {}, by_b[4][W] = {};
  for (int lane = 0; lane < W; ++lane) {
    to[lane] = 0.0;
    if (!wanted[lane]) continue;
    const auto at = lane_rut(*around.around[lane], leader, distance[lane], around.near[index][lane]);
    from[lane] = at.from, to[lane] = at.to;
    for (int k = 0; k < 4; ++k) a[k][lane] = at.before->value[k];
    if (!at.after) continue;
    for (int k = 0; k < 4; ++k)
      by_a[k][lane] = at.before->slope[k], b[k][lane] = at.after->value[k], by_b[k][lane] = at.after->slope[k];
  }
  const auto lanes = [](const double* x) -> const V& { return *reinterpret_cast<const V*>(x); };
  const auto flat = lanes(to) == lanes(from);
  const V h = select(flat, V(1.0), lanes(to) - lanes(from)), per_h = 1.0 / h, t = (distance - lanes(from)) * per_h,
          r = 1.0 - t;
  const V w0 = r * r * (1.0 + 2.0 * t), w1 = t * t * (3.0 - 2.0 * t), w2 = h * t * r * r, w3 = -h * t * t * r;
  const V s0 = -6.0 * t * r * per_h, s2 = r * (1.0 - 3.0 * t), s3 = t * (3.0 * t - 2.0);
  RutLanes<W> rut;
  for (int k = 0; k < 4; ++k)
    rut.value[k] =
        select(flat, lanes(a[k]), (lanes(a[k]) * w0 + lanes(b[k]) * w1) + (lanes(by_a[k]) * w2 + lanes(by_b[k]) * w3));
  const V slope = (lanes(a[0]) - lanes(b[0])) * s0 + (lanes(by_a[0]) * s2 + lanes(by_b[0]) * s3);
  rut.depth_slope = select(flat, V(0.0), slope);
  return rut;
}

/// How the lanes of a row meet the ground: by the plain table, riding on the floor of a rut, or by the scalar code
/// (altered ground, ruts that yield or begin).
template <int W>
struct Meeting {
  Mask<W> plain, riding, single;
};

/// Sorts the lanes, and fills what rides on a floor (tire_bed.h, the second case).
template <int W>
Meeting<W> meet(const PlantLanes<W>& plant, const AroundLanes<W>& around, int index, const Lanes<W>& depth,
                const Lanes<W>& penetration, const Lanes<W>& distance, GroundLanes<Lanes<W>>& ground) {
  using V = Lanes<W>;
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  Meeting<W> meeting;
  meeting.single = around.altered[row.group] & around.present;
  meeting.plain = around.present & !meeting.single;
  meeting.riding = meeting.plain & !around.present;  // none
  if (row.ahead < 0) return meeting;
  const auto follows = meeting.plain & around.in_bed[index] & (depth > 0.0);
  if (!any(follows)) return meeting;
  const auto rut = read_ruts(around, index, row.ahead, follows, distance);
  const V &rut_depth = rut.value[0], &slope = rut.depth_slope, deflection = penetration - rut_depth;
  const auto in_rut = follows & (rut_depth > shallowest_rut);
  meeting.plain = meeting.plain & !in_rut;
  auto riding = in_rut & !(rut_depth < plain_rut) & (deflection > 0.0);
  const auto floor = group.table.load_on_pavement(riding, deflection);
  meeting.riding = riding & !(floor.load.vertical > group.bearing_gain * rut.value[3]);
  meeting.single = meeting.single | (in_rut & !meeting.riding);
  const V zero(0.0), friction = group.rolling_resistance;
  const V ridden[7] = {friction * floor.load.vertical,
                       floor.load.vertical,
                       rut_depth,
                       floor.load.spin_ratio,
                       rut.value[1],
                       rut.value[2],
                       rut.value[3]};
  for (int k = 0; k < 7; ++k) ground.value[k] = ridden[k];
  const V by_penetration[4] = {friction * floor.slope.vertical, floor.slope.vertical, zero, floor.slope.spin_ratio};
  for (int m = 0; m < 4; ++m) {
    ground.slope[m][0] = ground.slope[m][1] = zero;
    ground.slope[m][2] = by_penetration[m];
    ground.slope[m][3] = m == 2 ? slope : -by_penetration[m] * slope;
  }
  return meeting;
}

template <int W, class Seen>
GroundNumbers<Lanes<W>> ground_numbers(const PlantLanes<W>& plant, const AroundLanes<W>& around, int index,
                                       const Lanes<W>& time, const Lanes<W>& nose, const Lanes<W>& speed,
                                       const Lanes<W>& depth, const Lanes<W>& penetration, const Lanes<W>& distance,
                                       Seen* seen) {
  using V = Lanes<W>;
  const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(index)].group)];
  GroundLanes<V> ground;
  const auto meeting = meet(plant, around, index, depth, penetration, distance, ground);
  V* value = ground.value;
  if (any(meeting.plain)) {
    const auto load = group.table.load(meeting.plain, speed, depth, penetration);
    const V plain[7] = {load.drag,   load.vertical, load.rut_depth, load.spin_ratio,
                        penetration, load.drag,     load.vertical};
    for (int k = 0; k < 7; ++k) value[k] = select(meeting.riding, value[k], plain[k]);
  }
  if (any(meeting.single)) {
    alignas(64) double out[7 * W] = {};
    for (int lane = 0; lane < W; ++lane)
      if (meeting.single[lane])
        lane_ground(*plant.plant[lane], *around.around[lane], index, time[lane], nose[lane], speed[lane], depth[lane],
                    penetration[lane], distance[lane], out + lane, W);
    const V* o = reinterpret_cast<const V*>(out);
    for (int k = 0; k < 7; ++k) value[k] = select(meeting.single, o[k], value[k]);
  }
  if (seen) {
    seen->load = {value[0], value[1], value[2], value[3]};
    seen->virgin_penetration = value[4], seen->virgin_drag = value[5], seen->virgin_vertical = value[6];
  }
  return {value[0], value[1], value[2], value[3]};
}

template <int N, int W, class Seen>
GroundNumbers<Dual<N, Lanes<W>>> ground_numbers(const PlantLanes<W>& plant, const AroundLanes<W>& around, int index,
                                                const Lanes<W>& time, const Lanes<W>& nose,
                                                const Dual<N, Lanes<W>>& speed, const Dual<N, Lanes<W>>& depth,
                                                const Dual<N, Lanes<W>>& penetration, const Dual<N, Lanes<W>>& distance,
                                                Seen* seen) {
  using V = Lanes<W>;
  const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(index)].group)];
  GroundLanes<V> ground;
  const auto meeting = meet(plant, around, index, depth.value, penetration.value, distance.value, ground);
  V* value = ground.value;
  if (any(meeting.plain)) {
    const auto all = group.table.load_with_slopes(meeting.plain, speed.value, depth.value, penetration.value);
    const V plain[7] = {all.load.drag,     all.load.vertical, all.load.rut_depth, all.load.spin_ratio,
                        penetration.value, all.load.drag,     all.load.vertical};
    for (int k = 0; k < 7; ++k) value[k] = select(meeting.riding, value[k], plain[k]);
    const V* slopes[4] = {all.drag, all.vertical, all.rut_depth, all.spin_ratio};
    for (int m = 0; m < 4; ++m)
      for (int k = 0; k < 4; ++k)
        ground.slope[m][k] = select(meeting.riding, ground.slope[m][k], k < 3 ? slopes[m][k] : V(0.0));
  }
  if (any(meeting.single)) {
    alignas(64) double out[23 * W] = {};
    for (int lane = 0; lane < W; ++lane)
      if (meeting.single[lane])
        lane_ground_with_slopes(*plant.plant[lane], *around.around[lane], index, time[lane], nose[lane],
                                speed.value[lane], depth.value[lane], penetration.value[lane], distance.value[lane],
                                out + lane, W);
    const V* o = reinterpret_cast<const V*>(out);
    for (int k = 0; k < 7; ++k) value[k] = select(meeting.single, o[k], value[k]);
    for (int m = 0; m < 4; ++m)
      for (int k = 0; k < 4; ++k) ground.slope[m][k] = select(meeting.single, o[7 + 4 * m + k], ground.slope[m][k]);
  }
  if (seen) {
    seen->load = {value[0], value[1], value[2], value[3]};
    seen->virgin_penetration = value[4], seen->virgin_drag = value[5], seen->virgin_vertical = value[6];
  }
  const auto combine = [&](int m) {
    return along_slopes(value[m], ground.slope[m], speed, depth, penetration, distance);
  };
  return {combine(0), combine(1), combine(2), combine(3)};
}

}  // namespace apc::simulation
