/// One main tire loses pressure when the nose wheel is at `at`: contact pressure at a given deflection ×
/// (1.08 − loss)/1.08; the 0.08 is what the carcass carries. Blends over 1 m. Source: tire maker's load–deflection
/// curves at several pressures; carcass share estimated.
#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  if (state.nose) return;
  const double u = std::clamp(state.nose_distance - q[1] + 0.5, 0.0, 1.0);
  change.tire_pressure *= 1.0 - q[0] / 1.08 * u * u * (3.0 - 2.0 * u);
}

}  // namespace

Effect tire_loss() {
  Effect e;
  e.id = "tire_loss";
  e.title = "one main tire loses pressure";
  e.law = "contact pressure at a given deflection × (1.08 − loss)/1.08 for one main tire from nose distance at";
  e.source = "tire makers' load–deflection curves at several pressures; carcass share estimated";
  e.touches = "step in deceleration, main stroke and pitch at one place of one run or of all";
  e.confused_with = "softening, depth_as_built";
  e.parameters = {{"loss", "", dimension::none, 0.0, 1.0, 0.8, 0.0},
                  {"at", "m", dimension::length, 0.0, 150.0, 30.0, 0.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
