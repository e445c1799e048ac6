#include "apc/simulation/plant.h"

#include <cmath>

#include "aircraft/sprung_body.h"
#include "aircraft/static_stand.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::simulation {
namespace {

double squared(double x) { return x * x; }

/// Axle positions in the static attitude, relative to the pavement under the nose gear.
Vector static_axle(const aircraft::Gear& gear, const aircraft::StandingGear& standing) {
  return {-gear.behind_nose_gear, standing.axle_height};
}

void add_group(const aircraft::Aircraft& aircraft, std::size_t index, const aircraft::StandingGear& standing,
               Vector origin, Plant& plant) {
  const auto& gear = aircraft.gears[index];
  const auto& tire = aircraft.tires.at(gear.tire);
  Group group;
  group.name = gear.name;
  group.strut = gear.strut;
  group.struts = gear.struts;
  group.mass = gear.struts * gear.unsprung_mass;
  group.axis = {-std::sin(gear.strut.rake), std::cos(gear.strut.rake)};
  const auto axle = static_axle(gear, standing);
  group.extended = {axle.x - origin.x - standing.stroke * group.axis.x,
                    axle.z - origin.z - standing.stroke * group.axis.z};
  group.tire_radius = tire.radius();
  group.first_row = static_cast<int>(plant.rows.size());
  group.rows = gear.axles;
  for (int i = 0; i < gear.axles; ++i) {
    Row row;
    row.group = static_cast<int>(index);
    row.ahead = i == 0 ? -1 : group.first_row + i - 1;
    row.offset = (0.5 * (gear.axles - 1) - i) * gear.axle_spacing;
    row.tires = gear.struts * gear.wheels_per_axle;
    row.inertia = row.tires * gear.wheel_inertia;
    plant.rows.push_back(row);
  }
  if (gear.axles > 1) {
    group.bogie = plant.bogies++;
    group.brakes_on_beam = !gear.brake_rods;
    group.bogie_inertia = gear.struts * gear.bogie_inertia;
    const double arm = 0.5 * (gear.axles - 1) * gear.axle_spacing;
    const double stiffness =
        2.0 * gear.struts * gear.wheels_per_axle * tire.load_curve.slope(standing.tire_deflection) * squared(arm);
    group.bogie_damping =
        gear.bogie_damping > 0.0 ? gear.struts * gear.bogie_damping : 0.4 * std::sqrt(stiffness * group.bogie_inertia);
  }
  plant.groups.push_back(group);
}

void set_ground(const Model& model, const Overrun& overrun, Plant& plant) {
  for (std::size_t i = 0; i < plant.groups.size(); ++i) {
    auto& group = plant.groups[i];
    const auto& gear = model.aircraft.gears[i];
    const auto& tire = model.aircraft.tires.at(gear.tire);
    group.corners = plant.profile.corners(plant.base_falls ? 0.5 * tire.radius() : 0.0);
    group.braking = gear.braked ? overrun.braking : 0.0;
    group.braking_in_bed = !gear.braked ? 0.0 : overrun.braking_in_bed < 0.0 ? overrun.braking : overrun.braking_in_bed;
    group.ground.table = &model.tables[i];
    group.ground.alterations = overrun.alterations.alter_tires() ? &overrun.alterations : nullptr;
    group.ground.following = overrun.rut_following;
    group.ground.facts = {i,          gear.is_nose(), gear.wheels(),
                          tire.width, tire.radius(),  model.bed.nominal ? model.bed.nominal->density : 0.0};
  }
}

}  // namespace

Plant make_plant(const Model& model, const Overrun& overrun) {
  const auto& aircraft = model.aircraft;
  require(overrun.entry_speed > creep_speed, "the entry speed must be above ", creep_speed,
          " m/s, at which an aircraft counts as at rest, not ", overrun.entry_speed, " m/s");
  expect(model.tables.size() == aircraft.gears.size(), "one table per gear group");
  const auto stand = static_stand(aircraft);

  Plant plant;
  plant.mass = overrun.mass > 0.0 ? overrun.mass : aircraft.mass;
  const double inertia =
      overrun.pitch_inertia > 0.0 ? overrun.pitch_inertia : aircraft.pitch_inertia * plant.mass / aircraft.mass;
  const double cg_behind =
      overrun.cg_behind_nose_gear > 0.0 ? overrun.cg_behind_nose_gear : aircraft.cg_behind_nose_gear;
  require(cg_behind < stand.main_centroid, "the centre of gravity ", cg_behind,
          " m behind the nose gear lies behind the main gear (", stand.main_centroid,
          " m): the aircraft would sit on its tail. Move it forward");

  const auto body = aircraft::sprung_body(aircraft, plant.mass, inertia, cg_behind);
  require(body.mass > 0.0, "a mass of ", plant.mass, " kg is less than the gears alone weigh (", body.unsprung, " kg)");
  require(body.inertia > 0.0, "a pitch inertia of ", inertia,
          " kg m^2 is less than the unsprung masses alone contribute. Raise it");
  plant.sprung_mass = body.mass;
  plant.sprung_inertia = body.inertia;
  const Vector sprung{body.x, body.z};
  plant.cg = {-cg_behind - sprung.x, aircraft.cg_height - sprung.z};

  const double beta = std::atan(model.bed.grade);
  plant.gravity = {-units::g0 * std::sin(beta), -units::g0 * std::cos(beta)};
  const double pressure_area = 0.5 * air_density * aircraft.aero.area;
  plant.drag_area = pressure_area * aircraft.aero.CD;
  plant.lift_area = pressure_area * aircraft.aero.CL;
  plant.moment_area = pressure_area * aircraft.aero.CM;
  plant.headwind = overrun.headwind;
  plant.thrust = overrun.thrust;
  plant.thrust_at = {plant.cg.x, aircraft.thrust_height - sprung.z};
  plant.alterations = &overrun.alterations;
  plant.timed_thrust = overrun.alterations.alter_thrust();
  plant.brake_mode = overrun.brake_mode;
  plant.wheel_spin = overrun.wheel_spin;
  plant.sinking = overrun.sinking;

  plant.profile = Profile(model.bed, overrun.bed_depth);
  plant.base_falls = model.bed.flush == bed::Flush::top;
  plant.setback = model.bed.setback;
  plant.entry_speed = overrun.entry_speed;
  for (std::size_t i = 0; i < aircraft.gears.size(); ++i) add_group(aircraft, i, stand.gears[i], sprung, plant);
  set_ground(model, overrun, plant);
  expect(plant.rows.size() <= most_rows && plant.groups.size() <= most_groups, "too many gears");
  return plant;
}

}  // namespace apc::simulation
