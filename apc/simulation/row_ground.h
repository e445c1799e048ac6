/// The ground under one row of wheels as numbers of the motion's laws (motion.h): where its tires are, the rut they
/// follow, the load there with or without slopes. lane_ground.h has the same for runs side by side.
#pragma once

#include "apc/simulation/dual.h"
#include "apc/simulation/equations.h"

namespace apc::simulation {

/// The ground under one tire as numbers of type T.
template <class T>
struct GroundNumbers {
  T drag, vertical, rut_depth, spin_ratio;
};

/// The place of one row's tires, and the rut there when they follow one.
struct RowPlace {
  effects::TirePlace place;
  Rut ahead;
  bool follows = false;
};
enum class RutSlopes { no, yes };
inline RowPlace row_place(const Plant& plant, const Surroundings& around, int index, double time, double nose,
                          double distance, const TireContact& contact, RutSlopes slopes) {
  const int leader = plant.rows[static_cast<std::size_t>(index)].ahead;
  RowPlace at{{contact, distance, nose, time}, {}, around.in_bed[static_cast<std::size_t>(index)] && leader >= 0};
  if (at.follows) {
    const auto& log = around.ruts[static_cast<std::size_t>(leader)];
    at.ahead = slopes == RutSlopes::yes ? log.at(distance) : log.values_at(distance);
  }
  return at;
}
inline const TireBed& ground_of(const Plant& plant, int index) {
  return plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(index)].group)].ground;
}

/// What the ground does to one tire of a row, by speed, depth, penetration and distance.
inline GroundNumbers<double> ground_numbers(const Plant& plant, const Surroundings& around, int index, double time,
                                            double nose, double speed, double depth, double penetration,
                                            double distance, GroundLoad* load) {
  const auto& ground = ground_of(plant, index);
  const auto at = row_place(plant, around, index, time, nose, distance, {speed, depth, penetration}, RutSlopes::no);
  if (!load && !at.follows && !ground.alterations) {
    const auto plain = ground.table->load(at.place.contact);
    return {plain.drag, plain.vertical, plain.rut_depth, plain.spin_ratio};
  }
  const auto all = ground_load(ground, at.place, at.follows ? &at.ahead : nullptr);
  if (load) *load = all;
  return {all.load.drag, all.load.vertical, all.load.rut_depth, all.load.spin_ratio};
}

/// The chain rule from the ground's four slopes.
template <int N, class V, class Slope>
Dual<N, V> along_slopes(const V& value, const Slope& slope, const Dual<N, V>& speed, const Dual<N, V>& depth,
                        const Dual<N, V>& penetration, const Dual<N, V>& distance) {
  Dual<N, V> y;
  y.value = value;
  for (int i = 0; i < N; ++i)
    y.d[i] = slope[0] * speed.d[i] + slope[1] * depth.d[i] + slope[2] * penetration.d[i] + slope[3] * distance.d[i];
  return y;
}

template <int N>
GroundNumbers<Dual<N>> ground_numbers(const Plant& plant, const Surroundings& around, int index, double time,
                                      double nose, const Dual<N>& speed, const Dual<N>& depth,
                                      const Dual<N>& penetration, const Dual<N>& distance, GroundLoad* seen) {
  const auto at = row_place(plant, around, index, time, nose, distance.value,
                            {speed.value, depth.value, penetration.value}, RutSlopes::yes);
  const auto load = ground_load_with_slopes(ground_of(plant, index), at.place, at.follows ? &at.ahead : nullptr);
  if (seen) *seen = load;
  const auto combine = [&](double value, const std::array<double, 4>& slope) {
    return along_slopes(value, slope, speed, depth, penetration, distance);
  };
  return {combine(load.load.drag, load.drag), combine(load.load.vertical, load.vertical),
          combine(load.load.rut_depth, load.rut_depth), combine(load.load.spin_ratio, load.spin_ratio)};
}

/// The ground under a wheel: depth, and on a falling base the inclination under the contact patch.
inline Profile::Ground ground_under(const Plant& plant, const Surroundings& around, int index, double distance,
                                    double half_patch) {
  return around.in_bed[static_cast<std::size_t>(index)] ? plant.profile.under(distance, half_patch) : Profile::Ground{};
}

}  // namespace apc::simulation
