/// Foam stiffens before it locks up: strength × (1 + gain max(0, min(1, p/h) − from)²).
/// Source: plateaus of glass and cement foams rise before bottoming; range estimated.
#include <algorithm>
#include <cmath>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  const double beyond = std::max(0.0, std::min(1.0, state.penetration / std::max(state.bed_depth, 0.02)) - q[1]);
  change.strength *= 1.0 + q[0] * beyond * beyond;
}

}  // namespace

Effect lock_up_gradual() {
  Effect e = lock_up();
  e.form = "gradual";
  e.law = "strength × (1 + gain max(0, min(1, p/h) − from)²)";
  e.parameters = {{"gain", "", dimension::none, 0.0, 12.0, 4.0, 0.0},
                  {"from", "", dimension::none, 0.2, 0.8, 0.5, 0.0}};
  e.shapes = {{0.45}, {0.6}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
