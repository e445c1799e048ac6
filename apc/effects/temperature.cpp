/// Strength depends on temperature: strength × (1 − k (T − 20 °C)).
/// Source: polymer-bonded foams; range estimated.
#include <algorithm>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.strength *= std::max(0.05, 1.0 - q[0] * (state.temperature - 293.15));
}

}  // namespace

Effect temperature() {
  Effect e;
  e.id = "temperature";
  e.title = "strength depends on temperature";
  e.law = "strength × (1 − k (T − 20 °C))";
  e.source = "polymer-bonded foams; range estimated";
  e.touches = "run to run by temperature";
  e.confused_with = "ageing, bed strength";
  e.parameters = {{"k", "", dimension::none, -0.008, 0.008, 0.003, 0.0}};
  e.bed = act;
  return e;
}

}  // namespace apc::effects
