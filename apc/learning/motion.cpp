#include "apc/learning/motion.h"

#include <algorithm>
#include <cmath>

namespace apc::learning {
namespace {

double linear(const std::vector<double>& values, double place) {
  if (place <= 0.0) return values.front();
  const auto last = static_cast<double>(values.size() - 1);
  if (place >= last) return values.back();
  const auto i = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * values[i] + u * values[i + 1];
}

/// Nose distance from the speed: 0 when the time is 0.
std::vector<double> way(const Motion& m) {
  std::vector<double> x(m.size(), 0.0);
  std::size_t entry = 0;
  while (entry + 1 < m.size() && m.time[entry] < 0.0) ++entry;
  x[entry] = m.time[entry] * m.speed[entry];
  for (std::size_t i = entry + 1; i < m.size(); ++i) x[i] = x[i - 1] + 0.5 * (m.speed[i] + m.speed[i - 1]) * m.interval;
  for (std::size_t i = entry; i-- > 0;) x[i] = x[i + 1] - m.speed[i] * m.interval;
  return x;
}

/// From the pitch channel, or the pitch rate less what it reads before the bed.
std::vector<double> pitch_of(const Run& run, const Motion& m) {
  const double first = m.time.front() - 0.1, last = m.time.back() + 0.3;
  std::vector<double> pitch(m.size(), 0.0);
  if (const Channel* c = run.find(Quantity::pitch)) {
    const Smooth s = smooth(c->time, c->value, first, last, 0.05, std::max(1e-4, c->noise), 0.5);
    for (std::size_t i = 0; i < m.size(); ++i) pitch[i] = s.at(m.time[i] + mean_lag * c->lag);
    return pitch;
  }
  const Channel* c = run.find(Quantity::pitch_rate);
  if (!c) return pitch;
  const Smooth s = smooth(c->time, c->value, first, last, 0.05, c->noise, 5.0);
  double before = 0.0;
  int count = 0;
  for (const double t : m.time)
    if (t < 0.0) before += s.at(t + mean_lag * c->lag), ++count;
  before = count > 20 ? before / count : 0.0;
  for (std::size_t i = 1; i < m.size(); ++i)
    pitch[i] = pitch[i - 1] + m.interval * (s.at(m.time[i] + mean_lag * c->lag) - before);
  return pitch;
}

}  // namespace

double Motion::at(const std::vector<double>& quantity, double when) const {
  return linear(quantity, (when - time.front()) / interval);
}

double Smooth::at(double x) const {
  const double place = std::clamp((x - first) / interval, 0.0, static_cast<double>(value.size() - 1) - 1e-9);
  const auto i = static_cast<Eigen::Index>(place);
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * value[i] + u * value[i + 1];
}

Smooth smooth(const std::vector<double>& x, const std::vector<double>& y, double first, double last, double interval,
              double noise, double curvature) {
  const auto n = static_cast<Eigen::Index>((last - first) / interval) + 3;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const double weight = 1.0 / (noise * noise);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double place = (x[i] - first) / interval;
    if (!std::isfinite(y[i]) || place < 0.0 || place >= static_cast<double>(n - 1)) continue;
    const auto k = static_cast<Eigen::Index>(place);
    const double u = place - static_cast<double>(k), part[2] = {1.0 - u, u};
    for (int a = 0; a < 2; ++a) {
      right[k + a] += weight * part[a] * y[i];
      for (int b = 0; b < 2; ++b) normal(k + a, k + b) += weight * part[a] * part[b];
    }
  }
  const double stiff = 1.0 / std::pow(curvature * std::pow(interval, 1.5), 2);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const double d[3] = {1.0, -2.0, 1.0};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) normal(k - 1 + a, k - 1 + b) += stiff * d[a] * d[b];
  }
  normal.diagonal().array() += 1e-9 * normal.diagonal().mean();
  return {first, interval, normal.ldlt().solve(right)};
}

std::optional<Motion> measured_motion(const Case& data, const Layout& layout, std::size_t r) {
  const Run& run = data.runs[r];
  const Channel* speed = run.find(Quantity::speed);
  if (!speed) return std::nullopt;
  const auto guide = make_guide(run, layout.runs[r], prior_mean(layout, data.runs));
  if (!guide) return std::nullopt;

  Motion m;
  const Rows rows = make_rows(run, data);
  const auto channel = static_cast<std::size_t>(speed - run.channels.data());
  const double from = std::max(speed->time.front(), -2.0),
               to = speed->time[rows.samples[channel] - 1] - mean_lag * speed->lag;
  for (double t = from; t <= to; t += m.interval) {
    m.time.push_back(t);
    m.speed.push_back(t < 0.0 ? guide->speed.front() : guide->speed_at(t));
  }
  if (m.size() < 50) return std::nullopt;
  m.place = way(m);
  m.pitch = pitch_of(run, m);
  return m;
}

}  // namespace apc::learning
