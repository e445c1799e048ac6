#include "aircraft/static_stand.h"

#include "aircraft/strut.h"
#include "apc/base/units.h"

namespace apc::aircraft {

StaticStand static_stand(const Aircraft& aircraft) {
  double wheels = 0.0, moment = 0.0;
  for (const auto& gear : aircraft.gears)
    if (!gear.is_nose()) wheels += gear.wheels(), moment += gear.wheels() * gear.behind_nose_gear;
  const double weight = aircraft.mass * units::g0;
  const double per_main_wheel = weight * aircraft.cg_behind_nose_gear / moment;

  StaticStand stand;
  stand.main_centroid = moment / wheels;
  for (const auto& gear : aircraft.gears) {
    const auto& tire = aircraft.tires.at(gear.tire);
    const double per_wheel = gear.is_nose() ? (weight - per_main_wheel * wheels) / gear.wheels() : per_main_wheel;
    StandingGear standing;
    standing.vertical = per_wheel * gear.wheels() / gear.struts;
    standing.strut_force = (standing.vertical - gear.unsprung_mass * units::g0) * std::cos(gear.strut.rake);
    standing.stroke = static_stroke(gear.strut, standing.strut_force);
    standing.tire_deflection = tire.load_curve.inverse(per_wheel);
    standing.axle_height = tire.radius() - standing.tire_deflection;
    stand.gears.push_back(standing);
  }
  return stand;
}

}  // namespace apc::aircraft
