#include "apc/learning/run_level.h"

#include <algorithm>
#include <cmath>

#include "apc/learning/entry_speed.h"
#include "apc/learning/layout.h"
#include "apc/learning/mean_of_scatter.h"

namespace apc::learning {

double level_deviation(const Run& run, double bed_length, double block_strength, double correlation) {
  const Scatter usual;
  const double way = std::min(run.stop.value_or(bed_length), bed_length);
  const double blocks = block_strength * block_strength * 0.5 * (1.0 + usual.lateral) *
                        mean_of_scatter(way / std::max(1e-6, correlation));
  const EntrySpeed entry = entry_speed(run);
  return std::sqrt(usual.run_to_run * usual.run_to_run + blocks + std::pow(run.uncertainty.mass / run.overrun.mass, 2) +
                   std::pow(2.0 * entry.deviation / entry.value, 2));
}

}  // namespace apc::learning
