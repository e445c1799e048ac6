#include "apc/learning/segments.h"

#include <algorithm>
#include <cmath>

namespace apc::learning {
namespace {

using Kind = Feature::Kind;

constexpr double segment_length = 8.0;               // m, about two blocks at the least
constexpr std::size_t fewest = 2, most_in_bed = 10;  // segments in the bed
constexpr double before_bed = 0.9;                   // s on the pavement; a simulated run has one

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

}  // namespace apc::learning
