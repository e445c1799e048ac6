/// The motion of a measured run as its instruments tell it, without any model of the bed: where each wheel was, how
/// fast, under what load. Forces can then be compared place by place; the bounce of the aircraft, which no model
/// predicts for long, is not part of the comparison.
#pragma once

#include <functional>
#include <optional>

#include "apc/learning/forward.h"

namespace apc::learning {

/// Samples every `interval` seconds from before entry to 3 m/s; vectors per gear group, then per sample.
struct Motion {
  double interval = 0.02;
  std::vector<double> time, speed, place, pitch;   ///< place: of the nose wheel from the leading edge, m; rad
  std::vector<std::vector<double>> carried;        ///< load of all wheels, N: steady + gain × swing
  std::vector<std::vector<double>> steady, swing;  ///< of statics with this braking; what accelerations add, N
  struct Led {
    std::vector<double> rise, pitch_rate, nose;  ///< m/s², rad/s; load of the nose gear, N
  } led;                                         ///< the bounce of a model led along the measured speed; may be empty
  double sinking = 1.0;                          ///< response to sinking, × that of a rigid wheel
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

/// Speed, place and pitch (0 where it was not recorded); null when the run has no usable speed. Loads are left empty.
std::optional<Motion> measured_motion(const Case&, const Layout&, std::size_t run);

}  // namespace apc::learning
