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
  const double pressed = end_height + fall * fall_from;
  if (entry > 0.0) {
    const double down = speed * time / entry;
    a.x = speed * time, a.vx = speed;
    a.z = start_height + (pressed - start_height) * ramp(down);
    a.vz = (pressed - start_height) * ramp_rate(down) * speed / entry;
  } else {
    const double down = time / press_time, forward = (time - press_time) / accelerate_time;
    a.z = start_height + (pressed - start_height) * ramp(down);
    a.vz = (pressed - start_height) * ramp_rate(down) / press_time;
    a.vx = speed * ramp(forward);
    a.x = speed * (accelerate_time * ramp_integral(forward) + std::max(0.0, time - ready_time()));
  }
  a.z -= fall * a.x;
  a.vz -= fall * a.vx;
  return a;
}

double WheelPath::spin(double time) const {
  return entry > 0.0 ? first_spin : first_spin * ramp((time - press_time) / accelerate_time);
}

WheelPath path_of(const RollingCase& c) {
  const double radius = 0.5 * c.tire.diameter;
  WheelPath path;
  path.start_height = c.bed_depth + radius;
  path.end_height = c.bed_depth - c.penetration + radius;
  path.press_time = 1.875 * c.penetration / c.press_speed;
  path.accelerate_time = 2.0 * c.accelerate_distance / c.speed;
  path.entry = c.entry;
  path.speed = c.speed;
  path.mode = c.spin;
  const double ratio = c.spin == WheelSpin::locked ? 0.0 : c.spin == WheelSpin::driven ? 1.0 : c.release_spin_ratio;
  path.first_spin = ratio * c.speed / radius;
  path.fall = c.fall, path.fall_from = c.transient() + 2.0 * c.window;
  return path;
}

}  // namespace apc::sph
