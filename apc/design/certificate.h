/// Why a bed may be called the best one: two methods agree, the gradients they used are right, and no direction
/// improves the objective without breaking a constraint (Karush–Kuhn–Tucker):
///
///   ∇f + Σ λ_i ∇g_i + bounds = 0,   λ_i ≥ 0,   g_i = 0 where λ_i > 0
///
/// The multipliers λ come from a non-negative least-squares fit (Lawson & Hanson 1974); what is left of ∇f is reported.
#pragma once

#include <limits>

#include "apc/design/optimise.h"

namespace apc::design {

/// A constraint that holds the optimum where it is. `weight` is its share of Σ λ over
/// the constraints: what giving way there would bring.
struct Active {
  Constraint constraint;
  double use = 0.0, multiplier = 0.0, weight = 0.0;
};

struct Certificate {
  Optimum first, second;      ///< by two methods; the first is the best of several starts
  std::vector<double> ends;   ///< objectives the first method reached from each of its starts; NaN = none feasible
  double difference = 0.0;    ///< of the objectives, relative
  double stationarity = 0.0;  ///< |∇f + Σ λ∇g| / |∇f|; 0 at a perfect optimum
  double gradient_error =
      0.0;  ///< forward against central differences over twice the step, relative to the largest entry
  /// central differences against sensitivities carried along the run, of active constraints; NaN = not checked
  double sensitivity_error = std::numeric_limits<double>::quiet_NaN();
  double gap = 0.0;  ///< Σ λ |g| / |f|: what the constraints' slack at the optimum could still bring, to first order
  std::vector<Active> active;  ///< heaviest first
  bool agreed = false;         ///< difference ≤ 0.5 % and both feasible
};

/// Two methods agree and the first-order conditions hold there: the constraints' pull leaves at most a twentieth of the
/// objective's gradient. Agreement alone is no certificate: two methods can stop at the same place short of an optimum.
bool certified(const Certificate&);

/// x ≥ 0 that minimises |A x − b|.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Examines the optimum `z` of a programme: fills stationarity, gradient_error and active.
void examine(const Program&, const Eigen::VectorXd& z, const OptimiserOptions&, Certificate&);

}  // namespace apc::design
