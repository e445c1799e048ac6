/// Bed is built in waves: depth × (1 − A sin(2π s/length + phase)).
/// Source: construction tolerance of base and top; range estimated.
#include <cmath>
#include <numbers>

#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

void act(const TireState& state, Values q, TireChange& change) {
  change.depth *= 1.0 - q[0] * std::sin(2.0 * std::numbers::pi * state.bed_distance / q[1] + q[2]);
}

}  // namespace

Effect depth_as_built_wave() {
  Effect e = depth_as_built();
  e.form = "wave";
  e.law = "depth × (1 − A sin(2π s/length + phase))";
  e.parameters[1] = {"length", "m", dimension::length, 5.0, 60.0, 20.0, 0.0};
  e.parameters.push_back({"phase", "rad", dimension::none, 0.0, 6.3, 0.0, 0.0});
  for (const double length : {12.0, 15.5, 20.0, 26.0, 34.0})
    for (const double phase : {0.0, 1.571}) e.shapes.push_back({length, phase});
  e.site = nullptr;
  e.bed = act;
  return e;
}

}  // namespace apc::effects
