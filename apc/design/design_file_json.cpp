#include <nlohmann/json.hpp>

#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/design/design_file.h"

namespace apc::design {

DesignFile load_design(const std::filesystem::path& path) {
  const auto json = read_json(path);
  const auto schema = json.text("schema", "");
  require(schema == "apc-design/1" || !schema.starts_with("apc-design/"), path.string(), " /schema: \"", schema,
          "\" was written by another version; this program reads \"apc-design/1\". Run \"apc design\" again with the "
          "fleet's "
          "file");
  require(schema == "apc-design/1", path.string(), " /schema: \"", schema,
          "\" is no design. Give the design.json that \"apc design\" wrote");
  json.check(json.flag("feasible", false), "feasible",
             "is false: there is no bed in this design. Relax what it names as the reason");
  DesignFile out;
  const auto objective = json.text("objective");
  for (const auto each : {Objective::length, Objective::volume, Objective::minimax, Objective::speed})
    if (objective == text(each)) out.objective = each;
  out.fleet = read_fleet(json.object("fleet"));
  const auto criterion = json.text("criterion");
  json.check(criterion == "limit" || criterion == "ultimate", "criterion", "is unknown: limit or ultimate");
  out.fleet.limits.criterion = criterion == "limit" ? Criterion::limit : Criterion::ultimate;
  out.bed = bed::read_bed(json.object("bed"));
  out.speed_factor = json.number("speed_factor", 1.0);
  const auto certificate = json.object("certificate");
  out.methods = certificate.texts("methods");
  out.difference = certificate.number("difference");
  out.gradient_error = certificate.number("gradient_error");
  out.stationarity = certificate.number("stationarity");
  out.agreed = certificate.flag("agreed", false);
  for (const auto& active : certificate.objects("active")) out.active.push_back(active.text("constraint"));
  const auto provenance = json.object("provenance");
  out.program = provenance.text("program");
  out.command = provenance.text("command");
  return out;
}

}  // namespace apc::design
