#include "apc/learning/whiten.h"

#include <algorithm>
#include <cmath>

namespace apc::learning {

Whitener::Whitener(const std::vector<double>& place, const NoiseModel& noise) {
  const std::size_t n = place.size();
  decay_.resize(n), gain_.resize(n), inverse_deviation_.resize(n);
  const double white = noise.white * noise.white, slow = noise.slow * noise.slow;
  double variance = slow;  // of the slow part given the samples so far
  for (std::size_t i = 0; i < n; ++i) {
    const double decay = i == 0 ? 0.0 : std::exp(-(place[i] - place[i - 1]) / noise.correlation);
    variance = i == 0 ? slow : decay * decay * variance + slow * (1.0 - decay * decay);
    const double total = variance + white;
    decay_[i] = decay;
    gain_[i] = variance / total;
    inverse_deviation_[i] = 1.0 / std::sqrt(total);
    log_determinant_ += std::log(total);
    variance *= 1.0 - gain_[i];
  }
}

void Whitener::apply(Eigen::Ref<Eigen::MatrixXd> columns) const {
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    double state = 0.0;
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      state *= decay_[k];
      const double innovation = columns(i, c) - state;
      state += gain_[k] * innovation;
      columns(i, c) = innovation * inverse_deviation_[k];
    }
  }
}

double deviance(const std::vector<double>& place, const Eigen::VectorXd& series, const NoiseModel& noise) {
  const Whitener whitener(place, noise);
  Eigen::MatrixXd column = series;
  whitener.apply(column);
  return column.squaredNorm() + whitener.log_determinant();
}

NoiseModel fit_noise(const std::vector<Series>& all, double least_white, double least_slow, double most_slow) {
  const auto total = [&](const NoiseModel& noise) {
    double sum = 0.0;
    for (const Series& s : all) sum += deviance(s.place, s.value, noise);
    return sum;
  };
  NoiseModel best{least_white, least_slow, 0.2};
  double lowest = total(best);
  for (const double correlation : {0.03, 0.1, 0.3, 1.0})
    for (double white = least_white; white < 20.0 * least_white; white *= 1.25) {
      bool better_here = false;
      for (double slow = least_slow; slow <= most_slow; slow *= 1.3) {
        const NoiseModel noise{white, slow, correlation};
        const double value = total(noise);
        if (value < lowest) lowest = value, best = noise, better_here = true;
      }
      if (!better_here && white > 2.0 * best.white) break;
    }
  return best;
}

}  // namespace apc::learning
