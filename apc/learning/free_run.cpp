#include "apc/learning/free_run.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/learning/entry_speed.h"
#include "apc/learning/run_level.h"

namespace apc::learning {
namespace {

/// A single sample counts at most so much, and a place that the run does not reach (as scores of predictions do).
constexpr double largest = 20.0, not_reached = 5.0;
constexpr std::size_t most_samples = 200;

}  // namespace

FreeSeries free_series(const Run& run, std::size_t c, std::size_t count, const effects::Guide* guide) {
  const Channel& channel = run.channels[c];
  FreeSeries series;
  series.channel = c, series.by_place = guide != nullptr;
  const auto end = channel.value.begin() + static_cast<std::ptrdiff_t>(count);
  if (count == 0) return series;
  const auto [low, high] = std::minmax_element(channel.value.begin(), end);
  series.scale = std::max(channel.noise, 0.02 * (*high - *low));
  double way = 0.0, since = 0.0;
  constexpr double step = 0.02;
  for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, count / most_samples)) {
    const double time = channel.time[i];
    if (time < 0.0) continue;
    if (guide)
      for (; since < time; since += step) way += guide->speed_at(since) * std::min(step, time - since);
    since = guide ? time : 0.0;
    series.place.push_back(guide ? way : time), series.value.push_back(channel.value[i]);
  }
  return series;
}

Eigen::VectorXd series_misfit(const Run& run, const FreeSeries& s, const Trace& trace,
                              const aircraft::Aircraft& craft) {
  const simulation::History& h = trace.result.history;
  const Signal signal(h, run.channels[s.channel], craft);
  Eigen::VectorXd misfit(static_cast<Eigen::Index>(s.place.size()));
  for (std::size_t i = 0; i < s.place.size(); ++i) {
    const bool reached = !s.by_place || s.place[i] <= h.distance.back();
    const double time = s.by_place ? at_place(h.distance, h.time, s.place[i]) : s.place[i];
    misfit[static_cast<Eigen::Index>(i)] =
        reached ? std::clamp((s.value[i] - signal(time)) / s.scale, -largest, largest) : not_reached;
  }
  return misfit;
}

double stop_misfit(const Run& run, const Trace& trace) {
  return std::clamp((*run.stop - trace.stop) / std::max(0.3, 0.02 * *run.stop), -largest, largest);
}

FreeSamples free_samples(const Run& run, const Case& data, const RunLayout& at, const Eigen::VectorXd& eta) {
  FreeSamples samples;
  const Rows rows = make_rows(run, data);
  const auto guide = make_guide(run, at, eta);
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Quantity quantity = run.channels[c].quantity;
    if (quantity != Quantity::speed && quantity != Quantity::acceleration_x) continue;
    FreeSeries one = free_series(run, c, rows.samples[c], guide.get());
    if (one.place.empty()) continue;
    samples.size += static_cast<Eigen::Index>(one.place.size());
    samples.series.push_back(std::move(one));
  }
  if (run.stop) ++samples.size;
  return samples;
}

Eigen::VectorXd free_misfit(const Run& run, const FreeSamples& samples, const Trace& trace,
                            const aircraft::Aircraft& craft) {
  Eigen::VectorXd misfit(samples.size);
  const double channels = static_cast<double>(samples.series.size()) + (run.stop ? 1.0 : 0.0);
  Eigen::Index next = 0;
  for (const FreeSeries& s : samples.series) {
    const auto n = static_cast<Eigen::Index>(s.place.size());
    misfit.segment(next, n) =
        series_misfit(run, s, trace, craft) / std::sqrt(channels * static_cast<double>(s.place.size()));
    next += n;
  }
  if (run.stop) misfit[next] = stop_misfit(run, trace) / std::sqrt(channels);
  return misfit;
}

FreeRuns free_runs(const Case& data, unsigned threads) {
  FreeRuns f;
  f.data = &data, f.threads = threads;
  f.layout = make_layout(data, data.runs);
  f.eta = prior_mean(f.layout, data.runs);
  for (std::size_t r = 0; r < data.runs.size(); ++r)
    f.eta[f.layout.runs[r].entry_speed] = entry_speed(data.runs[r]).value - data.runs[r].overrun.entry_speed;
  for (std::size_t r = 0; r < data.runs.size(); ++r)
    f.samples.push_back(free_samples(data.runs[r], data, f.layout.runs[r], f.eta));
  for (const Run& run : data.runs)
    f.level_deviation.push_back(level_deviation(run, data.bed.length(), data.block_strength, data.correlation));
  return f;
}

std::vector<Eigen::VectorXd> free_misfits(const FreeRuns& f, double strength,
                                          const std::vector<effects::Applied>& effects, const std::vector<char>& use,
                                          const std::vector<double>& levels) {
  std::vector<Eigen::VectorXd> misfits(f.samples.size());
  parallel_for(f.samples.size(), f.threads, [&](std::size_t r) {
    if ((!use.empty() && !use[r]) || f.samples[r].size == 0) return;
    Eigen::VectorXd eta = f.eta;
    eta[f.layout.bed_strength] = strength + (levels.empty() ? 0.0 : levels[r]);
    misfits[r] = free_misfit(f.data->runs[r], f.samples[r],
                             simulate_run(*f.data, f.layout, r, f.data->runs[r], eta, effects), f.data->aircraft);
  });
  return misfits;
}

}  // namespace apc::learning
