/// Effects weighed on free runs. Along the measured motion an effect is weighed where everything unknown is free and
/// small effects show; but an effect that acts like an error of the tables hides there. Whether it mends the runs that
/// a designer would simulate is asked here, and both answers count.
#pragma once

#include <map>

#include "apc/learning/background.h"
#include "apc/learning/free_fit.h"

namespace apc::learning {

/// One set of effects fitted to free runs, and its log evidence over none.
struct FreeSet {
  FreeFit fit;
  double log_evidence = 0.0;
};

struct FreeEvidence {
  FreeRuns runs;
  FreeFit none;
  std::map<std::vector<std::string>, FreeSet> sets;  ///< by sorted ids

  /// Log evidence of a set: its own where it was fitted, else the best of its members'. Never below 0: free runs are
  /// too coarse to speak against an effect. Joints are not seen by them.
  double of(const std::vector<std::string>& ids) const;
};

/// All effects in the linear model around the best strength; those that promise most are fitted. Null where free runs
/// cannot be simulated or no run tells anything. The case must outlive the result.
std::optional<FreeEvidence> weigh_free(const Case&, const std::vector<effects::Effect>&, unsigned threads,
                                       const Report&);

/// Fits two effects together, from their own fits where they have one. Pairs with joints are left out.
void add_pair(FreeEvidence&, const std::vector<effects::Applied>&);

/// Whether a law knows a run by the bed's age or temperature.
bool known_by_date(const effects::Effect&);

}  // namespace apc::learning
