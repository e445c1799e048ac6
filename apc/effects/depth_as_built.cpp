/// Bed is not as deep as drawn: depth × (1 − A), profile moved by shift.
/// Source: construction tolerance; range estimated.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(Site& site, Values q) {
  for (double& depth : site.bed.depth) depth *= 1.0 - q[0];
  for (std::size_t i = 1; i + 1 < site.bed.distance.size(); ++i) site.bed.distance[i] += q[1];
}

}  // namespace

Effect depth_as_built() {
  Effect e;
  e.id = "depth_as_built";
  e.title = "bed is not as deep as drawn";
  e.law = "depth × (1 − A), profile moved by shift";
  e.source = "construction tolerance; range estimated";
  e.touches = "rut, heave";
  e.confused_with = "lock_up, softening";
  e.parameters = {{"A", "", dimension::none, -0.2, 0.2, 0.05, 0.0},
                  {"shift", "m", dimension::length, -2.0, 2.0, 0.0, 0.0}};
  e.site = act;
  return e;
}

}  // namespace apc::effects
