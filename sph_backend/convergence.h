/// Convergence of a functional with the particle size: φ(h) = φ_ext + K hᵖ.
///
/// Least squares over p by search, K and φ_ext linear (power-function regression of the published study); for exactly
/// three sizes also the grid convergence index GCI = 1.25 |e₂₁|/(r^p − 1) with its apparent order (Celik et al.,
/// J. Fluids Eng. 130, 2008). An order outside 0.3 … 8 means the values do not converge monotonically: then `valid` is
/// false and φ_ext is the value of the finest size.
#pragma once

#include <vector>

namespace apc::sph {

struct PowerFit {
  bool valid = false;
  double order = 0.0, extrapolated = 0.0, coefficient = 0.0, r2 = 0.0;
  double finest_error = 0.0;  ///< |φ(h_min) − φ_ext|/|φ_ext|
};
PowerFit fit_power(const std::vector<double>& sizes, const std::vector<double>& values);

struct GridConvergence {
  bool valid = false;                                   ///< monotone convergence
  double order = 0.0, extrapolated = 0.0, index = 0.0;  ///< GCI of the finest size, relative
};
/// Sizes and values from coarse to fine or fine to coarse, exactly three.
GridConvergence grid_convergence(const std::vector<double>& sizes, const std::vector<double>& values);

}  // namespace apc::sph
