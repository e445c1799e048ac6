#include "loadtables/crushed_through.h"

namespace apc::loadtables {
namespace {

/// What grows by `slope` at first and by no more than `room` in all; nothing where either is not positive.
Sloped bounded_growth(const Sloped& slope, const Sloped& x, const Sloped& room) {
  if (!(slope.value > 0.0 && room.value > 0.0 && x.value > 0.0)) return 0.0;
  const Sloped straight = slope * x;
  return straight * room / (room + straight);
}

Sloped tire_load(const HardBase& base, const Sloped& deflection) {
  return chain(base.tire(deflection.value), base.tire.slope(deflection.value), deflection, 0.0, deflection);
}

}  // namespace

void crushed_through(const HardBase& base, const AtEdge& edge, const Sloped& depth, const Sloped& x,
                     Sloped (&out)[responses]) {
  constexpr double least_rut = 1e-6;    // m: below it there is no bed, and no volume to scale the drag by
  constexpr double least_yield = 0.02;  // of the depth: what a table's fit may put its rut too deep, or nearly
  const auto &value = edge.value, &slope = edge.slope;
  const double friction = base.rolling_resistance;
  Sloped share = slope[vertical] / base.tire.slope(base.deflection);
  if (!(share.value > 0.0)) share = 0.0;
  if (!(share.value < 1.0)) share = 1.0;
  const Sloped room = depth - value[rut_depth];
  const Sloped yielding = room.value > least_yield * depth.value ? room : least_yield * depth;
  const Sloped carried =
      tire_load(base, base.deflection + x - bounded_growth(1.0 - share, x, yielding)) - base.tire(base.deflection);
  const Sloped excess = slope[vertical] - base.tire.slope(base.deflection);
  out[rut_depth] = value[rut_depth] + bounded_growth(1.0 - share, x, room);
  out[vertical] = value[vertical] + carried + bounded_growth(excess, x, excess * base.deflection);
  out[drag] = value[drag] + friction * (out[vertical] - value[vertical]);
  if (value[rut_depth].value > least_rut)
    out[drag] = out[drag] + bounded_growth(slope[drag] - friction * slope[vertical], x,
                                           (value[drag] - friction * value[vertical]) * room / value[rut_depth]);
  out[slip] = value[slip] + bounded_growth(slope[slip], x, 0.5 * (1.0 - value[slip])) -
              bounded_growth(0.0 - slope[slip], x, (0.0 - slope[slip]) * base.deflection);
}

}  // namespace apc::loadtables
