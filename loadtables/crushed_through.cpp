#include "loadtables/crushed_through.h"

namespace apc::loadtables {
namespace {

/// What grows by `slope` at first and by no more than `room` in all; nothing where either is not positive.
template <class T>
T bounded_growth(const T& slope, const T& x, const T& room) {
  if (!(value_of(slope) > 0.0 && value_of(room) > 0.0 && value_of(x) > 0.0)) return T(0.0);
  const T straight = slope * x;
  return straight * room / (room + straight);
}

double tire_load(const HardBase& base, double deflection) { return base.tire(deflection); }
Sloped tire_load(const HardBase& base, const Sloped& deflection) {
  return chain(base.tire(deflection.value), base.tire.slope(deflection.value), deflection, 0.0, deflection);
}

}  // namespace

HardBase::HardBase(const TableTire& of, double deflection_at_edge, double friction)
    : tire(of.curve_deflection, of.curve_load),
      deflection(deflection_at_edge),
      load(tire(deflection_at_edge)),
      stiffness(tire.slope(deflection_at_edge)),
      rolling_resistance(friction) {}

template <class T>
void crushed_through(const HardBase& base, const AtEdge<T>& edge, const T& depth, const T& x, T (&out)[responses]) {
  constexpr double least_rut = 1e-6;    // m: below it there is no bed, and no volume to scale the drag by
  constexpr double least_yield = 0.02;  // of the depth: what a table's fit may put its rut too deep, or nearly
  const auto &value = edge.value, &slope = edge.slope;
  const T friction(base.rolling_resistance), deflection(base.deflection);
  T share = slope[vertical] / T(base.stiffness);
  if (!(value_of(share) > 0.0)) share = T(0.0);
  if (!(value_of(share) < 1.0)) share = T(1.0);
  const T yields = T(1.0) - share, room = depth - value[rut_depth], least = T(least_yield) * depth;
  const T crushed = bounded_growth(yields, x, value_of(room) > value_of(least) ? room : least);
  const T excess = slope[vertical] - T(base.stiffness);
  const T carried = tire_load(base, deflection + x - crushed) - T(base.load);
  const T more = carried + bounded_growth(excess, x, excess * deflection);
  out[rut_depth] = value[rut_depth] + bounded_growth(yields, x, room);
  out[vertical] = value[vertical] + more;
  out[drag] = value[drag] + friction * more;
  if (value_of(value[rut_depth]) > least_rut)
    out[drag] = out[drag] + bounded_growth(slope[drag] - friction * slope[vertical], x,
                                           (value[drag] - friction * value[vertical]) * room / value[rut_depth]);
  const T falling = T(0.0) - slope[slip];
  out[slip] = value[slip] + bounded_growth(slope[slip], x, T(0.5) * (T(1.0) - value[slip])) -
              bounded_growth(falling, x, falling * deflection);
}

template void crushed_through(const HardBase&, const AtEdge<double>&, const double&, const double&,
                              double (&)[responses]);
template void crushed_through(const HardBase&, const AtEdge<Sloped>&, const Sloped&, const Sloped&,
                              Sloped (&)[responses]);

}  // namespace apc::loadtables
