/// Drag and lift areas differ: extra drag area CdS and lift area ClS, air 1.225 kg/m³.
/// Source: flap and spoiler settings; range estimated.
#include "apc/effects/catalogue.h"

namespace apc::effects {
namespace {

void act(Site& site, Values q) {
  site.aircraft.aero.CD += q[0] / site.aircraft.aero.area;
  site.aircraft.aero.CL += q[1] / site.aircraft.aero.area;
}

}  // namespace

Effect aero() {
  Effect e;
  e.id = "aero";
  e.title = "drag and lift areas differ";
  e.law = "extra drag area CdS and lift area ClS, air 1.225 kg/m³";
  e.source = "flap and spoiler settings; range estimated";
  e.touches = "deceleration before the bed and at high speed";
  e.confused_with = "inertial, thrust";
  e.parameters = {{"CdS", "m^2", dimension::area, -15.0, 25.0, 6.0, 0.0},
                  {"ClS", "m^2", dimension::area, -40.0, 40.0, 0.0, 0.0}};
  e.site = act;
  return e;
}

}  // namespace apc::effects
