/// Tire drags on crushed rubble: ΔF_x = μ F_z.
/// Source: Coulomb.
#include <algorithm>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.drag += q[0] * std::max(state.vertical, 0.0) * in_bed(state.bed_depth);
}

}  // namespace

Effect rubble_friction() {
  Effect e;
  e.id = "rubble_friction";
  e.title = "tire drags on crushed rubble";
  e.law = "ΔF_x = μ F_z";
  e.source = "Coulomb";
  e.touches = "deceleration follows the vertical load; pitch";
  e.confused_with = "wall_tear, cover";
  e.parameters = {{"mu", "", dimension::none, 0.0, 0.35, 0.05, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
