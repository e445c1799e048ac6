/// Rubble piles up before the tire: ΔF_x = B b (1 − e^(−s/length)).
/// Source: bow wave of loose material, saturating.
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  if (state.bed_distance > 0.0)
    change.drag += q[0] * state.tire_width * -std::expm1(-state.bed_distance / q[1]) * in_bed(state.bed_depth);
}

}  // namespace

Effect debris() {
  Effect e;
  e.id = "debris";
  e.title = "rubble piles up before the tire";
  e.law = "ΔF_x = B b (1 − e^(−s/length))";
  e.source = "bow wave of loose material, saturating";
  e.touches = "deceleration builds up with distance";
  e.confused_with = "softening, wall_tear";
  e.parameters = {{"B", "N/m", dimension::stiffness, 0.0, 6.0e4, 2.0e4, 0.0},
                  {"length", "m", dimension::length, 3.0, 60.0, 15.0, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
