#include "loadtables/crush_balance.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "apc/base/units.h"

namespace apc::loadtables {
namespace {

double lock_up_rise(double z) { return z > 30.0 ? z : std::log1p(std::exp(z)); }

/// c(D) = w (x (2 − x))^crown (1 + wall_shear D/w), x = min(2 D/w, 1).
double contact_width(double width, double rut, double crown, double wall_shear) {
  const double x = std::min(2.0 * std::max(rut, 0.0) / width, 1.0);
  return width * std::pow(x * (2.0 - x), crown) * (1.0 + wall_shear * rut / width);
}

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
      // Towards the inside, so that a parameter at its bound can leave it again.
      const auto& bound = bounds[static_cast<std::size_t>(i)];
      const double step = 2.0 * at(i) > std::log(bound[0]) + std::log(bound[1]) ? -1e-4 : 1e-4;
      Eigen::VectorXd moved = at;
      moved(i) += step;
      set(moved);
      slopes.col(i) = (residuals() - error) / step;
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

TireLoad CrushBalance::load(const TireContact& contact) const {
  const double penetration = contact.penetration, depth = contact.bed_depth;
  if (!(penetration > 0.0)) return {};
  double deflection = penetration;
  if (depth > 0.0) {
    const double reach = std::min(penetration, radius);
    const double front = std::sqrt(2.0 * radius * reach - reach * reach);
    const double above = std::max(penetration / radius - 1.0, 0.0);
    const double pressure = area_factor * strength * std::exp(-plough * above * above);
    const auto surplus = [&](double trial) {
      const double flat = std::min(trial, radius);
      const double rear = std::sqrt(2.0 * radius * flat - flat * flat);
      const double rise = lock_up_rise((penetration - trial - lock_up * depth) / (lock_width * depth));
      return tire(trial) - pressure * contact_width(width, penetration - trial, crown, wall_shear) * (front + rear) *
                               (1.0 + rise * rise);
    };
    double low = 0.0, high = penetration;
    if (surplus(high) > 0.0)
      for (int halving = 0; halving < 48; ++halving) {
        deflection = 0.5 * (low + high);
        (surplus(deflection) < 0.0 ? low : high) = deflection;
      }
  }
  const double speed = contact.speed / (70.0 * units::kt);
  const double rut = penetration - deflection, force = tire(deflection);
  return {drag_factor * strength * contact_width(width, rut, drag_crown, drag_wall_shear) * rut *
                  (1.0 + inertia * speed * speed) +
              rolling_resistance * force,
          force, rut, radius / (radius - std::min(deflection, 2.0 * radius) / 3.0)};
}

CrushBalance calibrate(CrushBalance balance, const std::vector<Sample>& samples) {
  double largest_vertical = 0.0, largest_drag = 0.0;
  for (const auto& sample : samples) {
    largest_vertical = std::max(largest_vertical, sample.load.vertical);
    largest_drag = std::max(largest_drag, sample.load.drag);
  }
  const auto errors = [&] { return log_ratios(balance, samples, &TireLoad::vertical, 0.01 * largest_vertical); };
  // The lock-up has local optima; the best of a few starts is kept.
  CrushBalance best = balance;
  double least = std::numeric_limits<double>::infinity();
  for (const double crown : {0.2, 0.6})
    for (const double lock_up : {0.8, 0.88}) {
      balance.area_factor = 1.0, balance.wall_shear = 0.05, balance.plough = 0.3, balance.lock_width = 0.04;
      balance.crown = crown, balance.lock_up = lock_up;
      least_squares({&balance.area_factor, &balance.crown, &balance.wall_shear, &balance.plough, &balance.lock_up,
                     &balance.lock_width},
                    {{0.05, 20.0}, {0.02, 1.0}, {1e-3, 1.0}, {1e-2, 5.0}, {0.4, 0.99}, {0.005, 0.3}}, errors);
      if (const double sum = errors().squaredNorm(); sum < least) least = sum, best = balance;
    }
  balance = best;
  least_squares({&balance.drag_factor, &balance.drag_crown, &balance.drag_wall_shear, &balance.inertia},
                {{0.05, 20.0}, {0.02, 1.0}, {1e-3, 1.0}, {1e-3, 2.0}},
                [&] { return log_ratios(balance, samples, &TireLoad::drag, 0.01 * largest_drag); });
  return balance;
}

}  // namespace apc::loadtables
