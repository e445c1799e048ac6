/// Wendland C2 kernel in three dimensions, q = r/h, support 2h:
///   W(r, h)  = 21/(16 π h³) (1 − q/2)⁴ (2q + 1)
///   ∇W       = −105/(16 π h⁵) (1 − q/2)³ · r_vec
/// Source: H. Wendland, Adv. Comput. Math. 4 (1995) 389–396; no pairing instability (Dehnen & Aly, MNRAS 425, 2012).
///
/// A pair uses the harmonic mean of its smoothing lengths, 1/h = (1/h_i + 1/h_j)/2, so that both sides see the same
/// kernel and the pair forces are exactly opposite.
#pragma once

#include <cmath>
#include <numbers>

namespace apc::sph {

inline constexpr double gradient_constant = 105.0 / (16.0 * std::numbers::pi);
inline constexpr double kernel_constant = 21.0 / (16.0 * std::numbers::pi);

/// Smoothing length of the undeformed lattice in spacings, and its floor under compaction (h follows density between).
inline constexpr double smoothing_ratio = 1.2, smoothing_floor = 0.7;

inline double kernel(double r, double inverse_h) {
  const double q = r * inverse_h, t = 1.0 - 0.5 * q;
  return t <= 0.0 ? 0.0 : kernel_constant * inverse_h * inverse_h * inverse_h * t * t * t * t * (2.0 * q + 1.0);
}

/// (dW/dr)/r, never positive.
inline double kernel_slope(double r, double inverse_h) {
  const double t = 1.0 - 0.5 * r * inverse_h;
  return t <= 0.0 ? 0.0 : -gradient_constant * std::pow(inverse_h, 5) * t * t * t;
}

}  // namespace apc::sph
