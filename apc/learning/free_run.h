/// Free runs of a model against measured ones. The error of a run is that of metrics.h, kept as a vector whose squared
/// length is the square of the error.
#pragma once

#include "apc/learning/forward.h"

namespace apc::learning {

/// Samples of one channel, up to two hundred of them, at the places where they were taken.
struct FreeSeries {
  std::size_t channel = 0;
  bool by_place = false;
  std::vector<double> place, value;  ///< m from the leading edge; times, s, where no speed was recorded
  double scale = 1.0;                ///< larger of the noise and 2 % of the range
};
/// Its first `count` samples, those before entry left out; places by the guide where there is one.
FreeSeries free_series(const Run&, std::size_t channel, std::size_t count, const effects::Guide*);

/// (measured − simulated) / scale, one number per sample. A single sample counts at most 20², a place that the run does
/// not reach 5².
Eigen::VectorXd series_misfit(const Run&, const FreeSeries&, const Trace&, const aircraft::Aircraft&);

/// Error of the stop over the larger of 0.3 m and 2 % of the way; at most 20.
double stop_misfit(const Run&, const Trace&);

/// What of a run is compared in a free run.
struct FreeSamples {
  std::vector<FreeSeries> series;  ///< speed and acceleration_x
  Eigen::Index size = 0;           ///< of the misfit: all samples, and the stop
};
FreeSamples free_samples(const Run&, const Case&, const RunLayout&, const Eigen::VectorXd& eta);

/// Misfits of series and stop, weighted so that the squared length is the mean over the channels (the stop is one) of
/// the mean square.
Eigen::VectorXd free_misfit(const Run&, const FreeSamples&, const Trace&, const aircraft::Aircraft&);

/// The runs of a case at which its model may be held. The case must outlive it.
struct FreeRuns {
  const Case* data = nullptr;
  Layout layout;
  Eigen::VectorXd eta;  ///< the nominal model, entry speeds as recorded and signal tell them together
  std::vector<FreeSamples> samples;
  std::vector<double> level_deviation;  ///< per run, as run_level.h says
  unsigned threads = 0;
};
FreeRuns free_runs(const Case&, unsigned threads);

/// Misfits of all runs at this strength (logarithm, over the data sheet's; plus the run's own of `levels` if given)
/// with effects; empty for runs that tell nothing or where `use` (if given) is false. SolveError when a run cannot be
/// simulated.
std::vector<Eigen::VectorXd> free_misfits(const FreeRuns&, double strength, const std::vector<effects::Applied>&,
                                          const std::vector<char>& use = {}, const std::vector<double>& levels = {});

}  // namespace apc::learning
