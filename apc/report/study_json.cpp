#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/report/manifest_json.h"
#include "apc/report/result_json.h"
#include "apc/report/study_record.h"

namespace apc::report {
namespace {

using Value = nlohmann::ordered_json;

Value list(const std::vector<double>& values) {
  auto out = Value::array();
  for (const double value : values) out.push_back(number_or_null(value));
  return out;
}

/// The keys of one overrun's record, without the parts that are the same for the whole study.
Value case_json(const StudyRecord& record, const study::CaseResult& each) {
  const auto& model = record.models[each.input.model];
  if (!each.failure.empty())
    return {{"inputs",
             {{"aircraft", model.aircraft.name},
              {"bed", model.bed.name},
              {"entry_speed", each.input.overrun.entry_speed},
              {"mass", each.input.overrun.mass},
              {"braking", each.input.overrun.braking},
              {"strength", each.input.overrun.alterations.bed_strength}}},
            {"outcome", "gave_up"},
            {"message", each.failure}};
  OverrunRecord one{
      model, each.input.overrun, {simulation::Method::fast, each.result.solver.rtol, 0.0, 120.0}, each.result, {}};
  auto out = Value::parse(result_json(one));
  out.erase("schema");
  out["provenance"].erase("files"), out["provenance"].erase("command"), out["provenance"].erase("program");
  out["inputs"]["strength"] = each.input.overrun.alterations.bed_strength;
  out["inputs"]["bed_length"] = model.bed.length();
  out["worst_margin"] = number_or_null(study::worst_margin(each.result, study::Criterion::limit));
  out["worst_ultimate_margin"] = number_or_null(study::worst_margin(each.result, study::Criterion::ultimate));
  return out;
}

Value envelope_json(const study::Envelope& envelope) {
  Value out{{"aircraft", envelope.aircraft}, {"depths", list(envelope.depths)}, {"speeds", list(envelope.speeds)}};
  for (const auto& row : envelope.stop_distance) out["stop_distance"].push_back(list(row));
  for (const auto& row : envelope.margin) out["margin"].push_back(list(row));
  out["limit_depth"] = list(envelope.limit_depth);
  return out;
}

Value tornado_json(const study::Tornado& tornado) {
  Value out{{"aircraft", tornado.aircraft},
            {"bed", tornado.bed},
            {"entry_speed", tornado.entry_speed},
            {"stop_distance", number_or_null(tornado.distance)},
            {"margin", number_or_null(tornado.margin)},
            {"bars", Value::array()}};
  for (const auto& bar : tornado.bars)
    out["bars"].push_back({{"input", bar.input},
                           {"low", bar.low},
                           {"high", bar.high},
                           {"stop_distance", list({bar.distance_low, bar.distance_high})},
                           {"margin", list({bar.margin_low, bar.margin_high})}});
  return out;
}

}  // namespace

std::string study_json(const StudyRecord& record) {
  Value out{{"schema", "apc-study/1"}, {"cases", Value::array()}};
  for (const auto& each : record.results) out["cases"].push_back(case_json(record, each));
  out["envelopes"] = Value::array();
  for (const auto& each : record.envelopes) out["envelopes"].push_back(envelope_json(each));
  out["tornados"] = Value::array();
  for (const auto& each : record.tornados) out["tornados"].push_back(tornado_json(each));
  out["seconds"] = record.seconds;
  out["remembered"] = record.remembered;
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
