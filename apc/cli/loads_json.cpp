/// What `apc loads … --json` writes. SI.
#include <nlohmann/json.hpp>

#include "apc/cli/loads_commands.h"
#include "loadtables/load_table_data.h"

namespace apc::cli {
namespace {

using Value = nlohmann::ordered_json;

Value contact_json(const TireContact& contact) {
  return {{"speed", contact.speed}, {"bed_depth", contact.bed_depth}, {"penetration", contact.penetration}};
}

Value load_json(const TireLoad& load) {
  return {
      {"drag", load.drag}, {"vertical", load.vertical}, {"rut_depth", load.rut_depth}, {"spin_ratio", load.spin_ratio}};
}

}  // namespace

std::string table_record(const loadtables::LoadTable& table, const loadtables::TableCheck& check) {
  const auto& from = table.provenance();
  Value json{{"schema", "apc-load-table-report/1"}, {"tire", table.tire().name}, {"material", from.material}};
  json["responses"] = Value::object();
  for (const auto& each : table.quality())
    json["responses"][each.response] = {{"points", each.points},
                                        {"rms_relative", each.rms_relative},
                                        {"loo_rms_relative", each.loo_rms_relative},
                                        {"loo_rms_to_axle", each.loo_rms_to_axle},
                                        {"r2", each.r2}};
  const auto range = [](const std::array<double, 2>& values) { return Value{values[0], values[1]}; };
  json["range"] = {{"speed", range(table.speed_range())},
                   {"bed_depth", range(table.depth_range())},
                   {"relative_penetration", range(table.ratio_range())}};
  json["check"] = {{"points", check.points},
                   {"least_drag", check.least_drag},
                   {"least_vertical", check.least_vertical},
                   {"falling_share", check.falling_share},
                   {"largest_fall", check.largest_fall},
                   {"largest_fall_at", contact_json(check.largest_fall_at)},
                   {"largest_fall_beyond_axle", check.largest_fall_beyond},
                   {"largest_fall_beyond_axle_at", contact_json(check.largest_fall_beyond_at)},
                   {"worst_drag", check.worst_drag},
                   {"worst_vertical", check.worst_vertical},
                   {"growth_correction", table.data().growth_correction},
                   {"failures", check.failures}};
  json["provenance"] = {{"source", from.source},   {"command", from.command},   {"date", from.date},
                        {"version", from.version}, {"friction", from.friction}, {"spacing", from.spacing},
                        {"runs", from.runs},       {"refused", from.refused}};
  json["samples"] = Value::array();
  for (const auto& sample : table.data().samples.samples) {
    auto row = contact_json(sample.contact);
    row["load"] = load_json(sample.load);
    row["table"] = load_json(table.load(sample.contact));
    json["samples"].push_back(row);
  }
  return json.dump(1) + "\n";
}

std::string status_record(const std::vector<loadtables::RunStatus>& list) {
  Value json{{"schema", "apc-load-status/1"}, {"runs", Value::array()}};
  for (const auto& each : list) {
    auto row = contact_json(each.planned.contact);
    row["id"] = each.planned.id;
    row["relative_penetration"] = each.planned.relative_penetration;
    row["state"] = each.outcome ? each.outcome->state : "planned";
    if (each.outcome) {
      row["message"] = each.outcome->message;
      row["wall"] = each.outcome->wall_s;
      if (each.outcome->steady()) row["load"] = load_json(each.outcome->load);
      row["facts"] = each.outcome->facts;
    }
    json["runs"].push_back(row);
  }
  return json.dump(1) + "\n";
}

}  // namespace apc::cli
