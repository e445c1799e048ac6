/// Critical speeds of many samples, found side by side: every round makes one overrun of each sample that still needs
/// one, so that a solver that carries several overruns at once has work.
#pragma once

#include "apc/reliability/reliability.h"

namespace apc::reliability {

struct Sample {
  std::array<double, scattered_inputs> u{};
  std::uint64_t blocks = 0;           ///< seed of the blocks' strengths
  double arrest = 0.0, intact = 0.0;  ///< m/s: stops in the bed; and every load within its limit on the way; ≤ arrest
  int runs = 0;
  bool finished = false, good = false;  ///< not good: the solver gave up on it
  /// What the search saw, for the expectations of later samples: exponents of stop distance and of use over speed, and
  /// ln(use) at the arrested speed.
  double stop_exponent = 0.0, use_exponent = 0.0, use_at_arrest = 0.0;
};

/// Where searches begin and how ratios grow with speed.
struct Expectation {
  std::function<double(const Sample&)> arrest;  ///< m/s
  std::function<double(const Sample&)> intact;  ///< m/s, from a sample that knows its arrested speed and use
  double stop_exponent = 2.0, use_exponent = 0.3;
};

/// Finds both speeds of `samples[i]`, i in `which`; the model's bed is continued beyond its end at its last depth.
void find_critical_speeds(const ReliabilityInput&, const simulation::Model& endless, const SolveMany&,
                          const ReliabilityOptions&, const Expectation&, std::vector<Sample>& samples,
                          const std::vector<std::size_t>& which);

}  // namespace apc::reliability
