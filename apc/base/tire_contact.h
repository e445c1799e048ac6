/// The one shape of everything that resists a tire: `TireLoad load(const TireContact&)` — a closed form, a load table,
/// an SPH rig, or one of those with an effect applied.
#pragma once

namespace apc {

/// State of one tire in the bed. Distances in m, speed in m/s.
struct TireContact {
  double speed = 0.0;        ///< forward speed of the axle, ≥ 0
  double bed_depth = 0.0;    ///< depth of crushable material under the tire; 0 = pavement
  double penetration = 0.0;  ///< undeformed tire's lowest point below the top surface
};

/// What the bed (or the pavement) does to one tire. Forces in N per tire; steady state, free-rolling, unbraked.
struct TireLoad {
  double drag = 0.0;        ///< ≥ 0, opposes motion
  double vertical = 0.0;    ///< ≥ 0, pushes the tire up
  double rut_depth = 0.0;   ///< depth of the crushed surface left behind, m
  double spin_ratio = 1.0;  ///< ω R / v of the free tire, R the undeformed radius
};

}  // namespace apc
