/// Some rows of blocks weakened, all alike: strength × (1 − A) from one place to another, over half a metre at either
/// end. Source: a repair of other material, a leak, rows laid in another season; range as for softening with the
/// distance.
#include <algorithm>
#include <cmath>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

double step(double distance) {
  const double u = std::clamp(distance + 0.5, 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

void act(const TireState& state, Values q, TireChange& change) {
  change.strength *= 1.0 - q[0] * step(state.bed_distance - q[1]) * step(q[1] + q[2] - state.bed_distance);
}

}  // namespace

Effect softening_rows() {
  Effect e = softening();
  e.form = "rows";
  e.law = "strength × (1 − A) from one place over a length";
  e.parameters[1] = {"from", "m", dimension::length, 0.0, 100.0, 0.0, 0.0};
  e.parameters.push_back({"length", "m", dimension::length, 2.0, 60.0, 15.0, 0.0});
  for (const double from : {0.0, 10.0, 20.0, 30.0, 45.0, 60.0})
    for (const double length : {12.0, 24.0, 40.0}) e.shapes.push_back({from, length});
  e.bed = act;
  return e;
}

}  // namespace apc::effects
