/// Cubic B-splines on a uniform axis: C², four coefficients per point, linear beyond both ends.
///
/// With s = (x − low)/step, i = ⌊s⌋, t = s − i the value is Σ_k B_k(t) c_{i+k}, k = 0…3. The coefficients are chosen so
/// that the second derivative vanishes at an end that is continued linearly; the continuation is then C² as well.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace apc::loadtables {

/// Nodes low, low + step, …; a spline on it has nodes + 2 coefficients.
struct Axis {
  double low = 0.0, step = 1.0;
  int nodes = 2;
  double node(int i) const { return low + step * i; }
  double high() const { return node(nodes - 1); }
  int coefficients() const { return nodes + 2; }
};

Axis axis(double low, double high, int nodes);

/// The four weights at one point, their derivatives by x, and the first coefficient they apply to.
struct Weights {
  int first;
  double value[4], slope[4];
};

/// Weights at `x`; beyond the ends they continue linearly in x. `per_step` = 1/step, for callers that keep it.
inline Weights weights(const Axis& axis, double per_step, double x) {
  const double s = (x - axis.low) * per_step;
  const double inside = std::clamp(s, 0.0, static_cast<double>(axis.nodes - 1));
  const int first = std::min(static_cast<int>(inside), axis.nodes - 2);
  const double t = inside - first, q = 1.0 - t, beyond = s - inside;
  Weights w;
  w.first = first;
  const double d[4] = {-0.5 * q * q, 0.5 * t * (3.0 * t - 4.0), 0.5 * q * (4.0 - 3.0 * q), 0.5 * t * t};
  w.value[0] = q * q * q * (1.0 / 6.0) + beyond * d[0];
  w.value[1] = 2.0 / 3.0 - t * t * (1.0 - 0.5 * t) + beyond * d[1];
  w.value[2] = 2.0 / 3.0 - q * q * (1.0 - 0.5 * q) + beyond * d[2];
  w.value[3] = t * t * t * (1.0 / 6.0) + beyond * d[3];
  for (int k = 0; k < 4; ++k) w.slope[k] = d[k] * per_step;
  return w;
}

inline Weights weights(const Axis& axis, double x) { return weights(axis, 1.0 / axis.step, x); }

/// Condition at the lower end of an axis; the upper end is always linear (zero second derivative).
enum class LowerEnd {
  linear,  ///< second derivative 0
  level,   ///< slope 0
  rest,    ///< value, slope and second derivative 0; the data of the first two nodes are not used
};

/// Matrix (nodes + 2) × nodes that turns values at the nodes into coefficients.
Eigen::MatrixXd interpolation(const Axis&, LowerEnd);

}  // namespace apc::loadtables
