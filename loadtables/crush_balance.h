/// Reference physics of a tire in a crushable bed, in closed form: the quasi-static balance of tire and foam,
///
///   F_tire(δ) = k_v σ c(D) (a + b) (1 + s²) exp(−k_p x_p²),   rut D = P − δ,
///   a = √(2 R P − P²)   (front half of the chord at the surface; R once P ≥ R),
///   b = √(2 R δ − δ²)   (rear half of the tire's flat),
///   c = w (x (2 − x))^q (1 + k_s D/w),  x = min(2 D/w, 1)   (the crown sinks in; the walls of the rut shear),
///   x_p = max(P/R − 1, 0)   (beyond the axle's height the wheel ploughs and is carried less),
///   s = ln(1 + exp((D − ε h)/(κ h)))   (the foam locks up at the strain ε, within κ of it),
///   drag = k_d σ c_d(D) D (1 + k_i v²/v₀²) + μ_r F,   v₀ = 70 kt,   free spin ω R/v = R/(R − δ/3),
///   c_d like c with q_d and k_sd of its own: the work of crushing sums over the rut's walls, and grows with inertia.
///
/// It knows where the foam is compacted and the tire takes over; the metamodel then only has to learn a smooth ratio.
/// With h = 0 it is the tire on pavement: D = 0, F = F_tire(P), drag = μ_r F. Valid for P ≥ 0, h ≥ 0.
/// Contact length and crush drag σ w D: the usual estimate for rigid wheels in crushable foam (ACRP Report 29, §9).
#pragma once

#include <vector>

#include "apc/base/curve.h"
#include "loadtables/samples.h"

namespace apc::loadtables {

struct CrushBalance {
  MonotoneCurve tire;                                               ///< load over deflection, N over m
  double radius = 0.0, width = 0.0;                                 ///< R, w in m
  double strength = 0.0;                                            ///< σ, Pa
  double rolling_resistance = 0.014;                                ///< μ_r
  double area_factor = 1.0;                                         ///< k_v
  double crown = 0.2, wall_shear = 0.05;                            ///< q, k_s
  double plough = 0.3;                                              ///< k_p
  double lock_up = 0.85, lock_width = 0.04;                         ///< ε, κ
  double drag_crown = 0.2, drag_wall_shear = 0.05, inertia = 0.05;  ///< q_d, k_sd, k_i
  double drag_factor = 1.3;  ///< k_d: edge shear, friction and inertia on top of plain crushing

  TireLoad load(const TireContact&) const;
};

/// The balance whose factors k_v, q, k_s, k_p, ε, κ and k_d, q_d, k_sd, k_i fit the samples best (least squares of the
/// logarithms of both loads).
CrushBalance calibrate(CrushBalance start, const std::vector<Sample>&);

}  // namespace apc::loadtables
