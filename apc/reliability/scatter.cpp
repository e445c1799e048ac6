#include "apc/reliability/scatter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace apc::reliability {

double Draws::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) * 0x1p-53;
}

double normal_of(double u) {
  static constexpr double a[] = {-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                                 1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
  static constexpr double b[] = {-5.447609879822406e+01, 1.615858368580409e+02, -1.556989798598866e+02,
                                 6.680131188771972e+01, -1.328068155288572e+01};
  static constexpr double c[] = {-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                                 -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
  static constexpr double d[] = {7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                                 3.754408661907416e+00};
  const double p = std::min(u, 1 - u);
  double x;
  if (p < 0.02425) {
    const double q = std::sqrt(-2 * std::log(p));
    x = (((((c[0] * q + c[1]) * q + c[2]) * q + c[3]) * q + c[4]) * q + c[5]) /
        ((((d[0] * q + d[1]) * q + d[2]) * q + d[3]) * q + 1);
  } else {
    const double q = p - 0.5, r = q * q;
    x = (((((a[0] * r + a[1]) * r + a[2]) * r + a[3]) * r + a[4]) * r + a[5]) * q /
        (((((b[0] * r + b[1]) * r + b[2]) * r + b[3]) * r + b[4]) * r + 1);
  }
  return std::clamp(u > 0.5 ? -x : x, -3.0, 3.0);
}

std::vector<std::array<double, scattered_inputs>> latin_hypercube(std::size_t count, std::uint64_t seed) {
  Draws draws(seed);
  std::vector<std::array<double, scattered_inputs>> points(count);
  std::vector<std::size_t> order(count);
  for (std::size_t input = 0; input < scattered_inputs; ++input) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(draws.next() * static_cast<double>(i))]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][input] = (static_cast<double>(order[i]) + draws.next()) / static_cast<double>(count);
  }
  return points;
}

const std::array<const char*, scattered_inputs>& scattered_names() {
  static const std::array<const char*, scattered_inputs> names{
      "mass", "centre of gravity", "braking", "bed strength", "bed depth", "temperature", "age of the bed"};
  return names;
}

namespace {

/// A stationary Gaussian process with exponential correlation, at knots along the bed (first-order autoregression).
effects::StrengthProfile block_strengths(const Scatter& scatter, double length, double share, std::uint64_t seed) {
  effects::StrengthProfile profile;
  profile.spacing = 0.5 * std::max(0.5, scatter.correlation);
  const double memory = std::exp(-profile.spacing / std::max(1e-3, scatter.correlation));
  Draws draws(seed);
  double now = normal_of(draws.next());
  for (double at = 0.0; at < length + profile.spacing; at += profile.spacing) {
    profile.log_strength.push_back(scatter.block_strength * share * now);
    now = memory * now + std::sqrt(1 - memory * memory) * normal_of(draws.next());
  }
  return profile;
}

}  // namespace

simulation::Overrun drawn(const simulation::Model& model, const simulation::Overrun& centre, const Scatter& scatter,
                          const std::array<double, scattered_inputs>& u, std::uint64_t seed) {
  auto run = centre;
  const auto& plane = model.aircraft;
  double wheelbase = 0.0;
  for (const auto& gear : plane.gears) wheelbase = std::max(wheelbase, gear.behind_nose_gear);
  run.mass = (centre.mass > 0 ? centre.mass : plane.mass) * (1 + scatter.mass * normal_of(u[0]));
  run.cg_behind_nose_gear = (centre.cg_behind_nose_gear > 0 ? centre.cg_behind_nose_gear : plane.cg_behind_nose_gear) +
                            scatter.cg * wheelbase * normal_of(u[1]);
  run.braking = scatter.braking_low + u[2] * (scatter.braking_high - scatter.braking_low);
  // A case that says what holds inside the bed keeps the ratio.
  if (centre.braking_in_bed >= 0)
    run.braking_in_bed =
        centre.braking > 0 ? run.braking * centre.braking_in_bed / centre.braking : centre.braking_in_bed;
  const double temperature = scatter.temperature + scatter.temperature_scatter * normal_of(u[5]);
  const double years = scatter.years_low + u[6] * (scatter.years_high - scatter.years_low);
  run.alterations.bed_strength *= (1 + scatter.strength * normal_of(u[3])) *
                                  (1 - scatter.per_kelvin * (temperature - 293.15)) * (1 - scatter.per_year * years);
  run.bed_depth *= 1 + scatter.depth * normal_of(u[4]);
  if (scatter.block_strength > 0)
    for (std::size_t g = 0; g < plane.gears.size(); ++g) {
      // Tires of a group run over different blocks: what they feel together scatters less.
      const double share = 1.0 / std::sqrt(std::max(1, plane.gears[g].struts));
      run.alterations.strength.push_back(block_strengths(scatter, model.bed.length(), share, seed * 1000003u + g));
    }
  return run;
}

}  // namespace apc::reliability
