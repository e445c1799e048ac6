#include "aircraft/sprung_body.h"

#include "aircraft/static_stand.h"

namespace apc::aircraft {
namespace {

double squared(double x) { return x * x; }

}  // namespace

SprungBody sprung_body(const Aircraft& aircraft, double mass, double pitch_inertia, double cg_behind) {
  const auto stand = static_stand(aircraft);
  const double cg_x = -cg_behind, cg_z = aircraft.cg_height;
  SprungBody body;
  body.x = mass * cg_x, body.z = mass * cg_z;
  for (std::size_t i = 0; i < aircraft.gears.size(); ++i) {
    const auto& gear = aircraft.gears[i];
    const double unsprung = gear.struts * gear.unsprung_mass;
    body.unsprung += unsprung;
    body.x -= unsprung * -gear.behind_nose_gear;
    body.z -= unsprung * stand.gears[i].axle_height;
  }
  body.mass = mass - body.unsprung;
  if (!(body.mass > 0.0)) return body;
  body.x /= body.mass;
  body.z /= body.mass;
  body.inertia = pitch_inertia - body.mass * (squared(body.x - cg_x) + squared(body.z - cg_z));
  for (std::size_t i = 0; i < aircraft.gears.size(); ++i) {
    const auto& gear = aircraft.gears[i];
    body.inertia -= gear.struts * gear.unsprung_mass *
                    (squared(-gear.behind_nose_gear - cg_x) + squared(stand.gears[i].axle_height - cg_z));
  }
  return body;
}

}  // namespace apc::aircraft
