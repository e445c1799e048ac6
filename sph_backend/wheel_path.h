/// Path of the axle and of the prescribed spin: press down, accelerate and spin up, roll on at constant speed
/// (sequence of ACRP 29, figure 9-23). A sinking wheel goes down by `fall` per length of way and is at its nominal
/// height at `fall_from`. All ramps are S(τ) = 10 τ³ − 15 τ⁴ + 6 τ⁵.
#pragma once

#include "sph_backend/tire_contact.h"

namespace apc::sph {

struct WheelPath {
  double start_height = 0.0, end_height = 0.0;  ///< of the axle above the rigid plane, m
  double press_time = 0.0, accelerate_time = 0.0;
  double speed = 0.0;                  ///< m/s, final
  double release_spin = 0.0;           ///< rad/s at the end of the acceleration, then the wheel is free
  double fall = 0.0, fall_from = 0.0;  ///< 1; m of travel

  double release_time() const { return press_time + accelerate_time; }
  AxleState at(double time) const;
  /// Prescribed spin before release.
  double spin(double time) const;
};

}  // namespace apc::sph
