#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/report/manifest_json.h"
#include "apc/report/reliability_record.h"

namespace apc::report {
namespace {

using Value = nlohmann::ordered_json;

Value estimate_value(const reliability::Estimate& estimate) {
  return {{"value", estimate.value}, {"interval95", {estimate.low, estimate.high}}};
}

Value indices_value(const std::vector<reliability::SobolIndex>& indices, double unexplained) {
  Value out = Value::object();
  for (std::size_t i = 0; i < indices.size(); ++i)
    out[reliability::scattered_names()[i]] = {{"first", indices[i].first}, {"total", indices[i].total}};
  out["unexplained"] = unexplained;
  return out;
}

}  // namespace

std::string reliability_json(const ReliabilityRecord& record) {
  Value out{{"schema", "apc-reliability/1"},
            {"design", record.design},
            {"criterion", record.criterion},
            {"cases", Value::array()}};
  for (std::size_t k = 0; k < record.results.size(); ++k) {
    const auto& each = record.results[k];
    out["cases"].push_back({{"case", record.cases[k]},
                            {"asked_speed", record.asked_speeds[k]},
                            {"samples", each.samples},
                            {"gave_up", each.gave_up},
                            {"runs", each.runs},
                            {"arrest", estimate_value(each.arrest)},
                            {"intact", estimate_value(each.intact)},
                            {"arrest_at_asked_speed", estimate_value(each.arrest_at_asked)},
                            {"intact_at_asked_speed", estimate_value(each.intact_at_asked)},
                            {"arrest_speed_975", each.arrest_speed_975},
                            {"intact_speed_975", each.intact_speed_975},
                            {"sobol_arrest_speed", indices_value(each.arrest_indices, each.arrest_unexplained)},
                            {"sobol_intact_speed", indices_value(each.intact_indices, each.intact_unexplained)}});
  }
  const auto& s = record.scatter;
  out["scatter"] = {{"source", s.source},
                    {"mass", s.mass},
                    {"cg", s.cg},
                    {"braking", {s.braking_low, s.braking_high}},
                    {"strength", s.strength},
                    {"depth", s.depth},
                    {"block_strength", s.block_strength},
                    {"correlation", s.correlation},
                    {"temperature", {s.temperature, s.temperature_scatter}},
                    {"per_kelvin", s.per_kelvin},
                    {"years", {s.years_low, s.years_high}},
                    {"per_year", s.per_year}};
  out["exit_speeds"] = {{"scale", record.exit_speeds.scale}, {"shape", record.exit_speeds.shape}};
  out["seconds"] = record.seconds;
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
