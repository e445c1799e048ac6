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

struct HeldOut {
  std::vector<LeftOut> runs;
  double before = 0.0, after = 0.0;  ///< root mean square over the runs
  /// By how much the error must fall before effects are said to help: half a dozen runs do not tell less from luck.
  double least_fall = 0.03;
  bool helps() const { return !runs.empty() && after < (1.0 - least_fall) * before; }
};

/// Empty where there are fewer than two runs that can be left out. Runs that cannot be simulated are passed over.
HeldOut leave_one_out(const FreeRuns&, const std::vector<effects::Applied>&, double strength);

}  // namespace apc::learning
