#include "aircraft/limits.h"

#include <algorithm>

#include "aircraft/static_stand.h"
#include "apc/base/units.h"

namespace apc::aircraft {
namespace {

/// Vertical reaction of one strut when the aircraft weighs `mass` under `factor` g, at the file's cg.
double reaction(const Aircraft& aircraft, const Gear& gear, double mass, double factor) {
  const auto stand = static_stand(aircraft);
  const auto index = static_cast<std::size_t>(&gear - aircraft.gears.data());
  return stand.gears[index].vertical * factor * mass / aircraft.mass;
}

struct Weights {
  double ramp, takeoff, landing;
  std::string ramp_name, takeoff_name, landing_name;
};

Weights weights(const Aircraft& aircraft) {
  const bool ramp = aircraft.ramp_mass > 0.0, landing = aircraft.landing_mass > 0.0;
  Weights w{ramp ? aircraft.ramp_mass : aircraft.mass,
            aircraft.takeoff_mass,
            landing ? aircraft.landing_mass : aircraft.mass,
            ramp ? "the ramp weight" : "the file's mass (no ramp_mass given)",
            "the take-off weight",
            landing ? "the landing weight" : "the file's mass (no landing_mass given)"};
  if (w.takeoff == 0.0)
    w.takeoff = w.ramp, w.takeoff_name = ramp ? "the ramp weight (no takeoff_mass given)" : w.ramp_name;
  return w;
}

void nose_vertical(const Aircraft& aircraft, LoadLimits& limits) {
  const auto w = weights(aircraft);
  const double weight = w.ramp * units::g0, ahead = aircraft.cg_behind_nose_gear, height = aircraft.cg_height;
  const double takeoff_weight = w.takeoff * units::g0;
  const double base = static_stand(aircraft).main_centroid, behind = base - ahead;
  constexpr double friction = 0.8, dynamic_factor = 2.0;
  const double braking =
      takeoff_weight / base * (behind + dynamic_factor * friction * ahead * height / (base + friction * height));
  int units_of_main = 0;
  for (const auto& gear : aircraft.gears) units_of_main += gear.is_nose() ? 0 : gear.struts;
  const double one_main = weight * ahead / base / std::max(1, units_of_main);
  const double yawing = weight * behind / base + 0.8 * one_main * height / base;
  limits.vertical_limit = std::max(braking, yawing);
  limits.vertical_rule =
      braking >= yawing ? "14 CFR 25.493(e) from " + w.takeoff_name : "14 CFR 25.499(b) from " + w.ramp_name;
}

}  // namespace

double tow_load(double ramp_weight) {
  const double pounds = ramp_weight / units::lbf;
  if (pounds < 30e3) return 0.3 * ramp_weight;
  if (pounds <= 100e3) return (6.0 * pounds + 450e3) / 70.0 * units::lbf;
  return 0.15 * ramp_weight;
}

LoadLimits load_limits(const Aircraft& aircraft, const Gear& gear) {
  LoadLimits limits;
  const auto w = weights(aircraft);
  if (gear.is_nose()) {
    limits.drag_limit = tow_load(w.ramp * units::g0) / gear.struts;
    limits.drag_rule = "14 CFR 25.509 from " + w.ramp_name;
    nose_vertical(aircraft, limits);
  } else {
    const double landing = reaction(aircraft, gear, w.landing, 1.2), ramp = reaction(aircraft, gear, w.ramp, 1.0);
    const auto& name = landing >= ramp ? w.landing_name : w.ramp_name;
    limits.vertical_limit = std::max(landing, ramp);
    limits.vertical_rule = "14 CFR 25.493(b) from " + name;
    limits.drag_limit = gear.braked ? 0.8 * limits.vertical_limit : 0.75 * tow_load(w.ramp * units::g0);
    limits.drag_rule = gear.braked ? limits.vertical_rule : "14 CFR 25.509 (0.75 tow load) from " + w.ramp_name;
  }
  limits.drag_ultimate = 1.5 * limits.drag_limit;
  if (gear.limits.drag_limit > 0.0) {
    limits.drag_limit = gear.limits.drag_limit;
    limits.drag_ultimate = 1.5 * limits.drag_limit;
    limits.drag_rule = "aircraft file";
  }
  if (gear.limits.drag_ultimate > 0.0) limits.drag_ultimate = gear.limits.drag_ultimate;
  if (gear.limits.vertical_limit > 0.0)
    limits.vertical_limit = gear.limits.vertical_limit, limits.vertical_rule = "aircraft file";
  return limits;
}

}  // namespace apc::aircraft
