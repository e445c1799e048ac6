/// Does an effect help? Every run is left out in turn: strength and amplitudes are fitted to the others, and the run is
/// predicted with and without the effects.
#pragma once

#include "apc/learning/free_fit.h"
#include "apc/learning/metrics.h"

namespace apc::learning {

struct LeftOut {
  std::string run;
  RunError before, after;  ///< of the prediction, without and with effects
  /// ln of the ratio of likelihoods of the run, with over without effects, at the scale of the errors of each.
  double gain = 0.0;
};

/// Between runs of one bed, ln (error without / error with an effect) scatters by so much (pooled over cases with known
/// truth).
inline constexpr double scatter_of_help = 0.68;

struct HeldOut {
  std::vector<LeftOut> runs;
  double before = 0.0, after = 0.0;  ///< geometric mean over the runs; a run's error below 1, its own uncertainty, is 1
  /// By which share the error must fall before effects are said to help: by one standard error of the mean over the
  /// runs, 1 − exp(−scatter / √n), scatter being these runs' own where it is the larger one. Six runs: 24 %; two: 38 %.
  double least_fall() const;
  bool helps() const { return !runs.empty() && after < (1.0 - least_fall()) * before; }
};

/// With the means of its runs. Geometric ones, as it is the logarithms that scatter alike from run to run: in a mean of
/// squares an effect that ruins one good run is paid for by another's large error.
HeldOut held_out_of(std::vector<LeftOut>);

/// Empty where there are fewer than two runs that can be left out. Runs that cannot be simulated are passed over.
HeldOut leave_one_out(const FreeRuns&, const std::vector<effects::Applied>&, double strength);

}  // namespace apc::learning
