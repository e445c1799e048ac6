/// Noise of one channel: white noise plus a slowly varying error (Ornstein–Uhlenbeck: standard deviation, correlation
/// time) that stands for what the model's dynamics cannot hold. Its covariance is never formed: a scalar Kalman filter
/// turns a series into independent innovations of unit variance, u = L⁻¹ y with L Lᵀ the covariance, in O(n), for any
/// spacing of the samples.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace apc::learning {

struct NoiseModel {
  double white = 1.0;        ///< standard deviation of independent noise
  double slow = 0.0;         ///< standard deviation of the slow part
  double correlation = 0.2;  ///< s (or m, for surveys)
};

class Whitener {
 public:
  Whitener() = default;
  /// `place`: increasing times (or distances) of the samples.
  Whitener(const std::vector<double>& place, const NoiseModel&);
  /// Applies L⁻¹ to each column in place.
  void apply(Eigen::Ref<Eigen::MatrixXd> columns) const;
  double log_determinant() const { return log_determinant_; }  ///< ln |L Lᵀ|

 private:
  std::vector<double> decay_, gain_, inverse_deviation_;
  double log_determinant_ = 0.0;
};

/// −2 ln likelihood of a series under the model, up to a constant.
double deviance(const std::vector<double>& place, const Eigen::VectorXd& series, const NoiseModel&);

/// Most likely noise of residuals recorded in several runs; white noise not below `least_white`, slow part between
/// `least_slow` and `most_slow`.
struct Series {
  std::vector<double> place;
  Eigen::VectorXd value;
};
NoiseModel fit_noise(const std::vector<Series>&, double least_white, double least_slow, double most_slow);

}  // namespace apc::learning
