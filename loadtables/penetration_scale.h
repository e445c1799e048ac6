/// Largest meaningful penetration P_max(h) = min(0.85 h + δ₈₀, D): the bed fully compacted plus the tire's deflection
/// at 80 % of its bottoming load, at most the tire's diameter (ACRP Report 29, §9.4.4.1).
///
/// The corner of the minimum is rounded so that the table is smooth across it: with a = 0.85 h + δ₈₀,
///   P_max = ½ (a + D − √((a − D)² + ε²)),   ε = 0.01 D;
/// at the corner that is 0.5 % of D less than the report's definition, elsewhere a fraction of that.
#pragma once

#include <cmath>

namespace apc::loadtables {

struct TableTire;

struct PenetrationScale {
  double compaction = 0.85;  ///< rut depth / bed depth of fully compacted material
  double deflection = 0.0;   ///< δ₈₀, m
  double diameter = 0.0;     ///< D, m

  double at(double bed_depth) const {
    const double a = compaction * bed_depth + deflection - diameter;
    return 0.5 * (a + 2.0 * diameter - std::sqrt(a * a + rounding() * rounding()));
  }
  /// dP_max/dh.
  double slope(double bed_depth) const {
    const double a = compaction * bed_depth + deflection - diameter;
    return 0.5 * compaction * (1.0 - a / std::sqrt(a * a + rounding() * rounding()));
  }
  double rounding() const { return 0.01 * diameter; }
};

/// δ₈₀ from the tire's load–deflection curve. InputError when the tire's numbers do not describe one.
PenetrationScale penetration_scale(const TableTire&);

}  // namespace apc::loadtables
