#include "apc/base/curve.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc {
namespace {

void check(const std::vector<double>& x, const std::vector<double>& y) {
  require(x.size() == y.size(), "a curve has ", x.size(), " abscissas and ", y.size(), " values");
  require(x.size() >= 2, "a curve needs at least two points");
  for (std::size_t i = 1; i < x.size(); ++i)
    require(x[i] > x[i - 1], "a curve's abscissas must increase, but ", x[i], " follows ", x[i - 1]);
}

std::size_t interval(const std::vector<double>& x, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  return static_cast<std::size_t>(above - x.begin()) - 1;
}

}  // namespace

LinearCurve::LinearCurve(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  check(x_, y_);
}

double LinearCurve::operator()(double at) const {
  const double clamped = std::clamp(at, x_.front(), x_.back());
  const auto i = interval(x_, clamped);
  return y_[i] + (y_[i + 1] - y_[i]) * (clamped - x_[i]) / (x_[i + 1] - x_[i]);
}

double LinearCurve::slope(double at) const {
  if (at < x_.front() || at > x_.back()) return 0.0;
  const auto i = interval(x_, at);
  return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
}

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  check(x_, y_);
  const std::size_t n = x_.size();
  std::vector<double> h(n - 1), secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) h[i] = x_[i + 1] - x_[i], secant[i] = (y_[i + 1] - y_[i]) / h[i];
  slope_.assign(n, 0.0);
  if (n == 2) {
    slope_[0] = slope_[1] = secant[0];
    return;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (secant[i - 1] * secant[i] <= 0.0) continue;
    const double before = 2.0 * h[i] + h[i - 1], after = h[i] + 2.0 * h[i - 1];
    slope_[i] = (before + after) / (before / secant[i - 1] + after / secant[i]);
  }
  // Three-point end slopes, limited so that the first and last pieces stay monotone.
  const auto end = [](double h0, double h1, double s0, double s1) {
    const double slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
    if (slope * s0 <= 0.0) return 0.0;
    return (s0 * s1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(s0)) ? 3.0 * s0 : slope;
  };
  slope_[0] = end(h[0], h[1], secant[0], secant[1]);
  slope_[n - 1] = end(h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
}

double MonotoneCurve::operator()(double at) const {
  if (at <= x_.front()) return y_.front() + slope_.front() * (at - x_.front());
  if (at >= x_.back()) return y_.back() + slope_.back() * (at - x_.back());
  const auto i = interval(x_, at);
  const double h = x_[i + 1] - x_[i], t = (at - x_[i]) / h, r = 1.0 - t;
  return y_[i] * r * r * (1 + 2 * t) + y_[i + 1] * t * t * (3 - 2 * t) +
         h * t * r * (slope_[i] * r - slope_[i + 1] * t);
}

double MonotoneCurve::slope(double at) const {
  if (at <= x_.front()) return slope_.front();
  if (at >= x_.back()) return slope_.back();
  const auto i = interval(x_, at);
  const double h = x_[i + 1] - x_[i], t = (at - x_[i]) / h;
  return 6 * t * (1 - t) * (y_[i + 1] - y_[i]) / h + slope_[i] * (1 - t) * (1 - 3 * t) +
         slope_[i + 1] * t * (3 * t - 2);
}

double MonotoneCurve::integral(double at) const {
  double sum = 0.0;
  if (at <= x_.front()) {
    const double d = at - x_.front();
    return d * (y_.front() + 0.5 * slope_.front() * d);
  }
  for (std::size_t i = 0; i + 1 < x_.size() && x_[i] < at; ++i) {
    const double h = x_[i + 1] - x_[i], t = std::min(1.0, (at - x_[i]) / h);
    const double t2 = t * t, t3 = t2 * t, t4 = t3 * t;
    sum += h * (y_[i] * (t - t3 + 0.5 * t4) + y_[i + 1] * (t3 - 0.5 * t4)) +
           h * h * (slope_[i] * (0.5 * t2 - 2.0 / 3.0 * t3 + 0.25 * t4) + slope_[i + 1] * (0.25 * t4 - t3 / 3.0));
  }
  if (at > x_.back()) {
    const double d = at - x_.back();
    sum += d * (y_.back() + 0.5 * slope_.back() * d);
  }
  return sum;
}

double MonotoneCurve::inverse(double value) const {
  if (value <= y_.front()) return x_.front() + (slope_.front() > 0 ? (value - y_.front()) / slope_.front() : 0.0);
  if (value >= y_.back()) return x_.back() + (slope_.back() > 0 ? (value - y_.back()) / slope_.back() : 0.0);
  const auto i = static_cast<std::size_t>(std::upper_bound(y_.begin() + 1, y_.end() - 1, value) - y_.begin()) - 1;
  double low = x_[i], high = x_[i + 1];
  for (int step = 0; step < 60 && high - low > 1e-15 * (std::abs(high) + 1.0); ++step) {
    const double middle = 0.5 * (low + high);
    ((*this)(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace apc
