/// How the aircraft stands on level pavement at the mass and cg of its file: pitch 0 by definition. With more than two
/// gear groups the split is statically indeterminate; every wheel that is not a nose wheel then carries the same load,
/// and the struts' heights on the airframe follow from it.
#pragma once

#include <vector>

#include "aircraft/aircraft.h"

namespace apc::aircraft {

struct StandingGear {
  double vertical = 0.0;         ///< N per strut, tires on the ground
  double strut_force = 0.0;      ///< N per strut, along the strut: the tire load less the unsprung weight
  double stroke = 0.0;           ///< m
  double tire_deflection = 0.0;  ///< m
  double axle_height = 0.0;      ///< m above the pavement
};

struct StaticStand {
  std::vector<StandingGear> gears;  ///< in the aircraft's order
  double main_centroid = 0.0;       ///< m behind the nose gear: where the main gears' resultant acts
};

StaticStand static_stand(const Aircraft&);

}  // namespace apc::aircraft
