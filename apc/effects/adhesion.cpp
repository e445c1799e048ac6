/// Foam sticks to the tread: ΔF_x = a b √(2 R p).
/// Source: theory of polymer-foam arresting systems.
#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.drag += q[0] * state.tire_width * std::sqrt(2.0 * state.tire_radius * std::max(state.penetration, 0.0)) *
                 in_bed(state.bed_depth);
}

}  // namespace

Effect adhesion() {
  Effect e;
  e.id = "adhesion";
  e.title = "foam sticks to the tread";
  e.law = "ΔF_x = a b √(2 R p)";
  e.source = "theory of polymer-foam arresting systems";
  e.touches = "deceleration proportional to contact area";
  e.confused_with = "wall_tear, rubble_friction";
  e.parameters = {{"a", "Pa", dimension::pressure, 0.0, 1.0e5, 1.0e4, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
