/// Crush strength grows with speed: strength × (1 + c ln(1 + v/v0)).
/// Source: logarithmic rate law of cellular concrete and foam (Mag. Concr. Res. 65, 209).
#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.strength *= 1.0 + q[0] * std::log1p(std::max(state.speed, 0.0) / q[1]);
}

}  // namespace

Effect rate() {
  Effect e;
  e.id = "rate";
  e.title = "crush strength grows with speed";
  e.law = "strength × (1 + c ln(1 + v/v0))";
  e.source = "logarithmic rate law of cellular concrete and foam (Mag. Concr. Res. 65, 209)";
  e.touches = "deceleration and rut together: the bed lifts the wheel";
  e.confused_with = "inertial, table_error";
  e.parameters = {{"c", "", dimension::none, -0.02, 0.12, 0.03, 0.0},
                  {"v0", "m/s", dimension::speed, 0.3, 10.0, 1.0, 0.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
