/// The law of crushable foam at one point of material, in double precision.
///
///   1. turn: σ ← R σ Rᵀ with R = (I − ½ Ω)⁻¹ (I + ½ Ω), Ω = Δt skew L at mid-step (Hughes and Winget, Int. J. Numer.
///      Meth. Eng. 15, 1980): exact for a rigid turn
///   2. elastic trial: σ ← σ + λ Δt tr D I + 2 μ Δt D
///   3. every principal stress is held between −σ_y(γ) and the tension cutoff, γ = 1 − ρ0/ρ at the end of the step
/// The particles' kernels hold the same law in vectors of floats (foam_kernels.inl); a test compares the two.
/// Source: *MAT_CRUSHABLE_FOAM as in foam.h.
#pragma once

#include <array>

#include "sph_backend/foam.h"

namespace apc::sph {

using Stress = std::array<double, 6>;      ///< xx yy zz xy xz yz
using Tensor = std::array<double, 9>;      ///< row by row: [3 i + j] = ∂v_i/∂x_j
using Stretching = std::array<double, 6>;  ///< sym of a Tensor, same order as Stress

struct CrushLaw {
  double lame_lambda = 0.0, shear_modulus = 0.0, tension_cutoff = 0.0;
  double damping = 0.0;  ///< c ρ0 D L, Pa s: rate damping of an element of size L
  double poisson_ratio = 0.0;
  YieldTable yield;
};
/// `length` is the particle spacing or element size that the material's rate damping refers to.
CrushLaw crush_law(const Foam&, double length);

/// Stress after a step whose displacement gradient at mid-step is `increment` = Δt L. `compaction` is γ at its end.
Stress crush(const CrushLaw&, const Stress& old, const Tensor& increment, double compaction);

/// Rate damping a (d_dev/(1 + ν) + tr d/(3 (1 − 2ν)) I), a = damping/(1 + γ); not kept in the stress.
Stress damping_stress(const CrushLaw&, const Stretching& d, double compaction);

Stretching symmetric_part(const Tensor&);
/// σ : d.
double inner(const Stress&, const Stretching&);

}  // namespace apc::sph
