#include "apc/learning/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apc/learning/free_run.h"

namespace apc::learning {

SpragueGeers sprague_geers(const std::vector<double>& measured, const std::vector<double>& computed) {
  double mm = 0.0, cc = 0.0, mc = 0.0;
  for (std::size_t i = 0; i < std::min(measured.size(), computed.size()); ++i)
    mm += measured[i] * measured[i], cc += computed[i] * computed[i], mc += measured[i] * computed[i];
  SpragueGeers result;
  if (mm <= 0.0 || cc <= 0.0) return result;
  result.magnitude = std::sqrt(cc / mm) - 1.0;
  result.phase = std::acos(std::clamp(mc / std::sqrt(mm * cc), -1.0, 1.0)) / std::numbers::pi;
  result.combined = std::hypot(result.magnitude, result.phase);
  return result;
}

RunError compare(const Case& data, const Layout& layout, std::size_t r, const Run& run, const Eigen::VectorXd& eta,
                 const std::vector<effects::Applied>& added) {
  RunError error;
  error.run = run.id;
  const Rows rows = make_rows(run, data);
  const Trace trace = simulate_run(data, layout, r, run, eta, added);
  const Eigen::VectorXd predicted = predict(run, rows, trace, layout.runs[r], eta, data.aircraft);
  const auto guide = make_guide(run, layout.runs[r], eta);
  double total = 0.0;
  int counted = 0;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    const std::size_t n = rows.samples[c];
    if (n == 0) continue;
    ChannelError e;
    e.quantity = channel.quantity;
    std::vector<double> m, p;
    for (std::size_t i = 0; i < n; ++i) {
      m.push_back(channel.value[i]), p.push_back(predicted[rows.channel_start[c] + static_cast<Eigen::Index>(i)]);
      e.mean += (p.back() - m.back()) / static_cast<double>(n);
      e.rms += std::pow(p.back() - m.back(), 2) / static_cast<double>(n);
      e.coverage += (std::abs(p.back() - m.back()) < 2.0 * channel.noise ? 1.0 : 0.0) / static_cast<double>(n);
    }
    e.rms = std::sqrt(e.rms);
    e.sprague_geers = sprague_geers(m, p);
    const Eigen::VectorXd misfit = series_misfit(run, free_series(run, c, n, guide.get()), trace, data.aircraft);
    e.normalised = misfit.size() > 0 ? misfit.norm() / std::sqrt(static_cast<double>(misfit.size())) : 0.0;
    if (e.quantity == Quantity::speed || e.quantity == Quantity::acceleration_x)
      total += e.normalised * e.normalised, ++counted;
    error.channels.push_back(e);
  }
  if (run.stop) {
    Comparison stop;
    stop.error = trace.stop - *run.stop;
    // Stop distance goes with the square of the speed and, nearly, with the mass.
    const double input = *run.stop * std::hypot(2.0 * run.uncertainty.entry_speed / run.overrun.entry_speed,
                                                run.uncertainty.mass / run.overrun.mass);
    stop.uncertainty = std::hypot(run.stop_noise, input);
    error.stop = stop;
    total += std::pow(stop_misfit(run, trace), 2);
    ++counted;
  }
  error.total = counted > 0 ? std::sqrt(total / counted) : 0.0;
  return error;
}

}  // namespace apc::learning
