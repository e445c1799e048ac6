#include "apc/simulation/rut_log.h"

#include <algorithm>
#include <cmath>

namespace apc::simulation {
namespace {

/// Slope at the middle of three points, by the parabola through them.
double slope(double before, double after, double x0, double x1, double x2) {
  const double h0 = x1 - x0, h1 = x2 - x1;
  return (before * h1 + after * h0) / (h0 + h1);
}

}  // namespace

void RutLog::write(double distance, const Rut& rut) {
  if (!distance_.empty() && distance < distance_.back() + 1e-3) return;
  distance_.push_back(distance);
  ruts_.push_back(rut);
}

double RutLog::last_distance() const { return distance_.empty() ? -1e300 : distance_.back(); }

void RutLog::clear() {
  distance_.clear();
  ruts_.clear();
}

Rut RutLog::at(double distance) const {
  if (distance_.size() < 2 || distance <= distance_.front()) return {};
  if (distance >= distance_.back()) return ruts_.back();
  const auto above = std::upper_bound(distance_.begin(), distance_.end(), distance);
  const auto i = static_cast<std::size_t>(above - distance_.begin()) - 1;
  const double h = distance_[i + 1] - distance_[i], t = (distance - distance_[i]) / h, r = 1.0 - t;
  const auto secant = [&](std::size_t k, double Rut::*field) {
    return (ruts_[k + 1].*field - ruts_[k].*field) / (distance_[k + 1] - distance_[k]);
  };
  const auto end_slope = [&](std::size_t k, double Rut::*field) {  // at point k
    if (k == 0) return secant(0, field);
    if (k + 1 == ruts_.size()) return secant(k - 1, field);
    return slope(secant(k - 1, field), secant(k, field), distance_[k - 1], distance_[k], distance_[k + 1]);
  };
  Rut rut;
  for (const auto field : {&Rut::depth, &Rut::penetration, &Rut::drag, &Rut::vertical}) {
    const double y0 = ruts_[i].*field, y1 = ruts_[i + 1].*field, d0 = end_slope(i, field), d1 = end_slope(i + 1, field);
    rut.*field = y0 * r * r * (1 + 2 * t) + y1 * t * t * (3 - 2 * t) + h * t * r * (d0 * r - d1 * t);
    if (field == &Rut::depth) rut.depth_slope = 6 * t * r * (y1 - y0) / h + d0 * r * (1 - 3 * t) + d1 * t * (3 * t - 2);
  }
  return rut;
}

}  // namespace apc::simulation
