#include "apc/simulation/rut_log.h"

#include <algorithm>
#include <cmath>

namespace apc::simulation {

void RutLog::write(double distance, const Rut& rut) {
  if (!entries_.empty() && distance < entries_.back().distance + 1e-3) return;
  entries_.push_back({distance, {rut.depth, rut.penetration, rut.drag, rut.vertical}, {}});
  const std::size_t n = entries_.size();
  if (n < 2) return;
  auto &last = entries_[n - 1], &middle = entries_[n - 2];
  const double h1 = last.distance - middle.distance;
  for (int k = 0; k < 4; ++k) {
    const double after = (last.value[k] - middle.value[k]) / h1;
    last.slope[k] = after;
    if (n == 2) {
      middle.slope[k] = after;
    } else {  // of the parabola through three points; the middle one still holds the secant before it
      const double h0 = middle.distance - entries_[n - 3].distance;
      middle.slope[k] = (middle.slope[k] * h1 + after * h0) / (h0 + h1);
    }
  }
}

double RutLog::last_distance() const { return entries_.empty() ? -1e300 : entries_.back().distance; }

void RutLog::clear() { entries_.clear(); }

Rut RutLog::at(double distance) const {
  if (entries_.size() < 2 || distance <= entries_.front().distance) return {};
  if (distance >= entries_.back().distance) {
    const double* v = entries_.back().value;
    return {v[0], v[1], v[2], v[3]};
  }
  std::size_t i = entries_.size() - 2;  // a row reads a bogie's spacing behind what was written last
  while (entries_[i].distance > distance) --i;
  const Entry &a = entries_[i], &b = entries_[i + 1];
  const double h = b.distance - a.distance, per_h = 1.0 / h, t = (distance - a.distance) * per_h, r = 1.0 - t;
  const double w0 = r * r * (1.0 + 2.0 * t), w1 = t * t * (3.0 - 2.0 * t), w2 = h * t * r * r, w3 = -h * t * t * r;
  const double s0 = -6.0 * t * r * per_h, s2 = r * (1.0 - 3.0 * t), s3 = t * (3.0 * t - 2.0);
  double value[4], slope[4];
  for (int k = 0; k < 4; ++k) {
    value[k] = (a.value[k] * w0 + b.value[k] * w1) + (a.slope[k] * w2 + b.slope[k] * w3);
    slope[k] = (a.value[k] - b.value[k]) * s0 + (a.slope[k] * s2 + b.slope[k] * s3);
  }
  return {value[0], value[1], value[2], value[3], slope[0], slope[1], slope[3]};
}

}  // namespace apc::simulation
