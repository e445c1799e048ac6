#include "sph_backend/wheel_path.h"

#include <algorithm>

namespace apc::sph {
namespace {

double ramp(double t) { return t <= 0.0 ? 0.0 : t >= 1.0 ? 1.0 : t * t * t * (10.0 + t * (6.0 * t - 15.0)); }
double ramp_rate(double t) { return t <= 0.0 || t >= 1.0 ? 0.0 : 30.0 * t * t * (1.0 - t) * (1.0 - t); }
/// ∫ S from 0; ½ at 1.
double ramp_integral(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * t * (2.5 + t * (t - 3.0));
}

}  // namespace

AxleState WheelPath::at(double time) const {
  AxleState a;
  const double down = time / press_time, forward = (time - press_time) / accelerate_time;
  const double pressed = end_height + fall * fall_from;
  a.z = start_height + (pressed - start_height) * ramp(down);
  a.vz = (pressed - start_height) * ramp_rate(down) / press_time;
  a.vx = speed * ramp(forward);
  a.x = speed * (accelerate_time * ramp_integral(forward) + std::max(0.0, time - release_time()));
  a.z -= fall * a.x;
  a.vz -= fall * a.vx;
  return a;
}

double WheelPath::spin(double time) const { return release_spin * ramp((time - press_time) / accelerate_time); }

}  // namespace apc::sph
