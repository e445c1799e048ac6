/// Foam torn along the walls of the rut: ΔF_x = 2 τ p.
/// Source: theory of polymer-foam arresting systems: crushing + tearing + adhesion + friction.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.drag += 2.0 * q[0] * state.penetration * in_bed(state.bed_depth);
}

}  // namespace

Effect wall_tear() {
  Effect e;
  e.id = "wall_tear";
  e.title = "foam torn along the walls of the rut";
  e.law = "ΔF_x = 2 τ p";
  e.source = "theory of polymer-foam arresting systems: crushing + tearing + adhesion + friction";
  e.touches = "deceleration proportional to penetration, not to tire width";
  e.confused_with = "adhesion, debris, cover";
  e.parameters = {{"tau", "N/m", dimension::stiffness, 0.0, 2.0e4, 5.0e3, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
