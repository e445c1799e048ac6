/// Cover layer is cut by the tire: ΔF_x = f while p > 0.
/// Source: constant cutting force; range estimated.
#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.drag += q[0] * in_bed(state.bed_depth) * std::tanh(std::max(state.penetration, 0.0) / 0.01);
}

}  // namespace

Effect cover() {
  Effect e;
  e.id = "cover";
  e.title = "cover layer is cut by the tire";
  e.law = "ΔF_x = f while p > 0";
  e.source = "constant cutting force; range estimated";
  e.touches = "constant force in the bed";
  e.confused_with = "slope, thrust, wall_tear";
  e.parameters = {{"f", "N", dimension::force, 0.0, 4.0e3, 1.0e3, 0.0}};
  e.force = act;
  return e;
}

}  // namespace apc::effects
