/// Bed weakened near its start (water, frost): strength × (1 − A e^(−s/length)).
/// Source: ACRP Report 29: −60 % strength after 78 immersed freeze–thaw cycles.
#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.strength *= 1.0 - q[0] * std::exp(-std::max(state.bed_distance, 0.0) / q[1]);
}

}  // namespace

Effect softening() {
  Effect e;
  e.id = "softening";
  e.title = "bed weakened near its start (water, frost)";
  e.law = "strength × (1 − A e^(−s/length))";
  e.source = "ACRP Report 29: −60 % strength after 78 immersed freeze–thaw cycles";
  e.touches = "deeper rut and less drag over the first part of the bed";
  e.confused_with = "debris, tire_loss, depth_as_built";
  e.parameters = {{"A", "", dimension::none, 0.0, 0.6, 0.2, 0.0},
                  {"length", "m", dimension::length, 4.0, 80.0, 20.0, 0.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
