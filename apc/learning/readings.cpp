#include "apc/learning/readings.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "apc/base/units.h"

namespace apc::learning {
namespace {

constexpr double window = 0.1;

struct Mean {
  double value = 0.0, time = 0.0;
  int samples = 0;
};
Mean mean_of(const Channel& c, double from, double to) {
  Mean m;
  auto i = static_cast<std::size_t>(std::lower_bound(c.time.begin(), c.time.end(), from) - c.time.begin());
  for (; i < c.time.size() && c.time[i] < to; ++i) m.value += c.value[i], m.time += c.time[i], ++m.samples;
  if (m.samples > 0) m.value /= m.samples, m.time /= m.samples;
  return m;
}

/// Running integral of an acceleration, 0 at sample `zero`.
std::vector<double> integral(const Eigen::VectorXd& rate, double interval, std::size_t zero) {
  std::vector<double> sum(static_cast<std::size_t>(rate.size()), 0.0);
  const auto step = [&](std::size_t i) {
    return 0.5 * interval * (rate[static_cast<Eigen::Index>(i)] + rate[static_cast<Eigen::Index>(i) - 1]);
  };
  for (std::size_t i = zero + 1; i < sum.size(); ++i) sum[i] = sum[i - 1] + step(i);
  for (std::size_t i = zero; i > 0; --i) sum[i - 1] = sum[i] - step(i);
  return sum;
}

}  // namespace

double mean_delay(const Run& run, const Reading& r) {
  return r.is_stop() ? 0.0 : mean_lag * run.channels[r.channel].lag;
}

std::vector<Reading> readings_of(const Case& data, const std::vector<GearFacts>& gears, const Run& run,
                                 const Motion& m) {
  double full = 0.0;
  while (full < data.bed.length() && data.bed.depth_at(full) < 0.99 * data.bed.maximum_depth()) full += 0.25;
  for (const GearFacts& g : gears)
    if (!g.nose) full += g.behind;
  std::vector<Reading> list;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    const Quantity q = channel.quantity;
    const bool vertical = q == Quantity::acceleration_z || q == Quantity::pitch_rate;
    if (!vertical && q != Quantity::speed && q != Quantity::acceleration_x) continue;
    for (double from = m.time.front(); from + window <= m.time.back(); from += window) {
      if (vertical && m.at(m.place, from) < full) continue;
      const Mean here = mean_of(channel, from, from + window);
      if (here.samples == 0) continue;
      const double noise = channel.noise / std::sqrt(here.samples);
      if (q != Quantity::pitch_rate) {
        list.push_back({c, q, here.time - 0.5 * window, here.time + 0.5 * window, here.value, noise});
        continue;
      }
      const Mean next = mean_of(channel, from + window, from + 2.0 * window);
      if (next.samples > 0 && from + 2.0 * window <= m.time.back())
        list.push_back(
            {c, q, from + 0.5 * window, from + 1.5 * window, next.value - here.value, std::sqrt(2.0) * noise});
    }
  }
  if (run.stop) list.push_back({Reading::no_channel, Quantity::nose_distance, 0.0, 0.0, *run.stop, run.stop_noise});
  return list;
}

Eigen::VectorXd read_off(const std::vector<Reading>& list, const Run& run, const Motion& m, const Balance& b,
                         double entry_speed) {
  std::size_t entry = 0;
  while (entry + 1 < m.size() && m.time[entry] < 0.0) ++entry;
  std::vector<double> speed = integral(b.along, m.interval, entry), turning = integral(b.pitching, m.interval, 0);
  std::vector<double> forward(m.size()), up(m.size());
  double way = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    speed[i] += entry_speed;
    forward[i] = b.along[k] + units::g0 * m.pitch[i];
    up[i] = b.up[k];
    if (i > entry) way += 0.5 * m.interval * (speed[i] + speed[i - 1]);
  }
  way += speed.back() * speed.back() / (2.0 * std::max(1.0, -b.along[b.along.size() - 1]));
  Eigen::VectorXd h(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Reading& r = list[i];
    const double delay = mean_delay(run, r);
    const auto mean = [&](const std::function<double(double)>& at) {
      double sum = 0.0;
      for (int k = 0; k < 5; ++k) sum += 0.2 * at(r.from + (r.to - r.from) * (k + 0.5) / 5.0 - delay);
      return sum;
    };
    double& value = h[static_cast<Eigen::Index>(i)];
    if (r.is_stop())
      value = way;
    else if (r.quantity == Quantity::speed)
      value = mean([&](double t) { return m.at(speed, t); });
    else if (r.quantity == Quantity::acceleration_x)
      value = mean([&](double t) { return m.at(forward, t); });
    else if (r.quantity == Quantity::pitch_rate)
      value = m.at(turning, r.to - delay) - m.at(turning, r.from - delay);
    else
      value = mean([&](double t) {
        const double place = std::clamp((t - m.time.front()) / m.interval, 0.0, static_cast<double>(m.size() - 1));
        return m.at(up, t) + run.channels[r.channel].lever_arm * b.pitching[static_cast<Eigen::Index>(place)];
      });
  }
  return h;
}

}  // namespace apc::learning
