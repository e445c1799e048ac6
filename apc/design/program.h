/// The design as a nonlinear programme:  min f(z),  g(z) ≤ 0,  low ≤ z ≤ high.
///
/// z holds the ramp's length and the nodes' depths, each scaled to 0…1 over the space of beds (those without freedom
/// are left out), and one more number that makes a minimax problem smooth (epigraph form):
///
///   length   z_t = L / reference,     f = z_t          x_k ≤ L
///   volume   z_t = L / reference,     f = V(z) / V₀    x_k ≤ L
///   minimax  z_t = t,                 f = t            x_k ≤ t x*_k      (x*_k: the bed that is best for case k alone)
///   speed    z_t = s,                 f = −s           x_k(s v_k) ≤ L    (L given)
///
/// with x_k the stop distance of case k, and for all: use ≤ 1 of every load limit, |slopes| ≤ the allowed one.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "apc/design/evaluator.h"

namespace apc::design {

enum class Objective { length, volume, minimax, speed };
const char* text(Objective);

/// How the nose gear's drag enters.
enum class Peaks {
  watched,  ///< at fixed places of the bed: smooth in the design, but a peak between two places is missed
  exact,    ///< the peak wherever it is: right, but with kinks where two peaks are equal
};

struct Aim {
  Objective objective = Objective::length;
  double reference = 0.0;          ///< m, length by which stations and lengths are scaled
  double length = 0.0;             ///< m, given; for Objective::speed
  std::vector<std::size_t> cases;  ///< of the fleet
  std::vector<double> alone;       ///< m, x*_k per entry of `cases`; for Objective::minimax
  std::vector<double> allowance;   ///< per case, off the nose drag's limit at watched places: for peaks between them
  double reserve = 0.0;            ///< taken off every load limit, as a share: a margin asked for
  bool feasibility = false;        ///< f = s, g = use − 1 − s: the least overstep of the limits that can be reached
};

/// Point of the programme → objective and constraints; constraint names in the order of g.
struct Program {
  Eigen::VectorXd low, high;
  std::vector<Constraint> constraints;
  /// Values [f, g₁, g₂, …] at several points at once, so that all cores have work.
  std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)> evaluate;
  /// The same near a point: cases none of whose constraints is within `far` of its limit there keep that point's
  /// figures.
  std::function<std::vector<Eigen::VectorXd>(const Eigen::VectorXd& z, const std::vector<Eigen::VectorXd>&)>
      evaluate_near;
  Eigen::VectorXd at(const Eigen::VectorXd& z) const { return evaluate({z}).front(); }
};

Program make_program(Evaluator&, const Aim&, Peaks);

/// Between points of the programme and beds. `extra` is z_t.
Eigen::VectorXd point_of(const BedSpace&, const Profile&, double extra);
Profile profile_of(const BedSpace&, const Eigen::VectorXd& z, double reference);

/// Jacobian of [f, g] by differences: forward (backward at an upper bound) or central. `step` in scaled units.
enum class Differences { forward, central };
Eigen::MatrixXd jacobian(const Program&, const Eigen::VectorXd& z, double step, Differences);

}  // namespace apc::design
