/// `simulate`: one overrun.
#include "apc/python/arguments.h"
#include "apc/python/bindings.h"
#include "apc/python/call.h"

namespace apc::python {
namespace {

py::dict history_dict(const simulation::Result& result) {
  const auto& from = result.history;
  py::dict out;
  out["time"] = array(from.time), out["distance"] = array(from.distance), out["speed"] = array(from.speed);
  out["deceleration"] = array(from.deceleration), out["pitch"] = array(from.pitch), out["heave"] = array(from.heave);
  out["acceleration_x"] = array(from.acceleration_x), out["acceleration_z"] = array(from.acceleration_z);
  out["pitch_rate"] = array(from.pitch_rate), out["dissipated"] = array(from.dissipated);
  py::dict gears;
  for (std::size_t g = 0; g < from.gears.size(); ++g) {
    const auto& gear = from.gears[g];
    py::dict each;
    each["drag"] = array(gear.drag), each["vertical"] = array(gear.vertical), each["stroke"] = array(gear.stroke);
    each["stroke_rate"] = array(gear.stroke_rate), each["penetration"] = array(gear.penetration);
    each["rut"] = array(gear.rut), each["bed_depth"] = array(gear.bed_depth), each["spin"] = array(gear.spin);
    each["distance"] = array(gear.distance);
    gears[py::str(result.gears[g].name)] = each;
  }
  out["gears"] = gears;
  return out;
}

py::dict simulate(const std::string& aircraft, const py::object& bed, const py::object& speed, const py::object& mass,
                  const py::object& cg, const py::object& braking, const py::object& braking_in_bed,
                  const py::object& thrust, const py::object& headwind, double bed_strength, double bed_depth,
                  const std::string& method, double rtol, double sampling, const py::object& loads,
                  const py::object& tires) {
  auto inputs = read(aircraft, bed, loads, tires);
  simulation::Overrun run;
  run.entry_speed = quantity(speed, dimension::speed, "speed");
  require(run.entry_speed > simulation::creep_speed && run.entry_speed <= 103, "speed: ", run.entry_speed,
          " m/s is outside ", simulation::creep_speed, " (where an aircraft counts as at rest) to 103 m/s");
  const auto& plane = inputs.model.aircraft;
  run.mass = quantity(mass, dimension::mass, "mass", 0.0);
  require(run.mass == 0 || (run.mass >= 0.4 * plane.mass && run.mass <= 1.6 * plane.mass), "mass: ", run.mass,
          " kg is no mass of a ", plane.name, " (40 to 160 % of ", plane.mass, " kg is taken)");
  run.cg_behind_nose_gear = quantity(cg, dimension::length, "cg", 0.0);
  run.braking = quantity(braking, dimension::none, "braking", 0.0);
  run.braking_in_bed = quantity(braking_in_bed, dimension::none, "braking_in_bed", -1.0);
  require(run.braking >= 0 && run.braking <= 1 && run.braking_in_bed <= 1,
          "braking: is no friction coefficient: 0 to 1");
  run.thrust = quantity(thrust, dimension::force, "thrust", 0.0);
  run.headwind = quantity(headwind, dimension::speed, "headwind", 0.0);
  require(bed_strength >= 0.2 && bed_strength <= 3, "bed_strength: ", bed_strength, " is outside 0.2 to 3 (× nominal)");
  require(bed_depth >= 0.2 && bed_depth <= 3, "bed_depth: ", bed_depth, " is outside 0.2 to 3 (× the bed's)");
  run.alterations.bed_strength = bed_strength, run.bed_depth = bed_depth;
  require(method == "reference" || method == "fast", "method: \"", method, "\" is no method: reference or fast");
  require(rtol >= 1e-12 && rtol <= simulation::loosest_rtol, "rtol: ", rtol, " is outside 1e-12 to ",
          simulation::loosest_rtol);
  const simulation::Options options{method == "fast" ? simulation::Method::fast : simulation::Method::reference, rtol,
                                    sampling, 120.0};
  return result_dict(call([&] { return simulation::simulate(inputs.model, run, options); }));
}

}  // namespace

py::dict result_dict(const simulation::Result& result) {
  py::dict out;
  out["outcome"] = simulation::text(result.outcome), out["message"] = result.message;
  out["if_gear_had_held"] = result.gear_failed();
  out["entry_speed"] = result.entry_speed, out["stop_distance"] = number(result.stop_distance);
  out["runway_distance"] = number(result.runway_distance), out["exit_speed"] = result.exit_speed;
  out["peak_deceleration"] = result.peak_deceleration, out["mean_deceleration"] = result.mean_deceleration;
  out["mass"] = result.mass, out["cg_behind_nose_gear"] = result.cg_behind_nose_gear;
  py::dict gears, energy, coverage;
  for (const auto& gear : result.gears) {
    py::dict each;
    each["struts"] = gear.struts, each["peak_drag"] = gear.peak_drag, each["peak_vertical"] = gear.peak_vertical;
    each["drag_limit"] = gear.drag_limit, each["drag_ultimate"] = gear.drag_ultimate;
    each["vertical_limit"] = gear.vertical_limit, each["drag_margin"] = gear.drag_margin;
    each["vertical_margin"] = gear.vertical_margin, each["peak_stroke"] = gear.peak_stroke;
    each["failed_by"] = gear.failed_by, each["failed_at"] = number(gear.failed_at);
    each["airborne_time"] = gear.airborne, each["lifted_at"] = number(gear.lifted_at);
    each["peak_tire_load"] = gear.peak_tire_load, each["tire_bottomed"] = gear.tire_bottomed;
    each["peak_rut"] = gear.peak_rut, each["peak_penetration"] = gear.peak_penetration;
    gears[py::str(gear.name)] = each;
  }
  for (const auto& [name, joules] : result.energy) energy[py::str(name)] = joules;
  for (const auto& each : result.coverage) coverage[py::str(each.gear)] = each.inside;
  out["gears"] = gears, out["energy"] = energy, out["table_coverage"] = coverage;
  py::list warnings;
  for (const auto& each : result.warnings) warnings.append(each);
  out["warnings"] = warnings;
  if (!result.history.time.empty()) out["history"] = history_dict(result);
  return out;
}

void bind_simulate(py::module_& module) {
  const py::none none;
  module.def(
      "simulate", &simulate, py::arg("aircraft"), py::arg("bed"), py::arg("speed"), py::kw_only(),
      py::arg("mass") = none, py::arg("cg") = none, py::arg("braking") = 0.0, py::arg("braking_in_bed") = none,
      py::arg("thrust") = none, py::arg("headwind") = none, py::arg("bed_strength") = 1.0, py::arg("bed_depth") = 1.0,
      py::arg("method") = "reference", py::arg("rtol") = 1e-6, py::arg("sampling") = 0.005, py::arg("loads") = none,
      py::arg("tires") = none,
      R"(One overrun, as a dict in SI: outcome ("stopped", "left_bed", "gear_limit", "pitched_over"), if_gear_had_held
(True: a gear failed, distances hold only if it had not), stop_distance (m, nose wheel from the bed's leading edge; NaN
when it left the bed or pitched over), exit_speed, peak_deceleration, gears[NAME] (peak loads in N per strut, limits, margins), energy (J by
sink), and history: time, distance, speed, … of shape (samples,), history["gears"][NAME] with drag and vertical in N
per gear group. `sampling` s between samples; 0 = no history.

speed   at the bed's edge, of the nose wheel: "70 kt" or m/s
braking friction coefficient of the braked wheels; braking_in_bed the same inside the bed (default: as before it)
method  "reference" (CVODE) or "fast" (Rosenbrock, the same within a millimetre)

Raises InputError for what is wrong with an argument or file, SolveError when the solver gives up.)");
}

}  // namespace apc::python
