/// Extra drag area, and wind other than the one reported in proportion to it: CdS, headwind + wind CdS / 6 m².
/// Source: wind at the runway's end against that at the tower; range estimated.
#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

constexpr double usual_area = 6.0;  ///< m²

void act(Site& site, Values q) {
  site.aircraft.aero.CD += q[0] / site.aircraft.aero.area;
  site.headwind += q[1] * q[0] / usual_area;
}

}  // namespace

Effect aero_wind() {
  Effect e = aero();
  e.form = "wind";
  e.law = "extra drag area CdS, headwind + wind CdS/6 m²";
  e.parameters[1] = {"wind", "m/s", dimension::speed, -15.0, 15.0, 10.0, 0.0};
  e.shapes = {{-10.0}, {10.0}};
  e.site = act;
  return e;
}

}  // namespace apc::effects
