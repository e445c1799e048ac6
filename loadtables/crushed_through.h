/// A tire sunk beyond P_max: what it sinks further presses the last foam against the base, or deflects the tire. Let
/// x = P − P_max; index e: the table's values and slopes by P there; room = h − D_e, the foam below the rut (for
/// the load at least 2 % of h: fits put the rut that much too deep); T the tire's load over its deflection, which is
/// δ₈₀ at P_max by definition (penetration_scale.h), and k = T′(δ₈₀).
///
///   a = F′_e / k, held in 0 … 1                        share of x that the tire takes at first
///   rut D = D_e + c,  c = b x room / (room + b x),  b = 1 − a     crushing goes on, ever slower, as far as the base
///   vertical F = F_e + T(δ₈₀ + x − c) − T(δ₈₀)         C¹ with the table, grows for every x > 0, at last as the tire's
///                                                      (F′_e > k: plus (F′_e − k) x δ₈₀/(δ₈₀ + x), C¹ there too)
///   drag = X_e + μ_r (F − F_e) + g x q / (q + g x),  g = X′_e − μ_r F′_e ≥ 0,  q = (X_e − μ_r F_e) room / D_e
///                                                      crushing at most the volume down to the base, and rolling
///   spin ratio: with its slope at the edge, bounded: rising as the tire deflects up to δ₈₀ further (x δ₈₀/(δ₈₀ + x)),
///   falling to no less than half of what it was
///
/// Where the table's load falls at P_max (a deep bed, the wheel all but buried) a is 0: only foam is crushed at first.
/// Derived from the tire's curve and the bed's depth alone; no measurement or SPH run reaches here, so a contact beyond
/// P_max is reported as outside the table all the same. Valid for x ≥ 0, h ≥ 0.
#pragma once

#include "apc/base/curve.h"
#include "loadtables/load_table_data.h"

namespace apc::loadtables {

/// A number with its derivatives by speed, bed depth and penetration.
struct Sloped {
  double value = 0.0, d[3] = {};
  Sloped() = default;
  Sloped(double constant) : value(constant) {}  // NOLINT: constants mix freely
  Sloped(double at, double by_speed, double by_depth, double by_penetration)
      : value(at), d{by_speed, by_depth, by_penetration} {}
};
/// f(x, y) from its value and its two partial derivatives.
inline Sloped chain(double value, double by_x, const Sloped& x, double by_y, const Sloped& y) {
  Sloped z(value);
  for (int i = 0; i < 3; ++i) z.d[i] = by_x * x.d[i] + by_y * y.d[i];
  return z;
}
inline Sloped operator+(const Sloped& x, const Sloped& y) { return chain(x.value + y.value, 1.0, x, 1.0, y); }
inline Sloped operator-(const Sloped& x, const Sloped& y) { return chain(x.value - y.value, 1.0, x, -1.0, y); }
inline Sloped operator*(const Sloped& x, const Sloped& y) { return chain(x.value * y.value, y.value, x, x.value, y); }
inline Sloped operator/(const Sloped& x, const Sloped& y) {
  const double z = x.value / y.value;
  return chain(z, 1.0 / y.value, x, -z / y.value, y);
}

inline double value_of(double x) { return x; }
inline double value_of(const Sloped& x) { return x.value; }

/// What stays the same for all contacts of a table.
struct HardBase {
  HardBase() = default;
  HardBase(const TableTire&, double deflection, double rolling_resistance);

  MonotoneCurve tire;                                  ///< T, N over m
  double deflection = 0.0, load = 0.0, stiffness = 1;  ///< δ₈₀, T(δ₈₀), k
  double rolling_resistance = 0.0;                     ///< μ_r
};

/// The four responses at P_max with their slopes by penetration.
template <class T>
struct AtEdge {
  T value[responses], slope[responses];
};

/// The responses `x` ≥ 0 beyond the edge, in a bed of `depth`. T: double, or Sloped; values have the same bits.
template <class T>
void crushed_through(const HardBase&, const AtEdge<T>&, const T& depth, const T& x, T (&out)[responses]);

extern template void crushed_through(const HardBase&, const AtEdge<double>&, const double&, const double&,
                                     double (&)[responses]);
extern template void crushed_through(const HardBase&, const AtEdge<Sloped>&, const Sloped&, const Sloped&,
                                     Sloped (&)[responses]);

}  // namespace apc::loadtables
