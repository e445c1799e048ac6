#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/report/manifest_json.h"
#include "apc/report/rolling_record.h"

namespace apc::report {
namespace {

using Value = nlohmann::ordered_json;

}  // namespace

std::string rolling_json(const RollingRecord& record) {
  Value out;
  out["schema"] = "apc-sph-result/1";
  out["state"] = record.state;
  out["message"] = record.message;
  out["symmetry"] = "full";  // drag, vertical and the energy rate are of the whole tire; half of it was modelled
  const std::vector<std::pair<const char*, double>> numbers{{"drag", record.drag},
                                                            {"vertical", record.vertical},
                                                            {"rut_depth", record.rut_depth},
                                                            {"surface_left", record.surface_left},
                                                            {"spin_ratio", record.spin_ratio},
                                                            {"tire_deflection", record.tire_deflection},
                                                            {"internal_energy_rate", record.internal_energy_rate},
                                                            {"energy_residual", record.residual},
                                                            {"drag_change", record.drag_change},
                                                            {"vertical_change", record.vertical_change},
                                                            {"spin_change", record.spin_change},
                                                            {"compaction", record.compaction},
                                                            {"partition_min", record.partition_min},
                                                            {"partition_mean", record.partition_mean},
                                                            {"particles", record.particles},
                                                            {"steps", record.steps},
                                                            {"particle_steps", record.particle_steps},
                                                            {"particle_steps_per_s", record.particle_steps_per_s},
                                                            {"bytes_per_particle", record.bytes_per_particle},
                                                            {"wall_s", record.wall_s}};
  for (const auto& [key, value] : numbers) out[key] = number_or_null(value);
  if (!record.steady)  // what it had is kept, but under a name that nobody takes for a load
    for (const char* load : {"drag", "vertical", "rut_depth"}) {
      out["last_window"][load] = out[load];
      out[load] = nullptr;
    }
  for (const auto& [key, value] : record.energy_in) out["energy_of_half"]["in"][key] = number_or_null(value);
  for (const auto& [key, value] : record.energy_out) out["energy_of_half"]["out"][key] = number_or_null(value);
  for (const auto& each : record.shape) out["rut_shape"][each.key] = number_or_null(each.value);
  out["inputs"] = {{"name", record.name},       {"tire", record.tire},           {"material", record.material},
                   {"speed", record.speed},     {"bed_depth", record.bed_depth}, {"penetration", record.penetration},
                   {"spacing", record.spacing}, {"friction", record.friction}};
  out["provenance"] = provenance(record.manifest);
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace apc::report
