/// One main tire leaks from where the nose wheel is at `at`: lost is loss (1 − e^(−t/tau)), t from there at the present
/// speed; contact pressure as for a sudden loss. Source: as for tire_loss.
#include <algorithm>
#include <cmath>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  if (state.nose) return;
  const double since = std::max(0.0, state.nose_distance - q[1]) / std::max(state.speed, 1.0);
  change.tire_pressure *= 1.0 + q[0] / 1.08 * std::expm1(-since / q[2]);
}

}  // namespace

Effect tire_loss_slow() {
  Effect e = tire_loss();
  e.form = "slow";
  e.law = "as the sudden loss, growing as 1 − e^(−t/tau) from nose distance at";
  e.parameters.push_back({"tau", "s", dimension::time, 0.1, 3.0, 0.7, 0.0});
  for (double at = 20.0; at <= 80.0; at += 10.0) e.shapes.push_back({at, 0.7});
  e.bed = act;
  return e;
}

}  // namespace apc::effects
