/// Foam thrown aside by the tire, but only that near the surface: ΔF_x = C ρ b min(p, depth) v².
/// Source: as for inertial; foam below the depth is pressed down and not thrown.
#include <algorithm>
#include <cmath>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.drag += q[0] * state.density * state.tire_width * std::min(std::max(state.penetration, 0.0), q[1]) *
                 state.speed * state.speed * in_bed(state.bed_depth);
}

}  // namespace

Effect inertial_limited() {
  Effect e = inertial();
  e.form = "limited";
  e.law = "ΔF_x = C ρ b min(p, depth) v²";
  e.parameters[1] = {"depth", "m", dimension::length, 0.05, 0.4, 0.2, 0.0};
  e.shapes = {{0.12}, {0.22}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
