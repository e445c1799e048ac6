/// The only reader of "apc-aircraft/1", and the check that the aircraft it describes can stand.
#include <cmath>
#include <set>

#include "aircraft/aircraft.h"
#include "aircraft/limits.h"
#include "aircraft/sprung_body.h"
#include "aircraft/static_stand.h"
#include "aircraft/strut.h"
#include "apc/base/json.h"
#include "apc/base/quantity.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::aircraft {
namespace {

double positive(const Json& json, const std::string& key, const Dimension& dimension, const std::string& why) {
  const double value = json.quantity(key, dimension);
  json.check(value > 0.0, key, why);
  return value;
}

double not_negative(const Json& json, const std::string& key, double value) {
  json.check(value >= 0.0, key, "is negative. Give zero or a positive value");
  return value;
}

Strut read_strut(const Json& json) {
  Strut strut;
  strut.stroke = positive(json, "stroke", dimension::length, "leaves the strut no travel: the stroke must be positive");
  strut.piston_area = positive(json, "piston_area", dimension::area, "must be positive");
  strut.extended_pressure = positive(json, "extended_pressure", dimension::pressure, "must be positive");
  json.check(strut.extended_pressure > atmospheric_pressure, "extended_pressure",
             "is below the atmosphere's: the strut could not extend. Pressures are absolute");
  strut.extended_gas_volume = positive(json, "extended_gas_volume", dimension::volume, "must be positive");
  json.check(strut.extended_gas_volume > strut.piston_area * strut.stroke, "extended_gas_volume",
             concat("is not larger than piston_area x stroke = ", strut.piston_area * strut.stroke,
                    " m^3: the gas would be compressed to nothing before the end of the stroke"));
  strut.polytropic_exponent = json.number("polytropic_exponent", 1.1);
  json.check(strut.polytropic_exponent >= 1.0 && strut.polytropic_exponent <= 1.67, "polytropic_exponent",
             "is outside 1 (isothermal) to 1.67 (adiabatic)");
  const auto& square = dimension::square_damping;
  strut.damping_compression = not_negative(json, "damping_compression", json.quantity("damping_compression", square));
  strut.damping_rebound = not_negative(json, "damping_rebound", json.quantity("damping_rebound", square));
  strut.friction = not_negative(json, "friction", json.quantity("friction", dimension::force, 0.0));
  strut.bearing_friction = not_negative(json, "bearing_friction", json.number("bearing_friction", 0.0));
  if (strut.bearing_friction > 0.0 || json.has("bearing_upper") || json.has("bearing_lower")) {
    strut.bearing_upper = positive(json, "bearing_upper", dimension::length, "must be positive");
    strut.bearing_lower = positive(json, "bearing_lower", dimension::length, "must be positive");
    json.check(strut.bearing_lower > strut.stroke, "bearing_lower",
               "is not longer than the stroke: the axle would pass the lower bearing");
  } else {
    strut.bearing_upper = strut.bearing_lower = 1.0 + strut.stroke;
  }
  strut.end_stop = not_negative(json, "end_stop", json.quantity("end_stop", dimension::stiffness, 0.0));
  strut.rake = json.quantity("rake", dimension::angle, 0.0);
  json.check(std::abs(strut.rake) < 0.6, "rake", "is steeper than 35 deg: no strut leans that far");
  json.ignore("sources");
  return strut;
}

GearLimits read_limits(const Json& json) {
  GearLimits limits;
  limits.drag_limit = not_negative(json, "drag_limit", json.quantity("drag_limit", dimension::force, 0.0));
  limits.drag_ultimate = not_negative(json, "drag_ultimate", json.quantity("drag_ultimate", dimension::force, 0.0));
  limits.vertical_limit = not_negative(json, "vertical_limit", json.quantity("vertical_limit", dimension::force, 0.0));
  json.ignore("sources");
  return limits;
}

int count(const Json& json, const std::string& key, int most) {
  const int value = json.integer(key);
  json.check(value >= 1 && value <= most, key, concat("must lie between 1 and ", most));
  return value;
}

Gear read_gear(const Json& json, const Json& strut, const Json* limits, const TireLibrary& library,
               Aircraft& aircraft) {
  Gear gear;
  gear.name = json.text("name");
  gear.behind_nose_gear = json.quantity("behind_nose_gear", dimension::length);
  gear.struts = count(json, "struts", 8);
  gear.wheels_per_axle = count(json, "wheels_per_axle", 4);
  gear.axles = count(json, "axles", 3);
  gear.tire = json.text("tire");
  if (!library.contains(gear.tire)) {
    std::vector<std::string> names;
    std::string list;
    for (const auto& [name, tire] : library) names.push_back(name), list += (list.empty() ? "" : ", ") + name;
    const auto near = nearest(gear.tire, names.data(), names.size());
    json.refuse("tire", concat("is not in the tire library, which holds ", list.empty() ? "nothing" : list, ". ",
                               near.empty() ? std::string("Add the tire") : concat("Did you mean \"", near, "\"?")));
  }
  aircraft.tires[gear.tire] = library.at(gear.tire);
  gear.unsprung_mass = positive(json, "unsprung_mass", dimension::mass, "must be positive");
  gear.wheel_inertia = positive(json, "wheel_inertia", dimension::inertia, "must be positive");
  gear.braked = json.flag("braked", false);
  if (gear.axles > 1) {
    gear.axle_spacing = positive(json, "axle_spacing", dimension::length, "must be positive");
    gear.bogie_inertia = json.quantity("bogie_inertia", dimension::inertia, 0.0);
    json.check(gear.bogie_inertia >= 0.0, "bogie_inertia", "is negative. Leave it out to have it estimated");
    if (gear.bogie_inertia == 0.0)  // two thirds of the unsprung mass sit at the outer axles
      gear.bogie_inertia = gear.unsprung_mass * std::pow(0.5 * (gear.axles - 1) * gear.axle_spacing, 2) * 2.0 / 3.0;
    gear.bogie_damping = json.quantity("bogie_damping", dimension::angular_damping, 0.0);
    json.check(gear.bogie_damping >= 0.0, "bogie_damping", "is negative. Leave it out to have it estimated");
    gear.brake_rods = json.flag("brake_rods", true);
  }
  gear.track = not_negative(json, "track", json.quantity("track", dimension::length, 0.0));
  gear.wheel_spacing = not_negative(json, "wheel_spacing", json.quantity("wheel_spacing", dimension::length, 0.0));
  gear.strut = read_strut(strut);
  if (limits) gear.limits = read_limits(*limits);
  json.ignore("sources");
  return gear;
}

void read_body(const Json& file, const Json& cg, Aircraft& aircraft) {
  aircraft.mass = positive(file, "mass", dimension::mass, "must be positive");
  aircraft.pitch_inertia = positive(file, "pitch_inertia", dimension::inertia,
                                    "must be positive: no body resists pitching with a negative or zero inertia");
  aircraft.ramp_mass = not_negative(file, "ramp_mass", file.quantity("ramp_mass", dimension::mass, 0.0));
  file.check(aircraft.ramp_mass == 0.0 || aircraft.ramp_mass >= aircraft.mass, "ramp_mass",
             concat("is below the mass of ", aircraft.mass,
                    " kg: no aircraft rolls heavier than its design ramp weight. Raise ramp_mass or lower mass"));
  aircraft.takeoff_mass = not_negative(file, "takeoff_mass", file.quantity("takeoff_mass", dimension::mass, 0.0));
  file.check(aircraft.takeoff_mass == 0.0 || aircraft.ramp_mass == 0.0 || aircraft.takeoff_mass <= aircraft.ramp_mass,
             "takeoff_mass",
             concat("is above the ramp_mass of ", aircraft.ramp_mass,
                    " kg: the fuel burnt on the way to the runway lies between them. Lower takeoff_mass or raise "
                    "ramp_mass"));
  aircraft.landing_mass = not_negative(file, "landing_mass", file.quantity("landing_mass", dimension::mass, 0.0));
  aircraft.cg_behind_nose_gear = cg.quantity("behind_nose_gear", dimension::length);
  aircraft.cg_height = positive(cg, "height", dimension::length, "must be above the pavement");
  cg.ignore("sources");
  if (file.has("aero")) {
    const auto aero = file.object("aero");
    aircraft.aero.area = not_negative(aero, "area", aero.quantity("area", dimension::area));
    aircraft.aero.CD = not_negative(aero, "CD", aero.number("CD"));
    aircraft.aero.CL = aero.number("CL", 0.0);
    aircraft.aero.CM = aero.number("CM", 0.0);
    aero.ignore("sources");
  }
  aircraft.thrust_height = aircraft.cg_height;
  if (file.has("idle_thrust")) {
    const auto thrust = file.object("idle_thrust");
    aircraft.idle_thrust = thrust.quantity("total", dimension::force);
    aircraft.thrust_height = thrust.quantity("height", dimension::length);
    thrust.ignore("sources");
  }
}

/// An ultimate load below the limit load in force, which may be a rule's where the file gives none.
void check_ultimate(const std::vector<Json>& limits, const Aircraft& aircraft) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double ultimate = aircraft.gears[i].limits.drag_ultimate;
    if (ultimate == 0.0) continue;
    const auto in_force = load_limits(aircraft, aircraft.gears[i]);
    limits[i].check(ultimate >= in_force.drag_limit, "drag_ultimate",
                    concat("is below the limit load of ", in_force.drag_limit / units::kN, " kN (", in_force.drag_rule,
                           "). 14 CFR 25.303 asks for 1.5 times the limit"));
  }
}

