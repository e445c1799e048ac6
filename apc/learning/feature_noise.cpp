#include "apc/learning/feature_noise.h"

#include <algorithm>
#include <cmath>

#include "apc/learning/mean_of_scatter.h"

namespace apc::learning {
namespace {

using Kind = Feature::Kind;

constexpr double exit_noise = 0.5;  // m/s, of a speed read where the bed ends

double samples_per_second(const Channel& c) {
  if (c.time.size() > 2) return static_cast<double>(c.time.size() - 1) / std::max(1e-3, c.time.back() - c.time.front());
  return c.quantity == Quantity::speed ? 10.0 : 100.0;
}

/// Mean over two stretches of equal or different length of exp(−|distance| / memory): variance of a mean when the two
/// are the same.
double mean_kernel(double a0, double a1, double b0, double b1, double memory) {
  const double x = (a1 - a0) / memory, y = (b1 - b0) / memory;
  if (x < 1e-6 || y < 1e-6) return std::exp(-std::abs(0.5 * (a0 + a1 - b0 - b1)) / memory);
  if (a0 == b0 && a1 == b1) return mean_of_scatter(x);
  const double apart = std::max(0.0, std::max(a0, b0) - std::min(a1, b1)) / memory;
  return std::exp(-apart) * (1.0 - std::exp(-x)) / x * (1.0 - std::exp(-y)) / y;
}

bool is_force(const Feature& f, const Run& run) {
  return f.kind == Kind::slowing ||
         (f.kind == Kind::mean && run.channels[f.channel].quantity == Quantity::acceleration_x);
}

bool of_nose(const Feature& f, const Run& run) {
  if (f.kind == Kind::nose_rut) return true;
  if (f.kind != Kind::mean) return false;
  const Quantity q = run.channels[f.channel].quantity;
  return q == Quantity::nose_drag || q == Quantity::nose_vertical || q == Quantity::nose_stroke;
}

}  // namespace

Eigen::MatrixXd delayed_features(const Run& run, const Segments& s, const Trace& trace, const Eigen::VectorXd& value) {
  const simulation::History& h = trace.result.history;
  const auto m = static_cast<Eigen::Index>(s.features.size()),
             channels = static_cast<Eigen::Index>(run.channels.size());
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(m, channels + 1);
  const double entry = run.overrun.entry_speed;
  const auto middle = [&](std::size_t i) { return 0.5 * (s.edge[i] + s.edge[i + 1]); };
  for (Eigen::Index k = 0; k < m; ++k) {
    const Feature& f = s.features[static_cast<std::size_t>(k)];
    if (f.kind != Kind::slowing && f.kind != Kind::mean) continue;
    // Slope along the way, from the segments before and behind.
    Eigen::Index before = k, behind = k;
    for (const Eigen::Index other : {k - 1, k + 1}) {
      if (other < 0 || other >= m) continue;
      const Feature& next = s.features[static_cast<std::size_t>(other)];
      if (next.kind == f.kind && next.channel == f.channel) (other < k ? before : behind) = other;
    }
    if (before == behind) continue;
    const double slope =
        (value[behind] - value[before]) / (middle(s.features[static_cast<std::size_t>(behind)].segment) -
                                           middle(s.features[static_cast<std::size_t>(before)].segment));
    const double place = middle(f.segment),
                 speed = place > h.distance.back() ? 0.0 : at_place(h.distance, h.speed, place);
    for (Eigen::Index c = 0; c < channels; ++c)
      if (run.channels[static_cast<std::size_t>(c)].quantity == Quantity::speed)
        change(k, c) = -slope * (f.kind == Kind::slowing ? entry : entry - speed);
    if (f.kind == Kind::mean) change(k, static_cast<Eigen::Index>(f.channel)) -= slope * speed;
    change(k, channels) = -slope * entry;
  }
  return change;
}

Eigen::MatrixXd feature_noise(const Run& run, const Segments& s, const Trace& trace, const Eigen::VectorXd& value,
                              const Eigen::VectorXd& by_strength, const SegmentErrors& errors) {
  const simulation::History& h = trace.result.history;
  const auto n = static_cast<Eigen::Index>(s.count()), m = static_cast<Eigen::Index>(s.features.size());
  std::vector<double> when, speed;
  for (const double place : s.edge)
    when.push_back(at_place(h.distance, h.time, place)),
        speed.push_back(place > h.distance.back() ? 0.0 : at_place(h.distance, h.speed, place));
  // Change of each segment's deceleration with strength, for errors that reach the stop: of the speed where there is
  // one, else the whole run's.
  const double mean_slowing = std::max(0.5, trace.result.mean_deceleration);
  Eigen::VectorXd force = Eigen::VectorXd::Constant(n, mean_slowing), force_by_strength = force;
  force[0] = force_by_strength[0] = 0.0;
  for (Eigen::Index k = 0; k < m; ++k) {
    const Feature& f = s.features[static_cast<std::size_t>(k)];
    if (f.kind == Kind::stop && by_strength[k] != 0.0)
      for (Eigen::Index i = 1; i < n; ++i)
        force_by_strength[i] = -by_strength[k] * mean_slowing / std::max(1.0, s.edge.back());
  }
  for (Eigen::Index k = 0; k < m; ++k) {
    const Feature& f = s.features[static_cast<std::size_t>(k)];
    if (is_force(f, run) && f.segment > 0) {
      const double sign = f.kind == Kind::slowing ? 1.0 : -1.0;
      force[static_cast<Eigen::Index>(f.segment)] = std::abs(value[k]);
      force_by_strength[static_cast<Eigen::Index>(f.segment)] = sign * by_strength[k];
    }
  }
  // Latent errors per segment: of the force (model), of the blocks under main and nose gear, of the nose's load.
  Eigen::MatrixXd latent = Eigen::MatrixXd::Zero(4 * n, 4 * n), reads = Eigen::MatrixXd::Zero(m, 4 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double in_time = mean_kernel(when[a], when[a + 1], when[b], when[b + 1], errors.memory),
                   in_place = errors.block_strength * errors.block_strength *
                              mean_kernel(s.edge[a], s.edge[a + 1], s.edge[b], s.edge[b + 1], errors.correlation);
      latent(i, j) = errors.drag * errors.drag * in_time;
      latent(n + i, n + j) = in_place * 0.5 * (1.0 + errors.lateral);
      latent(2 * n + i, 2 * n + j) = in_place;
      latent(n + i, 2 * n + j) = latent(2 * n + j, n + i) = in_place * errors.lateral;
      latent(3 * n + i, 3 * n + j) = errors.nose_drag * errors.nose_drag * in_time;
    }
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(m, m);
  Eigen::MatrixXd edges = Eigen::MatrixXd::Zero(m, n + 1);  // error of ½v² at every edge
  for (Eigen::Index k = 0; k < m; ++k) {
    const Feature& f = s.features[static_cast<std::size_t>(k)];
    const auto i = static_cast<Eigen::Index>(f.segment);
    const double seconds = std::max(0.01, when[f.segment + 1] - when[f.segment]);
    if (is_force(f, run)) {
      const double sign = f.kind == Kind::slowing ? 1.0 : -1.0;
      reads(k, i) = sign * force[i], reads(k, n + i) = sign * force_by_strength[i];
    } else if (f.kind == Kind::stop || f.kind == Kind::exit) {
      const double gain = f.kind == Kind::stop ? 1.0 / mean_slowing : 1.0 / std::max(2.0, std::abs(value[k]));
      for (Eigen::Index j = 1; j < n; ++j) {
        const double way = s.length(static_cast<std::size_t>(j)) / rolled_share;
        reads(k, j) = -gain * way * force[j], reads(k, n + j) = -gain * way * force_by_strength[j];
      }
    } else {
      reads(k, of_nose(f, run) ? 2 * n + i : n + i) = by_strength[k];
      if (of_nose(f, run) && f.kind == Kind::mean) reads(k, 3 * n + i) = value[k];
    }
    switch (f.kind) {
      case Kind::slowing: {
        const Channel& c = run.channels[f.channel];
        const double samples = std::max(1.0, 2.0 * edge_window * samples_per_second(c));
        for (const Eigen::Index e : {i, i + 1})
          edges(k, e) = (e == i ? 1.0 : -1.0) * speed[static_cast<std::size_t>(e)] * c.noise / std::sqrt(samples) /
                        s.length(f.segment);
        break;
      }
      case Kind::mean: {
        const Channel& c = run.channels[f.channel];
        noise(k, k) += c.noise * c.noise / std::max(1.0, seconds * samples_per_second(c));
        break;
      }
      case Kind::nose_rut:
      case Kind::main_rut: {
        const double readings = std::max(1.0, s.length(f.segment) / 0.5);
        noise(k, k) += errors.rut * errors.rut + run.survey->noise * run.survey->noise / readings;
        break;
      }
      case Kind::stop:
        noise(k, k) += run.stop_noise * run.stop_noise;
        break;
      case Kind::exit:
        noise(k, k) += exit_noise * exit_noise;
        break;
    }
  }
  // A bias or a wrong scale is one error of all means of its channel.
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    Eigen::VectorXd bias = Eigen::VectorXd::Zero(m), scale = bias;
    for (Eigen::Index k = 0; k < m; ++k) {
      const Feature& f = s.features[static_cast<std::size_t>(k)];
      if (f.channel != c || (f.kind != Kind::mean && f.kind != Kind::slowing)) continue;
      if (f.kind == Kind::mean) bias[k] = run.channels[c].bias;
      if (f.kind == Kind::slowing)
        bias[k] = run.channels[c].bias * (speed[f.segment] - speed[f.segment + 1]) / s.length(f.segment);
      scale[k] = run.channels[c].scale * value[k] * (f.kind == Kind::slowing ? 2.0 : 1.0);
    }
    noise += bias * bias.transpose() + scale * scale.transpose();
  }
  Eigen::MatrixXd late = delayed_features(run, s, trace, value);
  for (std::size_t c = 0; c < run.channels.size(); ++c)
    late.col(static_cast<Eigen::Index>(c)) *= lag_deviation * run.channels[c].lag;
  late.rightCols(1) *= run.uncertainty.clock;
  noise += edges * edges.transpose() + reads * latent * reads.transpose() + late * late.transpose();
  noise.diagonal().array() += 1e-12;
  return noise;
}

}  // namespace apc::learning
