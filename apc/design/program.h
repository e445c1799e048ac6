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
/// with x_k the stop distance of case k, and for all: use ≤ 1 of every load limit in every window of the way
/// (windows.h), |slopes| ≤ the allowed one.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "apc/design/evaluator.h"

namespace apc::design {

enum class Objective { length, volume, minimax, speed };
const char* text(Objective);

struct Aim {
  Objective objective = Objective::length;
  double reference = 0.0;          ///< m, length by which stations and lengths are scaled
  double length = 0.0;             ///< m, given; for Objective::speed
  std::vector<std::size_t> cases;  ///< of the fleet
  std::vector<double> alone;       ///< m, x*_k per entry of `cases`; for Objective::minimax
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

Program make_program(Evaluator&, const Aim&);

/// The programme with the constraints only that come within `near` of their limit at one of the points; those without a
/// load stay. What it leaves out must be looked at again where it ends.
Program nearby(const Program&, const std::vector<Eigen::VectorXd>& points, double near);

/// Between points of the programme and beds. `extra` is z_t.
Eigen::VectorXd point_of(const BedSpace&, const Profile&, double extra);
Profile profile_of(const BedSpace&, const Eigen::VectorXd& z, double reference);

/// Jacobian of [f, g] by differences: forward (backward at an upper bound) or central. `step` in scaled units.
enum class Differences { forward, central };
Eigen::MatrixXd jacobian(const Program&, const Eigen::VectorXd& z, double step, Differences);

}  // namespace apc::design
