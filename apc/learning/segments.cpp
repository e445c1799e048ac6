#include "apc/learning/segments.h"

#include <algorithm>
#include <cmath>

namespace apc::learning {
namespace {

using Kind = Feature::Kind;

constexpr double segment_length = 8.0;               // m, about two blocks at the least
constexpr std::size_t fewest = 2, most_in_bed = 10;  // segments in the bed
constexpr double before_bed = 0.9;                   // s on the pavement; a simulated run has one
constexpr double edge_window = 0.3;                  // s to either side for the speed at an edge
constexpr double rolled_share = 0.9;  // of the way; the rest is rolled at walking speed, below the tables
constexpr double exit_noise = 0.5;    // m/s, of a speed read where the bed ends

double samples_per_second(const Channel& c) {
  if (c.time.size() > 2) return static_cast<double>(c.time.size() - 1) / std::max(1e-3, c.time.back() - c.time.front());
  return c.quantity == Quantity::speed ? 10.0 : 100.0;
}

/// Speed at a time: straight line through the samples around it; NaN with fewer than three.
double speed_at(const Channel& c, double when) {
  double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
  for (std::size_t i = 0; i < c.time.size(); ++i) {
    const double d = c.time[i] - when;
    if (std::abs(d) > edge_window) continue;
    n += 1.0, t += d, v += c.value[i], tt += d * d, tv += d * c.value[i];
  }
  const double spread = n * tt - t * t;
  return n < 3.0 || spread <= 0.0 ? std::nan("") : (v * tt - t * tv) / spread;
}

/// Times at which the nose wheel passes the edges, by the measured speed.
std::vector<double> passages(const Channel& speed, const std::vector<double>& edge) {
  std::vector<double> time, place;
  double way = 0.0, offset = 0.0;
  for (std::size_t i = 0; i < speed.time.size(); ++i) {
    const double t = speed.time[i] - mean_lag * speed.lag;
    if (i > 0) way += 0.5 * (speed.value[i] + speed.value[i - 1]) * (t - time.back());
    time.push_back(t), place.push_back(way);
  }
  offset = at_place(time, place, 0.0);
  for (double& s : place) s -= offset;
  std::vector<double> result;
  for (const double s : edge)
    result.push_back(s < place.front() || s > place.back() ? std::nan("") : at_place(place, time, s));
  return result;
}

double mean_in(const Channel& c, double from, double to) {
  double sum = 0.0;
  int count = 0;
  const double delay = mean_lag * c.lag;
  for (std::size_t i = 0; i < c.time.size(); ++i)
    if (c.time[i] - delay >= from && c.time[i] - delay < to) sum += c.value[i], ++count;
  return count > 0 ? sum / count : std::nan("");
}

double mean_rut(const std::vector<double>& place, const std::vector<double>& rut, double from, double to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] >= from && place[i] < to && std::isfinite(rut[i])) sum += rut[i], ++count;
  return count > 0 ? sum / count : std::nan("");
}

/// Mean over two stretches of equal or different length of exp(−|distance| / memory): variance of a mean when the two
/// are the same.
double mean_kernel(double a0, double a1, double b0, double b1, double memory) {
  const double x = (a1 - a0) / memory, y = (b1 - b0) / memory;
  if (x < 1e-6 || y < 1e-6) return std::exp(-std::abs(0.5 * (a0 + a1 - b0 - b1)) / memory);
  if (a0 == b0 && a1 == b1) return 2.0 * (x - 1.0 + std::exp(-x)) / (x * x);
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

Segments make_segments(const Run& run, double way) {
  Segments s;
  const std::size_t n = std::clamp(static_cast<std::size_t>(std::max(0.0, way / segment_length)), fewest, most_in_bed);
  s.edge.push_back(-before_bed * run.overrun.entry_speed);
  for (std::size_t i = 0; i <= n; ++i)
    s.edge.push_back(rolled_share * way * static_cast<double>(i) / static_cast<double>(n));
  if (run.find(Quantity::speed))
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const Quantity q = run.channels[c].quantity;
      const bool speed = q == Quantity::speed;
      if (!speed && q != Quantity::acceleration_x && q != Quantity::nose_drag && q != Quantity::nose_vertical &&
          q != Quantity::nose_stroke && q != Quantity::main_stroke && q != Quantity::pitch)
        continue;
      // Drag gauges read the wheels' spin-up at the edge, and less than a second of speed says no slope.
      for (std::size_t i = q == Quantity::acceleration_x ? 0 : 1; i < s.count(); ++i)
        s.features.push_back({speed ? Kind::slowing : Kind::mean, c, i});
    }
  if (run.survey)
    for (const Kind kind : {Kind::nose_rut, Kind::main_rut})
      for (std::size_t i = 1; i < s.count(); ++i) s.features.push_back({kind, 0, i});
  if (run.stop)
    s.features.push_back({Kind::stop, 0, 0});
  else if (run.exit_speed)
    s.features.push_back({Kind::exit, 0, 0});
  return s;
}

