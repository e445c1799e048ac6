/// Bed loses strength by the year: strength × (1 − a years).
/// Source: punch tests before and after service (CRREL); range estimated.
#include <algorithm>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.strength *= std::max(0.05, 1.0 - q[0] * state.years);
}

}  // namespace

Effect ageing() {
  Effect e;
  e.id = "ageing";
  e.title = "bed loses strength by the year";
  e.law = "strength × (1 − a years)";
  e.source = "punch tests before and after service (CRREL); range estimated";
  e.touches = "run to run by date";
  e.confused_with = "temperature, bed strength";
  e.parameters = {{"a", "", dimension::none, -0.02, 0.05, 0.02, 0.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
