/// How far the numbers of segments.h may be off, and how their errors hang together.
#pragma once

#include "apc/learning/segments.h"

namespace apc::learning {

/// How blocks and the model's own errors are spread; shares of the load, memory in s.
struct SegmentErrors {
  double block_strength = 0.08, correlation = 2.4;  ///< of the logarithm; m
  double lateral = 0.3;                             ///< correlation of nose and main tracks
  double drag = 0.06, nose_drag = 0.10;             ///< as AlongNoise: what steady tables leave open
  double memory = 0.4, rut = 0.006;                 ///< s; m
};

/// How every number changes per second by which the speed channel, and per second by which each other channel lags, and
/// per second by which the run's clock is late; columns: channels in their order, then the clock. A late speed moves
/// the places of all readings, too: with the entry speed v₀ and the speed v, slowings read v₀ of way too late per
/// second, means of the others v₀ − v.
Eigen::MatrixXd delayed_features(const Run&, const Segments&, const Trace&, const Eigen::VectorXd& value);

/// Covariance of the numbers from the instruments (noise, bias, scale, lag, clock), the blocks and the model's errors.
/// `trace`: the run; `by_strength`: change of the numbers with the logarithm of the bed's strength.
Eigen::MatrixXd feature_noise(const Run&, const Segments&, const Trace&, const Eigen::VectorXd& value,
                              const Eigen::VectorXd& by_strength, const SegmentErrors&);

}  // namespace apc::learning
