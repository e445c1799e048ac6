#include "sph_backend/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apc/base/require.h"

namespace apc::sph {
namespace {

constexpr double lowest_order = 0.3, highest_order = 8.0;

/// Best K and φ_ext for a given order; returns the sum of squares.
double fit_linear(const std::vector<double>& h, const std::vector<double>& f, double p, double& k, double& f0) {
  const double n = static_cast<double>(h.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::pow(h[i], p);
    sx += x, sy += f[i], sxx += x * x, sxy += x * f[i];
  }
  k = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  f0 = (sy - k * sx) / n;
  double left = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) left += std::pow(f[i] - f0 - k * std::pow(h[i], p), 2);
  return left;
}

}  // namespace

PowerFit fit_power(const std::vector<double>& sizes, const std::vector<double>& values) {
  require(sizes.size() == values.size() && sizes.size() >= 3, "a convergence fit needs at least three sizes, got ",
          sizes.size(), ".");
  const double largest = *std::max_element(sizes.begin(), sizes.end());
  std::vector<double> h;
  for (const double s : sizes) h.push_back(s / largest);
  PowerFit fit;
  double best = -1.0;
  for (double p = lowest_order; p <= highest_order; p += 0.001) {
    double k = 0.0, f0 = 0.0;
    const double left = fit_linear(h, values, p, k, f0);
    if (best >= 0.0 && left >= best) continue;
    best = left, fit.order = p, fit.extrapolated = f0, fit.coefficient = k / std::pow(largest, p);
  }
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double spread = 0.0;
  for (const double v : values) spread += (v - mean) * (v - mean);
  fit.r2 = spread > 0.0 ? 1.0 - best / spread : 1.0;
  const auto finest = std::min_element(sizes.begin(), sizes.end()) - sizes.begin();
  fit.valid = fit.order > lowest_order + 0.002 && fit.order < highest_order - 0.002;
  if (!fit.valid) fit.extrapolated = values[finest];
  fit.finest_error = std::abs(values[finest] - fit.extrapolated) / std::max(std::abs(fit.extrapolated), 1e-300);
  return fit;
}

GridConvergence grid_convergence(const std::vector<double>& sizes, const std::vector<double>& values) {
  require(sizes.size() == 3 && values.size() == 3, "a grid convergence index needs exactly three sizes.");
  std::vector<std::size_t> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  const double r21 = sizes[order[1]] / sizes[order[0]], r32 = sizes[order[2]] / sizes[order[1]];
  const double e21 = values[order[1]] - values[order[0]], e32 = values[order[2]] - values[order[1]];
  GridConvergence g;
  g.extrapolated = values[order[0]];
  if (e21 == 0.0 || e32 / e21 <= 0.0) return g;
  double p = 1.0;
  for (int k = 0; k < 200; ++k)
    p = std::clamp(
        std::abs(std::log(e32 / e21) + std::log((std::pow(r21, p) - 1.0) / (std::pow(r32, p) - 1.0))) / std::log(r21),
        0.05, 20.0);
  g.order = p;
  const double share = 1.0 / (std::pow(r21, p) - 1.0);
  g.valid = true;
  g.extrapolated = values[order[0]] - e21 * share;
  g.index = 1.25 * std::abs(e21 / values[order[0]]) * share;
  return g;
}

}  // namespace apc::sph
