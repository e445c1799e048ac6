/// Crushable foam: what it is. The law itself is in crushable_foam.h.
///
///   elastic with E, ν; every principal Cauchy stress is held between −σ_y(γ) and the tension cutoff;
///   γ = 1 − ρ0/ρ volumetric strain (compression positive), σ_y the load curve "nominal stress against volumetric
///   strain"; unloading is elastic. Optional damping stress a (d_dev/(1 + ν) + tr d/(3 (1 − 2ν)) I), a = c ρ D L.
/// Source: *MAT_CRUSHABLE_FOAM of LS-DYNA as described for arrestor foam by Barsotti (PEC, comparison of FEM and SPH).
/// Valid: strains beyond the curve's last point continue with its last slope.
#pragma once

#include <string>
#include <vector>

#include "apc/base/curve.h"

namespace apc::sph {

struct Foam {
  std::string name;
  double density = 0.0;         ///< kg/m³
  double youngs_modulus = 0.0;  ///< Pa
  double poisson_ratio = 0.0;
  double tension_cutoff = 0.0;  ///< Pa, ≥ 0
  double damping = 0.0;         ///< D, dimensionless; 1e-4 in the published deck
  LinearCurve load_curve;       ///< σ_y(γ), Pa; γ in [0, 1)

  double yield_stress(double strain) const;
  /// √((λ + 2μ)/ρ): speed of plane waves in the intact foam.
  double sound_speed() const;
  double lame_lambda() const;
  double shear_modulus() const;
};

/// The idealised foam of the published comparison: 3.75e-5 lbf s²/in⁴, E 2000 psi, ν 0, 50 psi up to 85 %, then a lock
/// of 10,000 psi per unit strain to 90 % and 200,000 beyond (the last against over-compaction when a wheel ploughs).
Foam ideal_foam_50psi();

/// σ_y on a uniform grid of γ in [0, 1), for fast look-up; linear between the entries.
struct YieldTable {
  static constexpr int intervals = 4000;  ///< so that 0.85, 0.90 … are grid points and kinks stay sharp
  std::vector<float> stress;              ///< intervals + 1 values, Pa
  float lowest = 0.0f;
};
YieldTable tabulate(const Foam&);

}  // namespace apc::sph
