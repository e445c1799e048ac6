#include "apc/report/result_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/report/manifest_json.h"

namespace apc::report {
namespace {

using Value = nlohmann::ordered_json;

/// JSON knows no NaN: a quantity that does not exist is null.
Value gear_json(const simulation::GearSummary& gear) {
  Value out;
  out["struts"] = gear.struts;
  out["wheels_per_strut"] = gear.wheels;
  out["peak_drag"] = number_or_null(gear.peak_drag);
  out["peak_drag_distance"] = number_or_null(gear.peak_drag_distance);
  out["peak_vertical"] = number_or_null(gear.peak_vertical);
  out["peak_vertical_distance"] = number_or_null(gear.peak_vertical_distance);
  out["mean_drag"] = number_or_null(gear.mean_drag);
  const auto limit = [&](const char* key, double value, const char* margin_key, double margin) {
    out[key] = value > 0 ? number_or_null(value) : Value(nullptr);
    out[margin_key] = value > 0 ? number_or_null(margin) : Value(nullptr);
  };
  limit("drag_limit", gear.drag_limit, "drag_margin", gear.drag_margin);
  limit("drag_ultimate", gear.drag_ultimate, "ultimate_margin", gear.ultimate_margin);
  limit("vertical_limit", gear.vertical_limit, "vertical_margin", gear.vertical_margin);
  out["vertical_ultimate"] = gear.vertical_ultimate > 0 ? number_or_null(gear.vertical_ultimate) : Value(nullptr);
  out["drag_rule"] = gear.drag_rule;
  out["vertical_rule"] = gear.vertical_rule;
  out["peak_stroke"] = number_or_null(gear.peak_stroke);
  out["stroke"] = number_or_null(gear.stroke);
  out["bottomed"] = gear.bottomed;
  out["failed_by"] = gear.failed_by.empty() ? Value(nullptr) : Value(gear.failed_by);
  out["failed_at"] = number_or_null(gear.failed_at);
  out["failed_time"] = number_or_null(gear.failed_time);
  out["airborne_time"] = number_or_null(gear.airborne);
  out["lifted_at"] = number_or_null(gear.lifted_at);
  out["tire"] = gear.tire;
  out["peak_tire_load"] = number_or_null(gear.peak_tire_load);
  out["tire_bottoming_load"] = number_or_null(gear.tire_bottoming_load);
  out["tire_bottomed"] = gear.tire_bottomed;
  out["peak_rut"] = number_or_null(gear.peak_rut);
  out["peak_penetration"] = number_or_null(gear.peak_penetration);
  out["static_vertical"] = number_or_null(gear.static_vertical);
  return out;
}

Value inputs_json(const OverrunRecord& record) {
  const auto& overrun = record.overrun;
  Value out;
  out["aircraft"] = record.model.aircraft.name;
  out["bed"] = record.model.bed.name;
  out["material"] = record.model.bed.material;
  out["entry_speed"] = overrun.entry_speed;
  out["mass"] = record.result.mass;
  out["cg_behind_nose_gear"] = record.result.cg_behind_nose_gear;
  out["pitch_inertia"] = overrun.pitch_inertia > 0.0
                             ? overrun.pitch_inertia
                             : record.model.aircraft.pitch_inertia * record.result.mass / record.model.aircraft.mass;
  out["braking"] = overrun.braking;
  out["braking_in_bed"] = overrun.braking_in_bed < 0 ? overrun.braking : overrun.braking_in_bed;
  out["thrust"] = overrun.thrust;
  out["headwind"] = overrun.headwind;
  out["brake_mode"] = overrun.brake_mode == simulation::BrakeMode::friction ? "friction" : "torque";
  out["wheel_spin"] = overrun.wheel_spin == simulation::WheelSpin::inertial ? "inertial" : "free";
  out["rut_bearing_gain"] = overrun.rut_following.bearing_gain;
  out["rut_rolling_resistance"] = overrun.rut_following.rolling_resistance;
  out["bed_depth"] = overrun.bed_depth;
  out["sinking"] = overrun.sinking.vertical;
  if (!overrun.alterations.effects.empty()) {
    out["effects"] = Value::array();
    for (const auto& applied : overrun.alterations.effects) {
      Value one{{"id", applied.effect.id}};
      if (!applied.effect.form.empty()) one["form"] = applied.effect.form;
      for (std::size_t i = 0; i < applied.values.size(); ++i)
        one["parameters"][applied.effect.parameters[i].name] = applied.values[i];
      out["effects"].push_back(std::move(one));
    }
  }
  out["method"] = record.options.method == simulation::Method::fast ? "fast" : "reference";
  out["rtol"] = record.options.rtol;
  out["sampling"] = record.options.sampling;
  return out;
}

/// d(result)/d(parameter), SI per unit of the parameter.
Value sensitivities_json(const OverrunRecord& record) {
  Value out = Value::object();
  for (const auto& [of, unit] : record.sensitivities) {
    auto& one = out[of.parameter];
    one["unit"] = unit;
    one["stop_distance"] = number_or_null(of.stop_distance);
    one["exit_speed"] = number_or_null(of.exit_speed);
    one["stop_time"] = number_or_null(of.stop_time);
    one["peak_deceleration"] = number_or_null(of.peak_deceleration);
    one["peak_deceleration_100ms"] = number_or_null(of.peak_deceleration_100ms);
    one["mean_deceleration"] = number_or_null(of.mean_deceleration);
    one["peak_pitch"] = number_or_null(of.peak_pitch);
    one["lowest_pitch"] = number_or_null(of.lowest_pitch);
    for (const auto& gear : of.gears) {
      auto& on = one["gears"][gear.name];
      on["peak_drag"] = number_or_null(gear.peak_drag);
      on["peak_vertical"] = number_or_null(gear.peak_vertical);
      on["mean_drag"] = number_or_null(gear.mean_drag);
      on["drag_margin"] = number_or_null(gear.drag_margin);
      on["ultimate_margin"] = number_or_null(gear.ultimate_margin);
      on["vertical_margin"] = number_or_null(gear.vertical_margin);
      on["peak_stroke"] = number_or_null(gear.peak_stroke);
      on["peak_rut"] = number_or_null(gear.peak_rut);
      on["peak_penetration"] = number_or_null(gear.peak_penetration);
      on["peak_tire_load"] = number_or_null(gear.peak_tire_load);
    }
    for (const auto& [name, slope] : of.energy) one["energy"][name] = number_or_null(slope);
  }
  return out;
}

}  // namespace

std::string result_json(const OverrunRecord& record) {
  const auto& result = record.result;
  Value out;
  out["schema"] = "apc-result/1";
  out["outcome"] = simulation::text(result.outcome);
  out["message"] = result.message;
  out["warnings"] = result.warnings;
  out["inputs"] = inputs_json(record);
  out["entry_speed"] = number_or_null(result.entry_speed);
  out["if_gear_had_held"] = result.gear_failed();
  out["stop_distance"] = number_or_null(result.stop_distance);
  out["runway_distance"] = number_or_null(result.runway_distance);
  out["exit_speed"] = number_or_null(result.exit_speed);
  out["stop_time"] = number_or_null(result.stop_time);
  out["peak_deceleration"] = number_or_null(result.peak_deceleration);
  out["peak_deceleration_100ms"] = number_or_null(result.peak_deceleration_100ms);
  out["mean_deceleration"] = number_or_null(result.mean_deceleration);
  out["peak_pitch"] = number_or_null(result.peak_pitch);
  out["lowest_pitch"] = number_or_null(result.lowest_pitch);
  out["airborne_time"] = number_or_null(result.airborne);
  out["lifted_at"] = number_or_null(result.lifted_at);
  out["gears"] = Value::object();
  for (const auto& gear : result.gears) out["gears"][gear.name] = gear_json(gear);
  out["energy"] = Value::object();
  for (const auto& [key, value] : result.energy) out["energy"][key] = number_or_null(value);
  out["table_coverage"] = Value::object();
  out["table_coverage_by_gear"] = Value::object();
  for (const auto& coverage : result.coverage) {
    // One tire may serve several gears (B747-400): the least covered one stands for the tire.
    const double other = out["table_coverage"].value(coverage.tire, 1.0);
    out["table_coverage"][coverage.tire] = std::min(other, coverage.inside);
    out["table_coverage_by_gear"][coverage.gear] = {{"tire", coverage.tire},
                                                    {"inside", coverage.inside},
                                                    {"speed_below", coverage.speed_below},
                                                    {"speed_above", coverage.speed_above},
                                                    {"depth_outside", coverage.depth_outside},
                                                    {"penetration_outside", coverage.penetration_outside}};
  }
  if (!record.sensitivities.empty()) out["sensitivities"] = sensitivities_json(record);
  out["solver"] = {{"method", result.solver.method},
                   {"rtol", result.solver.rtol},
                   {"steps", result.solver.steps},
                   {"rhs_calls", result.solver.rhs_calls},
                   {"jacobians", result.solver.jacobians},
                   {"error_test_failures", result.solver.error_test_failures},
                   {"newton_failures", result.solver.newton_failures},
                   {"wall_s", result.solver.wall_s}};
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
