/// Seal friction of the struts: share × static strut load × tanh(stroke rate / 0.02 m/s), each strut.
/// Source: drop tests of oleo struts; range estimated.
#include "apc/base/units.h"
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

/// Static load of a strut on level ground: nose and main groups balance about the centre of gravity.
double static_load(const Site& site, const aircraft::Gear& gear) {
  double wheels = 0.0, arm = 0.0, struts = 0.0, nose = 0.0;
  for (const auto& g : site.aircraft.gears) {
    if (g.is_nose()) {
      nose = g.behind_nose_gear;
      continue;
    }
    wheels += g.wheels();
    arm += g.wheels() * g.behind_nose_gear;
    struts += g.struts;
  }
  const double main = arm / wheels;
  const double nose_share = (main - site.cg_behind_nose_gear) / (main - nose);
  const double weight = site.mass * units::g0;
  return gear.is_nose() ? weight * nose_share / gear.struts : weight * (1.0 - nose_share) / struts;
}

void act(Site& site, Values q) {
  for (auto& gear : site.aircraft.gears) gear.strut.friction += q[0] * static_load(site, gear);
}

}  // namespace

Effect oleo_friction() {
  Effect e;
  e.id = "oleo_friction";
  e.title = "struts stick";
  e.law = "friction share × static strut load × tanh(stroke rate / 0.02 m/s), each strut";
  e.source = "drop tests of oleo struts; range estimated";
  e.touches = "strokes, pitch and heave: less motion, hysteresis";
  e.confused_with = "damping";
  e.parameters = {{"share", "", dimension::none, 0.0, 0.12, 0.04, 0.0}};
  e.site = act;
  return e;
}

}  // namespace apc::effects
