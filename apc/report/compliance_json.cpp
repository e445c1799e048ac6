#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/report/compliance_record.h"
#include "apc/report/manifest_json.h"

namespace apc::report {

std::string compliance_json(const ComplianceRecord& record) {
  using Value = nlohmann::ordered_json;
  Value out{{"schema", "apc-compliance/1"},
            {"bed", record.design.bed.name},
            {"requirements", Value::array()},
            {"cases", Value::array()}};
  for (const auto& each : findings(record))
    out["requirements"].push_back(
        {{"clause", each.clause}, {"clause_read", each.read}, {"basis", each.basis}, {"result", text(each.verdict)}});
  for (std::size_t k = 0; k < record.cases.size(); ++k) {
    const auto& each = record.cases[k];
    out["cases"].push_back({{"aircraft", record.design.fleet.cases[k].aircraft},
                            {"case", record.design.fleet.cases[k].name},
                            {"stop_distance", number_or_null(each.result.stop_distance)},
                            {"use", each.use},
                            {"arrest_speed", each.arrest_speed},
                            {"intact_speed", each.intact_speed},
                            {"table_error", each.table_error},
                            {"stop_distance_range", {number_or_null(each.stop_low), number_or_null(each.stop_high)}},
                            {"use_range", {each.use_low, each.use_high}}});
    if (record.learned.names.empty()) continue;
    out["cases"].back()["with_learned_effects"] = {{"stop_distance", number_or_null(each.learned_stop)},
                                                   {"use", each.learned_use}};
  }
  if (!record.learned.names.empty())
    out["learned_effects"] = {{"ids", record.learned.names},
                              {"speeds", {record.learned.slowest, record.learned.fastest}}};
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
