/// Probability that a bed arrests an overrun, and that it does so without damage. For each sample of everything that
/// scatters but the exit speed, the critical speed is found (one to four overruns instead of hit or miss); the exit
/// speed's distribution is then integrated in closed form:
///
///   P(arrest) = E[F_V(v_arrest)],   P(no damage) = E[F_V(v_intact)]
///
/// Samples come in ten independent Latin hypercubes; their spread gives the 95 % interval (Student's t, 9 degrees).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "apc/reliability/chaos.h"
#include "apc/reliability/scatter.h"
#include "apc/study/critical_speed.h"

namespace apc::reliability {

/// Weibull distribution of exit speeds, 1 − exp(−(v/scale)^shape), through two points. The default goes through 50 % at
/// 40 kt (industry briefing, 2011) and 90 % at 70 kt (FAA AC 150/5220-22).
struct ExitSpeeds {
  double scale = 24.41, shape = 2.1454;  ///< m/s
  double below(double speed) const;
};

struct ReliabilityInput {
  simulation::Model model;  ///< with the bed as built
  simulation::Overrun centre;
  double asked_speed = 0.0;  ///< m/s the bed was designed for
  study::Use use;
  Scatter scatter;
  ExitSpeeds exit_speeds;
};

struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;  ///< 95 % interval
};

struct Reliability {
  std::size_t samples = 0, gave_up = 0;
  long runs = 0;                                              ///< of all samples, those of earlier starts included
  Estimate arrest, intact;                                    ///< of an overrun with random exit speed
  Estimate arrest_at_asked, intact_at_asked;                  ///< of one at the speed the bed was designed for
  double arrest_speed_975 = 0.0, intact_speed_975 = 0.0;      ///< m/s: 97.5 % of the samples handle at least this
  std::vector<double> arrest_speeds, intact_speeds;           ///< sorted, one per sample
  std::vector<SobolIndex> arrest_indices, intact_indices;     ///< of the critical speeds, per scattered input
  double arrest_unexplained = 0.0, intact_unexplained = 0.0;  ///< block scatter and higher orders
};

/// Overruns of one model, one result each; empty where the solver gave up. Called from several threads.
using SolveMany = std::function<std::vector<std::optional<simulation::Result>>(
    const simulation::Model&, const std::vector<simulation::Overrun>&, const simulation::Options&)>;

/// One after the other; for closed forms in place of the solver.
SolveMany one_by_one(study::Solve);
/// simulation::simulate_each on one thread: the same bits, several at once.
SolveMany side_by_side();

struct ReliabilityOptions {
  std::size_t samples = 1000;  ///< rounded up to a multiple of 10; at least 200
  std::uint64_t seed = 1;
  /// m/s, of each critical speed. An error of 0.1 m/s moves one sample's probability by 0.0035 at most, and the
  /// samples' errors are independent.
  double arrest_tolerance = 0.1, intact_tolerance = 0.15;
  simulation::Options solver{simulation::Method::fast, 1e-5, 0.0, 120.0};
  unsigned threads = 0;
  std::function<void(std::size_t finished)> finished;
};

/// Finished samples go to the store in batches; what is there is not computed again. Interrupted on ^C. InputError when
/// the solver gives up on so many samples that nothing can be said.
Reliability assess(const ReliabilityInput&, const SolveMany&, study::Store&, const ReliabilityOptions& = {});

}  // namespace apc::reliability