/// The struts must carry what stands on them, and the rest must leave a body that can move.
void check_stand(const Json& file, const std::vector<Json>& gears, const std::vector<Json>& struts,
                 Aircraft& aircraft) {
  const auto stand = static_stand(aircraft);
  double unsprung = 0.0;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    auto& gear = aircraft.gears[i];
    const auto& standing = stand.gears[i];
    const double carried = gas_force(gear.strut, gear.strut.stroke);
    gears[i].check(standing.strut_force > 0.0, "unsprung_mass",
                   "weighs more than the gear carries: the strut would hang. Check the cg and the unsprung mass");
    struts[i].check(standing.strut_force < carried, "extended_pressure",
                    concat("cannot carry the static load: the strut holds ", carried / units::kN,
                           " kN at the end of its stroke and must carry ", standing.strut_force / units::kN,
                           " kN. Raise extended_pressure or piston_area, or lower extended_gas_volume"));
    gears[i].check(standing.vertical / (gear.wheels() / gear.struts) < aircraft.tires.at(gear.tire).bottoming_load,
                   "tire", "bottoms under the static load. Choose a larger tire or more wheels");
    if (gear.strut.end_stop == 0.0) gear.strut.end_stop = 1500.0 * standing.vertical;
    unsprung += gear.struts * gear.unsprung_mass;
  }
  gears.front().check(unsprung < 0.5 * aircraft.mass, "unsprung_mass",
                      concat("is too large: all gears together weigh ", unsprung, " kg of ", aircraft.mass, " kg"));
  const auto body = sprung_body(aircraft, aircraft.mass, aircraft.pitch_inertia, aircraft.cg_behind_nose_gear);
  file.check(
      body.inertia > 0.0, "pitch_inertia",
      concat("of ", aircraft.pitch_inertia, " kg m^2 is less than the unsprung masses on the axles alone contribute (",
             aircraft.pitch_inertia - body.inertia, " kg m^2). Raise it, or lower the unsprung masses"));
}

}  // namespace

