/// What is left of a scatter in its mean over a way, when places are correlated as exp(−distance/ℓ):
///     K(x) = 2 (x − 1 + e⁻ˣ)/x²,   x = way/ℓ ≥ 0;   1 for a short way, 2/x for a long one
/// Source: VanMarcke, Random Fields (1983), section 5.1 (variance function of the exponential correlation).
#pragma once

#include <cmath>

namespace apc::learning {

/// Variance of the mean over that of a single place.
inline double mean_of_scatter(double x) { return x < 1e-3 ? 1.0 - x / 3.0 : 2.0 * (x - 1.0 + std::exp(-x)) / (x * x); }

}  // namespace apc::learning
