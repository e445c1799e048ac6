/// What if: every combination of aircraft, bed, exit speed, mass, braking and bed strength, each a full overrun, on all
/// cores. Finished cases go to a store at once, so an interrupted sweep continues where it was. The order of the
/// results is the order of the cases, whatever the number of threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apc/study/solve.h"
#include "apc/study/store.h"

namespace apc::study {

/// One combination. `model` is an index into the models of the sweep (one per aircraft and bed).
struct Case {
  std::size_t model = 0;
  simulation::Overrun overrun;  ///< the bed's strength is `overrun.alterations.bed_strength`
};

struct CaseResult {
  Case input;
  simulation::Result result;  ///< without history
  std::string failure;        ///< the solver's words when it gave up; then `result` means nothing
};

/// Values of each axis; every list has at least one value.
struct Axes {
  std::vector<double> speeds;          ///< m/s
  std::vector<double> mass_factors;    ///< × the mass of the aircraft's file
  std::vector<double> masses;          ///< kg; instead of the factors when not empty
  std::vector<double> brakings;        ///< friction coefficients
  std::vector<double> strengths{1.0};  ///< × nominal
  double braking_in_bed = -1.0;        ///< < 0: as before the bed
};

/// All combinations, speeds running fastest.
std::vector<Case> combinations(const std::vector<simulation::Model>&, const Axes&);

struct SweepOptions {
  simulation::Options solver{simulation::Method::fast, 1e-6, 0.0, 120.0};
  unsigned threads = 0;                                ///< 0 = all
  std::function<void(std::size_t finished)> finished;  ///< told after every case, from any thread
};

/// Runs what the store does not have yet. A solver that gives up makes that case a failure, never the sweep. Throws
/// Interrupted when the user asks to stop; what was finished is in the store.
std::vector<CaseResult> run(const std::vector<simulation::Model>&, const std::vector<Case>&, const Solve&, Store&,
                            const SweepOptions& = {});

/// The smallest limit/peak − 1 over gears and loads; `ultimate` judges drag by the ultimate load and vertical load by
/// 1.5 × its limit. NaN when no limit is known.
enum class Criterion { limit, ultimate };
const char* text(Criterion);
double worst_margin(const simulation::Result&, Criterion);

}  // namespace apc::study
