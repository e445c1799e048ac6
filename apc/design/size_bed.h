/// Sizes a bed: the shortest, the one of smallest volume, the one fairest to all aircraft, or the one that takes the
/// highest speeds in a given length, within every limit of the fleet's file.
#pragma once

#include <optional>

#include "apc/design/blocks.h"
#include "apc/design/certificate.h"

namespace apc::design {

/// A bed of one depth behind the longest ramp: what a designer would draw without an optimiser.
struct Uniform {
  bool feasible = false;
  double depth = 0.0, length = 0.0;  ///< m; deepest one within the limits, and the longest stop in it
  Constraint limiting;               ///< the load limit that forbids a deeper one
};

/// What one case gets in the built bed.
struct CaseOutcome {
  std::size_t fleet_case = 0;
  double stop_distance = 0.0;   ///< m, from the speed asked for
  double max_exit_speed = 0.0;  ///< m/s: stops within the bed and every load limit kept
  double arrest_speed = 0.0;    ///< m/s: stops within the bed, whatever the loads
  double use = 0.0;             ///< of its most used load limit
  Constraint active;            ///< that limit, or the stop when that is nearer to its limit
};

struct Design {
  bool feasible = false;
  std::string reason;                  ///< when not feasible: one sentence that names what forbids it
  std::vector<Constraint> forbidding;  ///< the constraints that exclude one another
  Objective objective = Objective::length;
  Uniform uniform;
  Profile profile;            ///< the optimum before rounding
  double length = 0.0;        ///< m, of the optimum
  double speed_factor = 1.0;  ///< × the speeds of the fleet's cases (objective speed)
  std::vector<double> alone;  ///< m per case: shortest bed for that case alone (objective minimax)
  Certificate certificate;
  Built built;
  std::vector<CaseOutcome> cases;
  long runs = 0, gave_up = 0;
};

struct SizeOptions {
  Objective objective = Objective::length;
  double length = 0.0;  ///< m, given (objective speed); 0 = the fleet's maximum_length
  OptimiserOptions optimiser;
};

/// Never throws for a fleet that cannot be satisfied: that is a Design with `feasible` false. Interrupted on ^C, with
/// every finished overrun in the store.
Design size_bed(const Problem&, study::Store&, const SizeOptions& = {});

/// The parts, for studies of their own.
Uniform uniform_bed(Evaluator&, const std::vector<std::size_t>& cases);
Certificate best_bed(Evaluator&, const Aim&, const Profile& start, double extra, const OptimiserOptions&);

}  // namespace apc::design
