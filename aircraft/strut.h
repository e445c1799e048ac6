/// The oleo-pneumatic strut, one law per function, per strut; positive forces push the strut apart.
///
///   gas       F = (p_ext (V / (V − A s))ⁿ − p_atm) A             polytrope anchored at full extension
///   orifice   F = c s′|s′|, c by the sign of s′                   turbulent metering; C¹ through s′ = 0
///   friction  F = (F_seal + μ_b (|N_u| + |N_l|)) tanh(s′ / v_f)   v_f = 0.02 m/s
///   bearings  N_u = F_n (l₂ − s)/(l₁ + s),  N_l = F_n + N_u       F_n: axle force normal to the strut
///   stops     F = ±k e² / (e + d), e = travel beyond either end, d = 1 mm: C¹, stiffness k after a millimetre
///
/// Source: B. Milwitzky and F. E. Cook, NACA Report 1154 (1953), for the first four (recalled, not read). Valid for
/// s < V/A; beyond it the gas law has no value and the solver must take a smaller step.
#pragma once

#include <cmath>

#include "aircraft/aircraft.h"
#include "apc/base/select.h"

namespace apc::aircraft {

inline constexpr double atmospheric_pressure = 101325.0;  ///< Pa, standard
inline constexpr double friction_speed = 0.02;            ///< m/s, v_f
inline constexpr double stop_softness = 1e-3;             ///< m, d

/// `S`: a Strut, or the struts of several runs side by side; `T`: numbers to match, with or without derivatives.
template <class S, class T>
T gas_force(const S& strut, const T& stroke) {
  using std::pow;
  const auto ratio = strut.piston_area / strut.extended_gas_volume;
  return strut.piston_area *
         (strut.extended_pressure * pow(1.0 - ratio * stroke, -strut.polytropic_exponent) - atmospheric_pressure);
}

template <class S, class T>
T orifice_force(const S& strut, const T& stroke_rate) {
  using std::abs;
  const auto constant = select(stroke_rate < 0.0, strut.damping_rebound, strut.damping_compression);
  return constant * stroke_rate * abs(stroke_rate);
}

/// |N_u| + |N_l| for an axle force `normal` to the strut; |·| is rounded within 10 N of zero.
template <class S, class T>
T bearing_load(const S& strut, const T& stroke, const T& normal) {
  using std::sqrt;
  const T lever = (strut.bearing_lower - stroke) / (strut.bearing_upper + stroke);
  return sqrt(normal * normal + 100.0) * (1.0 + 2.0 * lever);
}

template <class S, class T>
T friction_force(const S& strut, const T& stroke, const T& stroke_rate, const T& normal) {
  using std::tanh;
  return (strut.friction + strut.bearing_friction * bearing_load(strut, stroke, normal)) *
         tanh(stroke_rate * (1.0 / friction_speed));
}

template <class S, class T>
T stop_force(const S& strut, const T& stroke) {
  T force(0.0);
  const auto beyond_end = stroke > strut.stroke;
  if (any(beyond_end)) {
    const T beyond = stroke - strut.stroke;
    force = select(beyond_end, T(strut.end_stop * beyond * beyond / (beyond + stop_softness)), force);
  }
  const auto below_start = stroke < 0.0;
  if (any(below_start))
    force = select(below_start, T(-strut.end_stop * stroke * stroke / (stop_softness - stroke)), force);
  return force;
}

/// J stored in the gas since full extension (atmosphere included), and in the stops.
double gas_energy(const Strut&, double stroke);
double stop_energy(const Strut&, double stroke);

/// Stroke at which gas and stops carry `load` (N) at rest.
double static_stroke(const Strut&, double load);

}  // namespace apc::aircraft
