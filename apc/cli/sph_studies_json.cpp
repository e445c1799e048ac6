#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/cli/sph_studies.h"
#include "apc/report/manifest_json.h"

namespace apc::cli {
namespace {

using Value = nlohmann::ordered_json;
using report::number_or_null;

Value run_json(const sph::Verification& run) {
  Value out{{"case", sph::name_of(run.study)},
            {"method", sph::name_of(run.method)},
            {"spacing", run.spacing},
            {"symmetry", run.symmetry},
            {"state", run.state},
            {"assumptions", run.assumptions}};
  if (!run.message.empty()) out["message"] = run.message;
  for (const auto& each : run.quantities) {
    out[each.name] = number_or_null(each.value);
    out["reference"][each.name] = number_or_null(each.reference);
    out["reference_fem"][each.name] = number_or_null(each.reference_fem);
    out["difference"][each.name] = number_or_null(each.difference());
  }
  for (const auto& term : run.energy) out["energy_shares"][term.name] = number_or_null(term.value);
  const std::vector<std::pair<const char*, double>> numbers{{"energy_residual", run.energy_residual},
                                                            {"viscous_share", run.viscous_share},
                                                            {"hourglass_share", run.hourglass_share},
                                                            {"spin_ratio", run.spin_ratio},
                                                            {"rut_depth", run.rut_depth},
                                                            {"compaction", run.compaction},
                                                            {"partition", run.partition},
                                                            {"travel", run.travel},
                                                            {"particles", run.particles},
                                                            {"steps", run.steps},
                                                            {"bytes_per_particle", run.bytes_per_particle},
                                                            {"particle_steps_per_s", run.particle_steps_per_s},
                                                            {"wall_s", run.wall_s}};
  for (const auto& [key, value] : numbers) out[key] = number_or_null(value);
  if (run.shape.behind > 0.0)
    for (const auto& line : sph::lines_of(run.shape)) out["rut_shape"][line.key] = number_or_null(line.value);
  return out;
}

Value study_json(const sph::Convergence& study) {
  Value out{{"case", sph::name_of(study.study)}, {"method", sph::name_of(study.method)}, {"sizes", study.sizes}};
  for (const auto& each : study.quantities) {
    const auto& name = each.finest.name;
    out["values"][name] = each.values;
    out["order"][name] = each.fit.valid ? number_or_null(each.fit.order) : Value(nullptr);
    out["extrapolated"][name] = number_or_null(each.fit.extrapolated);
    out["r2"][name] = each.fit.valid ? number_or_null(each.fit.r2) : Value(nullptr);
    out["gci"][name] = each.gci.valid ? number_or_null(each.gci.index) : Value(nullptr);
    out["errors"][name] = each.errors;
    out["reference"][name] = number_or_null(each.finest.reference);
  }
  for (const auto& run : study.runs) out["runs"].push_back(run_json(run));
  return out;
}

std::string text_of(const Value& value) { return value.dump(1, ' ', false, Value::error_handler_t::replace) + "\n"; }

}  // namespace

std::string verification_json(const std::vector<sph::Verification>& runs, const std::vector<sph::SpanRow>& span,
                              const std::string& command) {
  Value out{{"schema", "apc-sph-verification/1"}, {"command", command}};
  out.update(run_json(runs.front()));
  if (runs.size() > 1) out["fem"] = run_json(runs[1]);
  for (const auto& row : span) {
    out["span"].push_back({{"what", row.what}});
    out["span"].back().update(run_json(row.run));
  }
  return text_of(out);
}

std::string convergence_json(const std::vector<sph::Convergence>& studies, const std::string& command) {
  Value out{{"schema", "apc-sph-convergence/1"}, {"command", command}};
  out.update(study_json(studies.front()));
  if (studies.size() > 1) out["fem"] = study_json(studies[1]);
  return text_of(out);
}

std::string bench_json(const sph::Throughput& t, const std::string& command) {
  Value out{{"schema", "apc-sph-bench/2"},
            {"command", command},
            {"instruction_set", t.instruction_set},
            {"particles", t.particles},
            {"window_particles", t.window_particles},
            {"window_steps", t.window_steps},
            {"bytes_per_particle", t.bytes_per_particle},
            {"crushed_cost", t.crushed_cost},
            {"per_particle_step",
             {{"operations", t.count.operations},
              {"pairs", t.count.pairs},
              {"pairs_within", t.count.pairs_within},
              {"neighbour_bytes", t.count.neighbour_bytes},
              {"own_bytes", t.count.own_bytes}}},
            {"rows", Value::array()}};
  for (const auto& row : t.rows)
    out["rows"].push_back({{"threads", row.threads},
                           {"rest", row.rest},
                           {"whole", row.whole},
                           {"whole_fastest", row.whole_fastest},
                           {"window", row.window},
                           {"nominal", row.nominal},
                           {"window_wall_s", row.window_wall_s},
                           {"drag", row.drag},
                           {"vertical", row.vertical},
                           {"limit_operations", row.limits.operations},
                           {"limit_near_bytes", row.limits.near_bytes},
                           {"limit_far_bytes", row.limits.far_bytes}});
  return text_of(out);
}

}  // namespace apc::cli
