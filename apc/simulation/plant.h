/// Everything constant during one run, in the form the equations of motion want it: masses, geometry in body axes,
/// struts, rows of wheels, ground. Made once per run from Model and Overrun.
///
/// Body axes: origin at the sprung body's centre of gravity S, x forward, z up, level in the static attitude of the
/// aircraft file. Struts of a group are lumped (the motion is symmetric). Ground axes: x = distance from the bed's
/// leading edge, z = height above the pavement plane.
///
/// State, length 2 n + rows, n = 3 + groups + bogies:
///   positions  X, Z of S, pitch θ, stroke s per group, beam pitch φ per bogie group
///   rates      of the same
///   spins      ω per row, rolling forward positive
#pragma once

#include <vector>

#include "apc/simulation/profile.h"
#include "apc/simulation/simulate.h"
#include "apc/simulation/tire_bed.h"

namespace apc::simulation {

inline constexpr double air_density = 1.225;   ///< kg/m³, ISA sea level
inline constexpr double slip_floor = 1.0;      ///< m/s: slip = (ω_n − ω) R / √(u² + floor²)
inline constexpr double slip_stiffness = 8.0;  ///< d μ / d slip at zero slip
inline constexpr double slip_friction = 0.8;   ///< largest μ a slipping tire can carry
inline constexpr int most_rows = 16, most_groups = 5, most_degrees = 3 + 2 * most_groups;
inline constexpr int most_states = 2 * most_degrees + most_rows;

struct Vector {
  double x = 0.0, z = 0.0;
};

/// One axle of wheels of a gear group: struts × wheels per axle tires side by side.
struct Row {
  int group = 0;
  int ahead = -1;        ///< row whose rut this one follows; -1 for leading rows
  double offset = 0.0;   ///< m ahead of the bogie pivot
  double tires = 2.0;    ///< in the row, all struts
  double inertia = 0.0;  ///< kg m², all wheels of the row
};

struct Group {
  std::string name;
  aircraft::Strut strut;  ///< per strut
  double struts = 1.0;
  double mass = 0.0;  ///< kg unsprung, all struts
  Vector extended;    ///< axle (bogie pivot) at zero stroke, body axes
  Vector axis;        ///< unit vector of the axle's travel in compression, body axes
  double tire_radius = 0.0;
  double braking = 0.0, braking_in_bed = 0.0;
  TireBed ground;
  std::vector<double> corners;  ///< bed distances where a wheel of the group meets a kink of its ground
  int first_row = 0, rows = 1;
  int bogie = -1;                                   ///< index among the bogies; -1 without
  double bogie_inertia = 0.0, bogie_damping = 0.0;  ///< all struts: kg m², N m s
  bool brakes_on_beam = false;                      ///< no brake rods: the beam takes the brakes' torque
};

struct Plant {
  double mass = 0.0, sprung_mass = 0.0, sprung_inertia = 0.0;
  Vector cg;       ///< the aircraft's static centre of gravity, body axes: where speed and accelerations are read
  Vector gravity;  ///< m/s², with the site's grade along x
  double lift_area = 0.0, drag_area = 0.0, moment_area = 0.0;  ///< ½ρ S C, to be multiplied by V²
  double headwind = 0.0, thrust = 0.0;
  Vector thrust_at;           ///< body axes
  bool timed_thrust = false;  ///< alterations add a thrust that depends on time
  const effects::Alterations* alterations = nullptr;
  BrakeMode brake_mode = BrakeMode::friction;
  WheelSpin wheel_spin = WheelSpin::inertial;
  Sinking sinking;
  std::vector<Group> groups;
  std::vector<Row> rows;
  Profile profile;
  bool base_falls = true;  ///< Flush::top: the base falls away; otherwise the top rises
  double setback = 0.0;
  double entry_speed = 0.0;
  int bogies = 0;

  int degrees() const { return 3 + static_cast<int>(groups.size()) + bogies; }
  int states() const { return 2 * degrees() + static_cast<int>(rows.size()); }
};

/// The model must outlive the plant (it points to the tables); so must the overrun (its alterations).
Plant make_plant(const Model&, const Overrun&);

}  // namespace apc::simulation
