/// Foam thrown aside by the tire: ΔF_x = C ρ b p v²,  ΔF_z = C_z ρ b p v².
/// Source: momentum of the displaced foam; SAE 710604 (Crenshaw 1971) for soft soil.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  const double q2 =
      state.density * state.tire_width * state.penetration * state.speed * state.speed * in_bed(state.bed_depth);
  change.drag += q[0] * q2;
  change.vertical += q[1] * q2;
}

}  // namespace

Effect inertial() {
  Effect e;
  e.id = "inertial";
  e.title = "foam thrown aside by the tire";
  e.law = "ΔF_x = C ρ b p v²,  ΔF_z = C_z ρ b p v²";
  e.source = "momentum of the displaced foam; SAE 710604 (Crenshaw 1971) for soft soil";
  e.touches = "deceleration at high speed, grows with v²";
  e.confused_with = "aero, rate, wall_tear";
  e.parameters = {{"C", "", dimension::none, 0.0, 1.2, 0.3, 0.0}, {"Cz", "", dimension::none, 0.0, 0.5, 0.0, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
