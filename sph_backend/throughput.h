/// Throughput of the solver on this processor: foam at rest and the paper's tire rolling, beside the arithmetic limit
/// that the same instruction set reaches in a loop of multiply-adds.
#pragma once

#include <string>

namespace apc::sph {

struct Throughput {
  std::string instruction_set;
  double rest = 0.0;          ///< particle-steps/s, intact foam, 24 in × 36 in × 225 in at 2 in
  double rolling = 0.0;       ///< particle-steps/s of a whole rolling run, everything in
  double flops = 0.0;         ///< executed per particle-step at rest (pairs in the list, kernel support or not)
  double useful_flops = 0.0;  ///< of those, on pairs within the support
  double bytes = 0.0;         ///< read and written per particle-step: records of the neighbours, list, state
  double peak = 0.0;          ///< flop/s of one thread in multiply-adds
  double bytes_per_particle = 0.0;
  double fraction() const { return rest * flops / peak; }
};

/// Takes about ten seconds on an idle core; `threads` share the foam block at rest.
Throughput measure_throughput(unsigned threads = 1);

/// A block of intact foam stepped `steps` times: particle-steps/s.
double foam_at_rest(unsigned threads, int steps);

}  // namespace apc::sph
