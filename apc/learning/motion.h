/// The motion of a measured run as its instruments and its rut survey tell it, without any force model: where each
/// wheel was, how fast, in what rut. Forces can then be compared place by place; the bounce of the aircraft, which no
/// model predicts for long, is not part of the comparison.
#pragma once

#include <functional>
#include <optional>

#include "apc/learning/forward.h"

namespace apc::learning {

/// Samples every `interval` seconds from before entry to 3 m/s; vectors per gear group, then per sample.
struct Motion {
  double interval = 0.02;
  std::vector<double> time, speed, place, pitch;  ///< place: of the nose wheel from the leading edge, m; rad
  std::vector<std::vector<double>> rut;           ///< m
  std::vector<std::vector<double>> penetration;   ///< m; 0 outside the bed. Found from the rut by the load tables
  std::vector<std::vector<double>> incline;       ///< slope of the wheel's path against the base, down positive
  std::size_t size() const { return time.size(); }
  /// A sampled quantity at any time; ends held.
  double at(const std::vector<double>& quantity, double when) const;
};

/// Smoothing spline on an even grid: least squares with white noise of standard deviation `curvature` (per square root
/// of the abscissa's unit) as the prior of the second derivative. NaN readings are left out.
struct Smooth {
  double first = 0.0, interval = 1.0;
  Eigen::VectorXd value;
  double at(double x) const;
};
Smooth smooth(const std::vector<double>& x, const std::vector<double>& y, double first, double last, double interval,
              double noise, double curvature);

/// Speed, place, pitch and surveyed ruts; null when the run has no speed, no acceleration_x, no pitch or pitch rate, or
/// no survey of both ruts. Penetration and incline are left empty.
std::optional<Motion> measured_motion(const Case&, const Layout&, std::size_t run);

}  // namespace apc::learning
