/// Path of the axle and of the prescribed spin.
///
/// Pressed: press down, accelerate and spin up, roll on at constant speed (sequence of ACRP 29, figure 9-23). With an
/// `entry` length the wheel instead rolls at full speed from the start and comes down along that way. A sinking wheel
/// goes down by `fall` per length of way and is at its nominal height at `fall_from`. All ramps are
/// S(τ) = 10 τ³ − 15 τ⁴ + 6 τ⁵.
#pragma once

#include "sph_backend/tire_contact.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {

struct WheelPath {
  double start_height = 0.0, end_height = 0.0;  ///< of the axle above the rigid plane, m
  double press_time = 0.0, accelerate_time = 0.0;
  double entry = 0.0;  ///< m; 0 = pressed
  double speed = 0.0;  ///< m/s, final
  WheelSpin mode = WheelSpin::free;
  double first_spin = 0.0;             ///< rad/s at the end of the acceleration; then a free wheel is let go
  double fall = 0.0, fall_from = 0.0;  ///< 1; m of travel

  /// When the wheel has reached speed and depth.
  double ready_time() const { return entry > 0.0 ? entry / speed : press_time + accelerate_time; }
  AxleState at(double time) const;
  bool spin_is_prescribed(double time) const { return mode != WheelSpin::free || time < ready_time(); }
  /// Prescribed spin.
  double spin(double time) const;
};

/// Of a case with every default written out.
WheelPath path_of(const RollingCase& completed);

}  // namespace apc::sph
