/// Curves y(x) through given points: piecewise linear, and the monotone cubic of Fritsch and Carlson (PCHIP; SIAM J.
/// Numer. Anal. 17, 1980, 238–246), which is C¹ and never overshoots its data.
#pragma once

#include <vector>

namespace apc {

/// y(x) by straight lines; constant beyond the ends. `x` must increase strictly (InputError otherwise).
class LinearCurve {
 public:
  LinearCurve() = default;
  LinearCurve(std::vector<double> x, std::vector<double> y);
  double operator()(double x) const;
  double slope(double x) const;
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_;
};

/// Monotone C¹ cubic; linear beyond the ends with the end's slope.
class MonotoneCurve {
 public:
  MonotoneCurve() = default;
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  double operator()(double x) const;
  double slope(double x) const;
  /// ∫ y dx from the first point to `x`.
  double integral(double x) const;
  /// x with y(x) = `y`, for a strictly increasing curve; continues linearly beyond the ends.
  double inverse(double y) const;
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace apc
