/// What is left of an aircraft's mass, first and second moment when the unsprung masses on its axles are taken away:
/// the body that the struts carry. Static attitude, x forward from the nose gear, z up from the pavement.
#pragma once

#include "aircraft/aircraft.h"

namespace apc::aircraft {

struct SprungBody {
  double mass = 0.0, unsprung = 0.0;  ///< kg; negative mass: the gears alone weigh more
  double x = 0.0, z = 0.0;            ///< m, its own centre of gravity
  double inertia = 0.0;               ///< kg m² about it; negative: less than the unsprung masses alone contribute
};

/// For the aircraft at `mass` and `pitch_inertia` (kg, kg m²; of the whole), `cg_behind` m behind the nose gear.
SprungBody sprung_body(const Aircraft&, double mass, double pitch_inertia, double cg_behind);

}  // namespace apc::aircraft
