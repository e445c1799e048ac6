#include "apc/learning/readings.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"

namespace apc::learning {
namespace {

constexpr double window = 0.1;   ///< s
constexpr double stretch = 2.0;  ///< m of a surveyed rut

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
  return r.kind == Reading::Kind::signal ? mean_lag * run.channels[r.channel].lag : 0.0;
}

std::vector<Reading> readings_of(const Case& data, const std::vector<GearFacts>& gears, const Run& run,
                                 const Motion& m) {
  using Kind = Reading::Kind;
  std::vector<Reading> list;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    const Quantity q = channel.quantity;
    if (q != Quantity::speed && q != Quantity::acceleration_x) continue;
    for (double from = m.time.front(); from + window <= m.time.back(); from += window) {
      const Mean here = mean_of(channel, from, from + window);
      if (here.samples > 0)
        list.push_back({Kind::signal, c, q, 0, here.time - 0.5 * window, here.time + 0.5 * window, here.value,
                        channel.noise / std::sqrt(here.samples)});
    }
  }
  if (run.stop) list.push_back({Kind::stop, 0, Quantity::nose_distance, 0, 0.0, 0.0, *run.stop, run.stop_noise});
  if (!run.survey) return list;
  for (std::size_t g = 0; g < gears.size(); ++g) {
    const auto& rut = gears[g].nose ? run.survey->nose_rut : run.survey->main_rut;
    const double last = std::min(data.bed.length(), m.place.back() - gears[g].behind - 1.0);
    for (double from = 0.0; from + stretch <= last; from += stretch) {
      double sum = 0.0;
      int samples = 0;
      for (std::size_t i = 0; i < rut.size(); ++i) {
        const double s = run.survey->distance[i];
        if (s >= from && s < from + stretch && std::isfinite(rut[i])) sum += rut[i], ++samples;
      }
      if (samples > 0)
        list.push_back({Kind::rut, 0, Quantity::nose_distance, g, from, from + stretch, sum / samples,
                        run.survey->noise / std::sqrt(samples)});
    }
  }
  return list;
}

Eigen::VectorXd read_off(const std::vector<Reading>& list, const std::vector<GearFacts>& gears, const Run& run,
                         const Motion& m, const Balance& b, double entry_speed) {
  std::size_t entry = 0;
  while (entry + 1 < m.size() && m.time[entry] < 0.0) ++entry;
  std::vector<double> speed = integral(b.along, m.interval, entry), forward(m.size());
  double way = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    speed[i] += entry_speed;
    forward[i] = b.along[static_cast<Eigen::Index>(i)] + units::g0 * m.pitch[i];
    if (i > entry) way += 0.5 * m.interval * (speed[i] + speed[i - 1]);
  }
  way += speed.back() * speed.back() / (2.0 * std::max(1.0, -b.along[b.along.size() - 1]));
  Eigen::VectorXd h(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Reading& r = list[i];
    double& value = h[static_cast<Eigen::Index>(i)];
    if (r.kind == Reading::Kind::stop) {
      value = way;
      continue;
    }
    constexpr int points = 5;
    const double delay = mean_delay(run, r);
    value = 0.0;
    for (int k = 0; k < points; ++k) {
      const double at = r.from + (r.to - r.from) * (k + 0.5) / points;
      value += (r.kind == Reading::Kind::rut    ? at_place(m.place, b.rut[r.gear], at + gears[r.gear].behind)
                : r.quantity == Quantity::speed ? m.at(speed, at - delay)
                                                : m.at(forward, at - delay)) /
               points;
    }
  }
  return h;
}

}  // namespace apc::learning