Eigen::VectorXd measured_features(const Run& run, const Segments& s) {
  std::vector<double> when;
  const Channel* speed = run.find(Quantity::speed);
  if (speed && speed->time.size() > 2) when = passages(*speed, s.edge);
  Eigen::VectorXd value(static_cast<Eigen::Index>(s.features.size()));
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const Feature& f = s.features[k];
    double v = std::nan("");
    const bool passed = !when.empty() && std::isfinite(when[f.segment]) && std::isfinite(when[f.segment + 1]);
    switch (f.kind) {
      case Kind::slowing:
        if (passed) {
          const Channel& c = run.channels[f.channel];
          const double delay = mean_lag * c.lag, first = speed_at(c, when[f.segment] + delay),
                       last = speed_at(c, when[f.segment + 1] + delay);
          v = (first * first - last * last) / (2.0 * s.length(f.segment));
        }
        break;
      case Kind::mean:
        if (passed) v = mean_in(run.channels[f.channel], when[f.segment], when[f.segment + 1]);
        break;
      case Kind::nose_rut:
      case Kind::main_rut:
        if (run.survey)
          v = mean_rut(run.survey->distance, f.kind == Kind::nose_rut ? run.survey->nose_rut : run.survey->main_rut,
                       s.edge[f.segment], s.edge[f.segment + 1]);
        break;
      case Kind::stop:
        v = run.stop.value_or(std::nan(""));
        break;
      case Kind::exit:
        v = run.exit_speed.value_or(std::nan(""));
        break;
    }
    value[static_cast<Eigen::Index>(k)] = v;
  }
  return value;
}

Eigen::VectorXd simulated_features(const Run& run, const Segments& s, const Trace& trace,
                                   const aircraft::Aircraft& craft) {
  const simulation::History& h = trace.result.history;
  std::vector<Signal> signals;
  for (const Channel& c : run.channels) signals.emplace_back(h, c, craft);
  std::size_t nose = 0, main = 0;
  for (std::size_t g = 0; g < craft.gears.size(); ++g) (craft.gears[g].is_nose() ? nose : main) = g;
  Eigen::VectorXd value(static_cast<Eigen::Index>(s.features.size()));
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const Feature& f = s.features[k];
    double v = 0.0;
    const double a = s.edge[f.segment], b = s.edge[f.segment + 1];
    switch (f.kind) {
      case Kind::slowing: {
        // A run that stops short of an edge is at rest there.
        const auto speed = [&](double place) {
          return place > h.distance.back() ? 0.0 : at_place(h.distance, h.speed, place);
        };
        v = (speed(a) * speed(a) - speed(b) * speed(b)) / (2.0 * (b - a));
        break;
      }
      case Kind::mean: {
        const double from = at_place(h.distance, h.time, a), to = at_place(h.distance, h.time, b);
        constexpr int points = 40;
        for (int i = 0; i < points; ++i) v += signals[f.channel](from + (to - from) * (i + 0.5) / points) / points;
        break;
      }
      case Kind::nose_rut:
      case Kind::main_rut: {
        const auto& gear = h.gears[f.kind == Kind::nose_rut ? nose : main];
        constexpr int points = 12;
        for (int i = 0; i < points; ++i)
          v += at_place(gear.distance, gear.rut, a + (b - a) * (i + 0.5) / points) / points;
        break;
      }
      case Kind::stop:
        v = trace.stop;
        break;
      case Kind::exit:
        v = trace.exit_speed;
        break;
    }
    value[static_cast<Eigen::Index>(k)] = v;
  }
  return value;
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
  noise += edges * edges.transpose() + reads * latent * reads.transpose();
  noise.diagonal().array() += 1e-12;
  return noise;
}

}  // namespace apc::learning
