#include "apc/learning/simulated_swing.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

/// What changes faster is the axle's, not the aircraft's.
constexpr double window = 0.15;

/// Means over the window around each time of the motion.
std::vector<double> averaged(const std::vector<double>& time, const std::vector<double>& value, const Motion& m) {
  std::vector<double> mean(m.size());
  std::size_t from = 0, to = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    while (to < time.size() && time[to] <= m.time[i] + 0.5 * window) sum += value[to++];
    while (from < to && time[from] < m.time[i] - 0.5 * window) sum -= value[from++];
    mean[i] = to > from ? sum / static_cast<double>(to - from) : std::nan("");
  }
  return mean;
}

}  // namespace

bool swing_unknown(const Run& run) { return !run.find(Quantity::acceleration_z) || !run.find(Quantity::pitch_rate); }

void simulate_swing(const Case& data, const Layout& layout, const std::vector<GearFacts>& gears, std::size_t r,
                    double sinking, Motion& m) {
  const Run& run = data.runs[r];
  Eigen::VectorXd eta = prior_mean(layout, data.runs);
  eta[layout.sinking] = sinking - 1.0;
  simulation::History h;
  try {
    h = simulate_run(data, layout, r, run, eta, {}, make_guide(run, layout.runs[r], eta)).result.history;
  } catch (const SolveError&) {
    return;
  }
  const Share share = share_of(gears);
  for (std::size_t g = 0; g < gears.size(); ++g) {
    if (gears[g].nose) continue;
    const std::vector<double> load = averaged(h.time, h.gears[g].vertical, m);
    const double least =
        least_share * gears[g].wheels * share.static_load(gears[g], run.overrun.mass, run.overrun.cg_behind_nose_gear);
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (!std::isfinite(load[i])) continue;
      m.swing[g][i] = swing_believed * (load[i] - m.steady[g][i]);
      m.carried[g][i] = std::max(least, m.steady[g][i] + m.swing[g][i]);
    }
  }
}

}  // namespace apc::learning
