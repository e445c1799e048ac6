/// Crush strength grows with the rate of strain: strength × (1 + c ln(1 + ε̇/rate0)), ε̇ = v √(p/2R)/h: the rate at which
/// a wheel of radius R presses foam of depth h down. Source: as for rate.
#include <algorithm>
#include <cmath>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  const double sinking = std::max(state.speed, 0.0) *
                         std::sqrt(std::max(state.penetration, 0.0) / (2.0 * std::max(state.tire_radius, 0.1)));
  change.strength *= 1.0 + q[0] * std::log1p(sinking / std::max(state.bed_depth, 0.02) / q[1]);
}

}  // namespace

Effect rate_strain() {
  Effect e = rate();
  e.form = "strain";
  e.law = "strength × (1 + c ln(1 + v √(p/2R)/(h rate0)))";
  e.parameters[1] = {"rate0", "Hz", dimension::frequency, 0.3, 10.0, 1.0, 0.0};
  e.shapes = {{1.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
