#include "apc/learning/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace apc::learning {
namespace {

/// Distance of the nose wheel at measured times: from the measured speed itself, so that places are the data's own.
double place_of(const effects::Guide& guide, double time) {
  double way = 0.0;
  constexpr double step = 0.02;
  for (double t = 0.0; t < time; t += step) way += guide.speed_at(t) * std::min(step, time - t);
  return way;
}

double at(const std::vector<double>& x, const std::vector<double>& y, double place) {
  const auto after = std::upper_bound(x.begin(), x.end(), place);
  if (after == x.begin()) return y.front();
  if (after == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(after - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (place - x[i - 1]) / std::max(1e-9, x[i] - x[i - 1]);
}

}  // namespace

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
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < n; ++i) {
      m.push_back(channel.value[i]), p.push_back(predicted[rows.channel_start[c] + static_cast<Eigen::Index>(i)]);
      e.mean += (p.back() - m.back()) / static_cast<double>(n);
      e.rms += std::pow(p.back() - m.back(), 2) / static_cast<double>(n);
      e.coverage += (std::abs(p.back() - m.back()) < 2.0 * channel.noise ? 1.0 : 0.0) / static_cast<double>(n);
      low = std::min(low, m.back()), high = std::max(high, m.back());
    }
    e.rms = std::sqrt(e.rms);
    e.sprague_geers = sprague_geers(m, p);
    const double s = std::max(channel.noise, 0.02 * (high - low));
    if (guide) {
      const Signal signal(trace.result.history, channel, data.aircraft);
      const auto& h = trace.result.history;
      double sum = 0.0;
      int count = 0;
      for (std::size_t i = 0; i < n; i += std::max<std::size_t>(1, n / 200)) {
        if (channel.time[i] < 0.0) continue;
        const double place = place_of(*guide, channel.time[i]);
        ++count;
        if (place > h.distance.back()) {
          sum += 25.0;
          continue;
        }
        sum += std::min(400.0, std::pow((channel.value[i] - signal(at(h.distance, h.time, place))) / s, 2));
      }
      e.normalised = count > 0 ? std::sqrt(sum / count) : 0.0;
    } else {
      e.normalised = e.rms / s;
    }
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
    total += std::min(400.0, std::pow(stop.error / std::max(0.3, 0.02 * *run.stop), 2));
    ++counted;
  }
  error.total = counted > 0 ? std::sqrt(total / counted) : 0.0;
  return error;
}

}  // namespace apc::learning
