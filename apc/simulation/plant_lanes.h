/// Plant, surroundings and moment of several runs side by side, under the names motion.h knows: numbers in vectors,
/// what all runs of a block must share (`Shape`) once.
#pragma once

#include "apc/simulation/equations.h"
#include "apc/simulation/lanes.h"
#include "loadtables/table_lanes.h"

namespace apc::simulation {

template <class T, int Most>
struct Few {
  T at[Most];
  std::size_t count = 0;
  std::size_t size() const { return count; }
  T& operator[](std::size_t i) { return at[i]; }
  const T& operator[](std::size_t i) const { return at[i]; }
};

template <class V>
struct StrutLanes {
  V stroke, piston_area, extended_pressure, extended_gas_volume, polytropic_exponent;
  V damping_compression, damping_rebound, friction, bearing_friction, bearing_upper, bearing_lower, end_stop;
};

template <int W>
struct GroupLanes {
  using V = Lanes<W>;
  StrutLanes<V> strut;
  V struts, mass, tire_radius, braking, braking_in_bed, bogie_inertia, bogie_damping, bearing_gain, rolling_resistance;
  Pair<V> extended, axis;
  loadtables::TableLanes<V, W> table;
  int first_row, rows, bogie;
};

template <int W>
struct RowLanes {
  Lanes<W> offset, tires, inertia;
  int group, ahead;
};

/// The first and last pieces of the bed in vectors; the others by asking the run's own profile.
template <int W>
struct ProfileLanes {
  struct {
    Lanes<W> from, to, depth, slope;
  } first, last;
};

template <int W>
struct PlantLanes {
  using V = Lanes<W>;
  V sprung_mass, sprung_inertia, lift_area, drag_area, moment_area, headwind, thrust;
  Pair<V> cg, gravity, thrust_at;
  Few<GroupLanes<W>, most_groups> groups;
  Few<RowLanes<W>, most_rows> rows;
  ProfileLanes<W> profile;
  bool base_falls;
  BrakeMode brake_mode;
  WheelSpin wheel_spin;
  int bogies;
  const Plant* plant[W];

  int degrees() const { return 3 + static_cast<int>(groups.size()) + bogies; }
  int states() const { return 2 * degrees() + static_cast<int>(rows.size()); }
};

template <int W>
Lanes<W> thrust_at(const PlantLanes<W>& plant, const Lanes<W>&) {
  return plant.thrust;
}

template <int W>
struct AroundLanes {
  Mask<W> in_bed[most_rows], altered[most_groups];  ///< altered: the group's tires do not see the plain table
  Mask<W> present;                                  ///< a run is in the lane
  const Surroundings* around[W];
  mutable std::size_t near[most_rows][W] = {};  ///< where each row found its rut last: only where to search first
};

/// What GroundLoad, RowMoment, GroupMoment and Moment tell observers.
template <class V>
struct RowMomentLanes {
  struct {
    struct {
      V drag, vertical, rut_depth, spin_ratio;
    } load;
    V virgin_penetration, virgin_drag, virgin_vertical;
  } ground;
  V distance, speed, penetration, bed_depth, force_x, force_z, contact_x, contact_z, brake_force, brake_torque,
      slip_force, roll_radius, spin;
  Pair<V> velocity, tangent;
};
template <class V>
struct GroupMomentLanes {
  V stroke, stroke_rate, gas, orifice, friction, stop;
  Pair<V> axle, axle_velocity;
};
template <class V>
struct MomentLanes {
  RowMomentLanes<V> rows[most_rows];
  GroupMomentLanes<V> groups[most_groups];
  Pair<V> cg_position, cg_velocity, cg_acceleration, aero, thrust;
  V aero_moment, thrust_moment;
};

}  // namespace apc::simulation
