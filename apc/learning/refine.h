/// A set of effects fitted through the simulator together with all nuisances, starting from a linear guess. The
/// sensitivities of nuisances stay those of the background; those of the effects are taken anew at every step.
#pragma once

#include <array>

#include "apc/learning/background.h"

namespace apc::learning {

struct SetFit {
  std::vector<effects::Applied> effects;
  Eigen::VectorXd eta;
  Eigen::MatrixXd covariance;  ///< of all effect parameters, effect by effect
  double log_evidence = 0.0;   ///< over the background without these effects
  double objective = 0.0;
  std::vector<bool> at_bound;  ///< per parameter
  double deviation(std::size_t parameter) const {
    return std::sqrt(covariance(static_cast<Eigen::Index>(parameter), static_cast<Eigen::Index>(parameter)));
  }
};

/// Factor of M = SᵀS + P⁻¹, made once per background.
struct NuisanceFactor {
  explicit NuisanceFactor(const Background& b) : factor(b.information + b.prior.precision) {}
  Eigen::LLT<Eigen::MatrixXd> factor;
};

/// How many parameters of an effect were free, and the deviations of all of its parameters (NaN when held) given the
/// first free one's column in the covariance.
std::size_t free_parameter_count(const effects::Applied&);
std::vector<double> parameter_deviations(const effects::Applied&, const SetFit&, std::size_t column);

/// `places`: shift (m) and stretch of each training run's way to start from, where a fine effect is among the set.
SetFit refine(const Background&, const NuisanceFactor&, const std::vector<effects::Applied>& start, int iterations,
              const std::vector<std::array<double, 2>>& places = {});

}  // namespace apc::learning
