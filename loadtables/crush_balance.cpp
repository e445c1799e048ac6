#include "loadtables/crush_balance.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace apc::loadtables {
namespace {

double lock_up_rise(double z) { return z > 30.0 ? z : std::log1p(std::exp(z)); }

/// Levenberg–Marquardt on the logarithms of the parameters, slopes by differences; never leaves the bounds.
void least_squares(const std::vector<double*>& parameters, const std::vector<std::array<double, 2>>& bounds,
                   const std::function<Eigen::VectorXd()>& residuals) {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  const auto set = [&](const Eigen::VectorXd& logs) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      *parameters[k] = std::clamp(std::exp(logs(i)), bounds[k][0], bounds[k][1]);
    }
  };
  Eigen::VectorXd at(count);
  for (Eigen::Index i = 0; i < count; ++i) at(i) = std::log(*parameters[static_cast<std::size_t>(i)]);
  Eigen::VectorXd error = residuals();
  double damping = 1e-2;
  for (int iteration = 0; iteration < 40 && damping < 1e6; ++iteration) {
    Eigen::MatrixXd slopes(error.size(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
      Eigen::VectorXd moved = at;
      moved(i) += 1e-4;
      set(moved);
      slopes.col(i) = (residuals() - error) / 1e-4;
    }
    Eigen::MatrixXd normal = slopes.transpose() * slopes;
    const Eigen::VectorXd gradient = slopes.transpose() * error;
    normal.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(count, 1e-9);
    const Eigen::VectorXd trial = at - normal.ldlt().solve(gradient);
    set(trial);
    const Eigen::VectorXd trial_error = residuals();
    const double before = error.squaredNorm(), after = trial_error.squaredNorm();
    if (after < before) {
      for (Eigen::Index i = 0; i < count; ++i) at(i) = std::log(*parameters[static_cast<std::size_t>(i)]);
      error = trial_error;
      damping *= 0.3;
      if (before - after < 1e-6 * before) break;
    } else {
      damping *= 5.0;
    }
  }
  set(at);
}

/// log(model/sample) for every sample, with a floor below which a load counts as "small".
Eigen::VectorXd log_ratios(const CrushBalance& balance, const std::vector<Sample>& samples, double TireLoad::*load,
                           double floor) {
  Eigen::VectorXd ratios(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    ratios(static_cast<Eigen::Index>(i)) =
        std::log(std::max(balance.load(samples[i].contact).*load, floor) / std::max(samples[i].load.*load, floor));
  return ratios;
}

}  // namespace

double CrushBalance::contact_width(double rut) const {
  const double x = std::min(2.0 * std::max(rut, 0.0) / width, 1.0);
  return width * std::pow(x * (2.0 - x), crown) * (1.0 + wall_shear * rut / width);
}

TireLoad CrushBalance::load(const TireContact& contact) const {
  const double penetration = contact.penetration, depth = contact.bed_depth;
  if (!(penetration > 0.0)) return {};
  double deflection = penetration;
  if (depth > 0.0) {
    const double reach = std::min(penetration, radius);
    const double front = std::sqrt(2.0 * radius * reach - reach * reach);
    const auto surplus = [&](double trial) {
      const double flat = std::min(trial, radius);
      const double rear = std::sqrt(2.0 * radius * flat - flat * flat);
      const double rise = lock_up_rise((penetration - trial - lock_up * depth) / (lock_width * depth));
      return tire(trial) -
             area_factor * strength * contact_width(penetration - trial) * (front + rear) * (1.0 + rise * rise);
    };
    double low = 0.0, high = penetration;
    if (surplus(high) > 0.0)
      for (int halving = 0; halving < 48; ++halving) {
        deflection = 0.5 * (low + high);
        (surplus(deflection) < 0.0 ? low : high) = deflection;
      }
  }
  const double rut = penetration - deflection, force = tire(deflection);
  return {drag_factor * strength * contact_width(rut) * rut + rolling_resistance * force, force, rut,
          radius / (radius - std::min(deflection, 2.0 * radius) / 3.0)};
}

CrushBalance calibrate(CrushBalance balance, const std::vector<Sample>& samples) {
  double largest_vertical = 0.0, largest_drag = 0.0;
  for (const auto& sample : samples) {
    largest_vertical = std::max(largest_vertical, sample.load.vertical);
    largest_drag = std::max(largest_drag, sample.load.drag);
  }
  least_squares({&balance.area_factor, &balance.crown, &balance.wall_shear, &balance.lock_up, &balance.lock_width},
                {{0.05, 20.0}, {0.02, 0.6}, {1e-3, 1.0}, {0.4, 0.97}, {0.005, 0.3}},
                [&] { return log_ratios(balance, samples, &TireLoad::vertical, 0.01 * largest_vertical); });
  least_squares({&balance.drag_factor}, {{0.05, 20.0}},
                [&] { return log_ratios(balance, samples, &TireLoad::drag, 0.01 * largest_drag); });
  return balance;
}

}  // namespace apc::loadtables
