/// What scatters from one overrun to the next, and how much. Every input is drawn from its own distribution,
/// independent of the others, through a number u uniform in (0, 1).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/json.h"
#include "apc/simulation/simulate.h"

namespace apc::reliability {

/// Standard deviations are of normal distributions cut at ±3; ranges are uniform.
struct Scatter {
  std::string source = "estimates of this project";
  double mass = 0.03;                             ///< relative
  double cg = 0.01;                               ///< share of the wheelbase
  double braking_low = 0.0, braking_high = 0.25;  ///< friction coefficient of the braked wheels, before and in the bed
  double strength = 0.04;                         ///< relative, of the bed as a whole
  double depth = 0.02;                            ///< relative, as built
  double block_strength = 0.08;                   ///< of the logarithm, from block to block
  double correlation = 2.4;                       ///< m, along the runway, exponential
  double temperature = 288.15, temperature_scatter = 12.0;  ///< K
  double per_kelvin = 0.0005;                               ///< loss of strength above 20 °C
  double years_low = 0.0, years_high = 20.0;                ///< age of the bed
  double per_year = 0.0015;                                 ///< loss of strength: 3 % over 20 years
};

/// Throws InputError: file, path, value, remedy.
Scatter load_scatter(const std::filesystem::path&);
Scatter read_scatter(const Json&);

inline constexpr std::size_t scattered_inputs = 7;
/// "mass", "centre of gravity", "braking", "bed strength", "bed depth", "temperature", "age", in the order of `u`.
const std::array<const char*, scattered_inputs>& scattered_names();

/// An overrun drawn by `u`; `seed` draws the blocks' own strengths.
simulation::Overrun drawn(const simulation::Model&, const simulation::Overrun& centre, const Scatter&,
                          const std::array<double, scattered_inputs>& u, std::uint64_t seed);

/// Standard normal number of a uniform one, cut at ±3 (Acklam's rational approximation, error below 1.2e-9).
double normal_of(double u);

/// Latin hypercube: `count` points, each input's strata visited once. The same seed gives the same points.
std::vector<std::array<double, scattered_inputs>> latin_hypercube(std::size_t count, std::uint64_t seed);

/// Uniform numbers (0, 1) from a counter: SplitMix64 (Steele, Lea & Flood 2014).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  double next();

 private:
  std::uint64_t state_;
};

}  // namespace apc::reliability
