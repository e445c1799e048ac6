#include "apc/learning/simulated_swing.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

/// What changes faster is the axle's, not the aircraft's.
constexpr double window = 0.1;

/// Means over the window around each time of the motion; ends held.
std::vector<double> averaged(const std::vector<double>& time, const std::vector<double>& value, const Motion& m) {
  std::vector<double> mean(m.size());
  std::size_t from = 0, to = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    while (to < time.size() && time[to] <= m.time[i] + 0.5 * window) sum += value[to++];
    while (from < to && time[from] < m.time[i] - 0.5 * window) sum -= value[from++];
    mean[i] = to > from ? sum / static_cast<double>(to - from) : value[std::min(to, value.size() - 1)];
  }
  return mean;
}

/// Of the nominal model led along the measured speed, its response to sinking that of `sinking` rigid wheels; null
/// where it cannot be run.
std::optional<simulation::History> led_history(const Case& data, const Layout& layout, std::size_t r, double sinking) {
  const Run& run = data.runs[r];
  Eigen::VectorXd eta = prior_mean(layout, data.runs);
  eta[layout.sinking] = sinking - 1.0;
  try {
    return simulate_run(data, layout, r, run, eta, {}, make_guide(run, layout.runs[r], eta)).result.history;
  } catch (const SolveError&) {
    return std::nullopt;
  }
}

}  // namespace

bool swing_unknown(const Run& run) { return !run.find(Quantity::acceleration_z) || !run.find(Quantity::pitch_rate); }

void lead_swing(const Case& data, const Layout& layout, std::size_t r, double sinking, Motion& m) {
  const auto h = led_history(data, layout, r, sinking);
  if (!h) return;
  m.led.rise = averaged(h->time, h->acceleration_z, m), m.led.pitch_rate = averaged(h->time, h->pitch_rate, m);
  for (std::size_t g = 0; g < h->gears.size(); ++g)
    if (data.aircraft.gears[g].is_nose()) m.led.nose = averaged(h->time, h->gears[g].vertical, m);
}

void simulate_swing(const Case& data, const Layout& layout, const std::vector<GearFacts>& gears, std::size_t r,
                    double sinking, Motion& m) {
  const auto h = led_history(data, layout, r, sinking);
  if (!h) return;
  const Share share = share_of(gears);
  for (std::size_t g = 0; g < gears.size(); ++g) {
    if (gears[g].nose) continue;
    const std::vector<double> load = averaged(h->time, h->gears[g].vertical, m);
    const double least = least_load(gears[g], share, data.runs[r]);
    for (std::size_t i = 0; i < m.size(); ++i) {
      m.swing[g][i] = swing_believed * (load[i] - m.steady[g][i]);
      m.carried[g][i] = std::max(least, m.steady[g][i] + m.swing[g][i]);
    }
  }
}

}  // namespace apc::learning
