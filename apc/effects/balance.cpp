#include "apc/effects/balance.h"

#include <algorithm>
#include <cmath>

namespace apc::effects {
namespace {

using loadtables::LoadWithSlopes;
using loadtables::Slopes;

struct Solution {
  LoadWithSlopes foam, tire;  ///< the table at P₁ and at P₂
};

/// Derivatives of the two equations by P₁ and P₂, kept away from zero where the table is flat.
struct Matrix {
  double a, b, c, d, determinant;  ///< a, d > 0, c ≥ 0, b < 0, so the determinant is positive
};
Matrix matrix_of(const Solution& s, double k, double q, double penetration) {
  const double least = 1e-3 * std::max(1.0, s.foam.load.vertical) / penetration;
  Matrix m{k * std::max(s.foam.vertical.penetration, least), -q * std::max(s.tire.vertical.penetration, least),
           std::max(s.foam.rut_depth.penetration, 0.0), std::max(1.0 - s.tire.rut_depth.penetration, 0.02), 0.0};
  m.determinant = m.a * m.d - m.b * m.c;
  return m;
}

/// The load moved along its slope by a small change of penetration.
void carry(LoadWithSlopes& l, double change) {
  l.load.drag += l.drag.penetration * change;
  l.load.vertical += l.vertical.penetration * change;
  l.load.rut_depth += l.rut_depth.penetration * change;
  l.load.spin_ratio += l.spin_ratio.penetration * change;
}

/// Damped Newton from the unaltered balance.
Solution solve(const loadtables::LoadTable& table, const TireContact& contact, double k, double q) {
  const double P = contact.penetration, deepest = std::max(2.0 * P, P + 0.2);
  TireContact foam = contact, tire = contact;
  Solution s;
  s.foam = s.tire = table.load_with_slopes(contact);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const double e1 = k * s.foam.load.vertical - q * s.tire.load.vertical;
    const double e2 = s.foam.load.rut_depth + tire.penetration - s.tire.load.rut_depth - P;
    if (std::abs(e1) < 2e-3 * std::max(1.0, s.foam.load.vertical) && std::abs(e2) < 2e-3 * P) {
      // Near enough: the last Newton step along the slopes at hand, without another look-up (error of second order).
      const Matrix m = matrix_of(s, k, q, P);
      carry(s.foam, (-e1 * m.d + m.b * e2) / m.determinant);
      carry(s.tire, (-m.a * e2 + m.c * e1) / m.determinant);
      break;
    }
    const Matrix m = matrix_of(s, k, q, P);
    const double limit = (iteration < 12 ? 0.3 : 0.1) * P;
    const double step1 = std::clamp((-e1 * m.d + m.b * e2) / m.determinant, -limit, limit);
    const double step2 = std::clamp((-m.a * e2 + m.c * e1) / m.determinant, -limit, limit);
    foam.penetration = std::clamp(foam.penetration + step1, 1e-4 * P, deepest);
    tire.penetration = std::clamp(tire.penetration + step2, 1e-4 * P, deepest);
    s.foam = table.load_with_slopes(foam);
    s.tire = table.load_with_slopes(tire);
  }
  return s;
}

std::array<double, 4> lanes(const Slopes& s) { return {s.speed, s.bed_depth, s.penetration, 0.0}; }

}  // namespace

TireLoad balance(const loadtables::LoadTable& table, const TireContact& contact, double k, double q) {
  if (contact.penetration <= 0.0 || (k == 1.0 && q == 1.0)) return table.load(contact);
  TireLoad load = solve(table, contact, k, q).foam.load;
  load.vertical *= k;
  load.drag *= k;
  return load;
}

BalanceWithSlopes balance_with_slopes(const loadtables::LoadTable& table, const TireContact& contact, double k,
                                      double q) {
  const double P = contact.penetration;
  Solution s;
  if (P <= 0.0) {
    s.foam = table.load_with_slopes(contact);
    return {s.foam.load, lanes(s.foam.drag), lanes(s.foam.vertical), lanes(s.foam.rut_depth), lanes(s.foam.spin_ratio)};
  }
  if (k == 1.0 && q == 1.0)
    s.foam = s.tire = table.load_with_slopes(contact);
  else
    s = solve(table, contact, k, q);
  const Matrix m = matrix_of(s, k, q, P);
  const LoadWithSlopes &f = s.foam, &t = s.tire;
  // Right sides −∂(equations)/∂(speed, depth, P, ln k) at fixed P₁, P₂.
  const double r1[4] = {-(k * f.vertical.speed - q * t.vertical.speed),
                        -(k * f.vertical.bed_depth - q * t.vertical.bed_depth), 0.0, -k * f.load.vertical};
  const double r2[4] = {-(f.rut_depth.speed - t.rut_depth.speed), -(f.rut_depth.bed_depth - t.rut_depth.bed_depth), 1.0,
                        0.0};
  BalanceWithSlopes result;
  result.load = f.load;
  result.load.vertical *= k;
  result.load.drag *= k;
  for (std::size_t i = 0; i < 4; ++i) {
    const double moved = (r1[i] * m.d - m.b * r2[i]) / m.determinant;  // dP₁
    const auto total = [&](const Slopes& slopes) {
      return (i == 0 ? slopes.speed : i == 1 ? slopes.bed_depth : 0.0) + slopes.penetration * moved;
    };
    result.drag[i] = k * total(f.drag) + (i == 3 ? result.load.drag : 0.0);
    result.vertical[i] = k * total(f.vertical) + (i == 3 ? result.load.vertical : 0.0);
    result.rut_depth[i] = total(f.rut_depth);
    result.spin_ratio[i] = total(f.spin_ratio);
  }
  return result;
}

}  // namespace apc::effects
