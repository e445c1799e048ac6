/// Site is not level: rise over run of the whole site; gravity along x.
/// Source: survey tolerance; range estimated.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(Site& site, Values q) { site.bed.grade += q[0]; }

}  // namespace

Effect slope() {
  Effect e;
  e.id = "slope";
  e.title = "site is not level";
  e.law = "rise over run of the whole site; gravity along x";
  e.source = "survey tolerance; range estimated";
  e.touches = "constant deceleration at all speeds, before the bed too";
  e.confused_with = "thrust, cover";
  e.parameters = {{"grade", "", dimension::none, -0.03, 0.03, 0.01, 0.0}};
  e.site = act;
  return e;
}

}  // namespace apc::effects
