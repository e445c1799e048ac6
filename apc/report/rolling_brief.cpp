#include <fmt/format.h>

#include <cmath>

#include "apc/base/csv.h"
#include "apc/report/rolling_record.h"

namespace apc::report {

std::string rolling_brief(const RollingRecord& record, UnitSystem units) {
  std::string out;
  if (!record.steady) out += fmt::format("warning: {}: {}\n\n", record.state, record.message);
  out += fmt::format("{} in {}, {} deep, rolling at {} with a penetration of {} ({} of the largest)\n", record.tire,
                     record.material, shown(record.bed_depth, measure::depth, units),
                     shown(record.speed, measure::speed, units), shown(record.penetration, measure::depth, units),
                     percent(record.maximum_penetration > 0 ? record.penetration / record.maximum_penetration : 0.0));
  out += fmt::format("  particles {} apart, friction of tire on foam {}\n\n",
                     shown(record.spacing, measure::depth, units), number(record.friction, 2));
  if (record.fall != 0.0)
    out += "  sinking by " + number(record.fall, 3) + " of the way: loads are means around the penetration\n\n";
  const auto line = [&](const char* name, const std::string& value, const std::string& remark) {
    out += fmt::format("  {:<16}{:>14}  {}\n", name, value, remark);
  };
  if (!record.steady) out += "  no load: what follows is the mean over the last window\n";
  const auto change = [](double share) { return "changed " + percent(share, 1) + " between the last two windows"; };
  line("drag", shown(record.drag, measure::force, units), change(record.drag_change));
  line("vertical", shown(record.vertical, measure::force, units), change(record.vertical_change));
  line("spin ratio", number(record.spin_ratio, 3), fmt::format("changed {:.3f}", record.spin_change));
  line("rut", shown(record.rut_depth, measure::depth, units),
       "surface left behind " + shown(record.surface_left, measure::depth, units) + " below the top");
  line("tire deflection", shown(record.tire_deflection, measure::depth, units), "");
  if (!record.shape.empty()) out += "\n  shape of the rut\n";
  for (const auto& each : record.shape)
    out += fmt::format("    {:<45}{:>9}\n", each.name,
                       std::isfinite(each.value) ? shown(each.value, measure::depth, units) : "-");
  out += fmt::format("\n  energy of the modelled half{:>8}\n", "");
  double input = 0.0;
  for (const auto& term : record.energy_in) input += term.second;
  const auto terms = [&](const char* side, const std::vector<std::pair<std::string, double>>& list) {
    for (const auto& [name, value] : list)
      out += fmt::format("    {:<4}{:<22}{:>12} kJ{:>10}\n", side, name, number(value / 1e3, 2),
                         input != 0.0 ? percent(value / input, 2) : "-");
  };
  terms("in", record.energy_in);
  terms("out", record.energy_out);
  out += fmt::format("    {:<26}{:>25}\n\n", "residual", percent(record.residual, 3));
  out += fmt::format("  largest compaction {}; sum of V W in the crushed foam {:.3f} (lowest {:.3f})\n",
                     percent(record.compaction, 1), record.partition_mean, record.partition_min);
  return out +
         fmt::format("  {} particles, {} steps, {:.2f} million particle-steps/s, {:.1f} s, {} bytes per particle\n",
                     number(record.particles, 0), number(record.steps, 0), record.particle_steps_per_s / 1e6,
                     record.wall_s, number(record.bytes_per_particle, 0));
}

std::string rolling_csv(const RollingRecord& record) {
  return csv_text({{"tire", record.tire},
                   {"material", record.material},
                   {"state", record.state},
                   {"program", record.manifest.version},
                   {"command", record.manifest.command}},
                  {{"time", "s", record.time},
                   {"distance", "m", record.distance},
                   {"drag", "N", record.drag_history},
                   {"vertical", "N", record.vertical_history},
                   {"spin_ratio", "", record.spin_history},
                   {"deflection", "m", record.deflection_history}});
}

}  // namespace apc::report
