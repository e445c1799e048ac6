#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/base/units.h"
#include "apc/report/design_record.h"
#include "apc/report/manifest_json.h"

namespace apc::report {
namespace {

using Value = nlohmann::ordered_json;

/// "12.19 m": as many digits as a double needs to come back.
std::string metres(double value) { return Value(value).dump() + " m"; }

Value bed_value(const bed::Bed& bed) {
  Value out{{"schema", "apc-bed/1"},
            {"name", bed.name},
            {"source", bed.source},
            {"setback", metres(bed.setback)},
            {"width", metres(bed.width)},
            {"material", bed.material},
            {"flush", bed.flush == bed::Flush::top ? "top" : "base"}};
  out["profile"] = {{"distance", {{"unit", "m"}, {"values", bed.distance}}},
                    {"depth", {{"unit", "m"}, {"values", bed.depth}}}};
  if (bed.block_length > 0) out["blocks"] = {{"length", metres(bed.block_length)}, {"width", metres(bed.block_width)}};
  out["grade"] = bed.grade;
  return out;
}

Value optimum_value(const design::Optimum& optimum) {
  return {{"method", design::text(optimum.method)}, {"objective", number_or_null(optimum.objective)},
          {"feasible", optimum.feasible},           {"overstep", number_or_null(optimum.overstep)},
          {"evaluations", optimum.evaluations},     {"ended", optimum.ended}};
}

Value certificate_value(const DesignRecord& record) {
  const auto& certificate = record.design.certificate;
  Value out{{"methods", {design::text(certificate.first.method), design::text(certificate.second.method)}},
            {"difference", certificate.difference},
            {"agreed", certificate.agreed},
            {"certified", design::certified(certificate)},
            {"gradient_error", certificate.gradient_error},
            {"sensitivity_error", number_or_null(certificate.sensitivity_error)},
            {"stationarity", certificate.stationarity},
            {"gap", certificate.gap},
            {"ends", Value::array()},
            {"optima", {optimum_value(certificate.first), optimum_value(certificate.second)}},
            {"active", Value::array()}};
  for (const double end : certificate.ends) out["ends"].push_back(number_or_null(end));
  for (const auto& active : certificate.active)
    out["active"].push_back({{"constraint", describe(active.constraint, record.fleet)},
                             {"use", active.use},
                             {"multiplier", active.multiplier},
                             {"weight", active.weight}});
  return out;
}

Value case_value(const DesignRecord& record, const design::CaseOutcome& outcome) {
  const auto& each = record.fleet.cases[outcome.fleet_case];
  const auto& result = record.design.built.results[outcome.fleet_case];
  Value out{{"aircraft", each.aircraft},
            {"case", each.name},
            {"entry_speed", result.entry_speed},
            {"mass", result.mass},
            {"braking", each.overrun.braking},
            {"outcome", simulation::text(result.outcome)},
            {"stop_distance", number_or_null(outcome.stop_distance)},
            {"max_exit_speed", outcome.max_exit_speed},
            {"arrest_speed", outcome.arrest_speed},
            {"active_constraint", describe(outcome.active, record.fleet)},
            {"use", outcome.use},
            {"peak_deceleration", result.peak_deceleration}};
  for (const auto& gear : result.gears)
    out["gears"][gear.name] = {{"peak_drag", gear.peak_drag},
                               {"drag_limit", gear.drag_limit},
                               {"peak_vertical", gear.peak_vertical},
                               {"vertical_limit", gear.vertical_limit}};
  return out;
}

}  // namespace

std::string bed_json(const bed::Bed& bed) { return bed_value(bed).dump(1) + "\n"; }

std::string design_json(const DesignRecord& record) {
  const auto& design = record.design;
  Value out{{"schema", "apc-design/1"},
            {"feasible", design.feasible},
            {"reason", design.reason},
            {"objective", design::text(design.objective)},
            {"criterion", study::text(record.fleet.limits.criterion)},
            {"forbidding", Value::array()}};
  for (const auto& each : design.forbidding) out["forbidding"].push_back(describe(each, record.fleet));
  out["aircraft"] = Value::array();
  if (design.feasible) {
    out["bed"] = bed_value(design.built.bed);
    out["length"] = design.built.bed.length();
    out["volume"] = design.built.bed.volume();
    out["speed_factor"] = design.speed_factor;
    for (const auto& outcome : design.cases) out["aircraft"].push_back(case_value(record, outcome));
    out["rows"] = {{"length", design.built.blocks.row_length}, {"depth", design.built.blocks.depth}};
    out["worst_use"] = design.built.worst_use;
    out["optimum"] = {{"length", design.length},
                      {"ramp", design.profile.ramp},
                      {"stations", design.profile.stations()},
                      {"depth", design.profile.depth}};
    out["alone"] = design.alone;
  }
  out["uniform"] = {{"feasible", design.uniform.feasible},
                    {"depth", design.uniform.depth},
                    {"length", number_or_null(design.uniform.length)},
                    {"limiting", describe(design.uniform.limiting, record.fleet)}};
  out["certificate"] = certificate_value(record);
  out["front"] = Value::array();
  for (const auto& point : record.front)
    out["front"].push_back({{"margin", point.margin}, {"length", point.length}, {"volume", point.volume}});
  out["runs"] = design.runs;
  out["gave_up"] = design.gave_up;
  out["seconds"] = record.seconds;
  out["fleet"] = Value::parse(record.fleet_text);
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