Aircraft load_aircraft(const std::filesystem::path& path, const TireLibrary& library) {
  const auto file = read_json(path);
  file.schema("apc-aircraft/1");
  Aircraft aircraft;
  aircraft.name = file.text("name");
  aircraft.source = file.text("source");
  const auto cg = file.object("cg");
  read_body(file, cg, aircraft);
  const auto gears = file.objects("gears");
  file.check(gears.size() >= 2 && gears.size() <= 5, "gears",
             "must list the nose gear and one to four main gear groups");
  std::vector<Json> struts, limits;
  std::set<std::string> names;
  for (const auto& each : gears) {
    struts.push_back(each.object("strut"));
    const bool limited = each.has("limits");
    limits.push_back(limited ? each.object("limits") : each);
    aircraft.gears.push_back(read_gear(each, struts.back(), limited ? &limits.back() : nullptr, library, aircraft));
    const auto& gear = aircraft.gears.back();
    each.check(names.insert(gear.name).second, "name", "is given twice. Give every gear group a name of its own");
    each.check((aircraft.gears.size() == 1) == gear.is_nose(), "name",
               "is out of place: the first gear, and only the first, is the \"nose\" gear");
    if (gear.is_nose())
      each.check(gear.behind_nose_gear == 0.0, "behind_nose_gear", "must be 0 for the nose gear, the origin");
    else
      each.check(gear.behind_nose_gear > 0.0, "behind_nose_gear", "must lie behind the nose gear (positive)");
  }
  double wheels = 0.0, moment = 0.0;
  for (const auto& gear : aircraft.gears)
    if (!gear.is_nose()) wheels += gear.wheels(), moment += gear.wheels() * gear.behind_nose_gear;
  cg.check(aircraft.cg_behind_nose_gear > 0.0, "behind_nose_gear",
           "lies ahead of the nose gear: the aircraft would fall on its nose. It must be positive");
  cg.check(aircraft.cg_behind_nose_gear < moment / wheels, "behind_nose_gear",
           concat("lies behind the main gear (", moment / wheels,
                  " m behind the nose gear): the aircraft would sit on its tail. Move the cg forward"));
  check_stand(file, gears, struts, aircraft);
  check_ultimate(limits, aircraft);
  file.ignore("sources");
  file.finish();
  return aircraft;
}

}  // namespace apc::aircraft
