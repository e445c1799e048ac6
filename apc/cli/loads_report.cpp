/// What `apc loads` prints.
#include <fmt/format.h>

#include <map>

#include "apc/base/units.h"
#include "apc/cli/loads_commands.h"
#include "apc/cli/text_table.h"
#include "loadtables/load_table_data.h"

namespace apc::cli {

std::string table_report(const loadtables::LoadTable& table, const loadtables::TableCheck& check) {
  const auto& from = table.provenance();
  const auto& tire = table.tire();
  std::string text = fmt::format("{} in {}\n", tire.name, from.material);
  text += fmt::format("  tire       {:.1f} x {:.1f} in, rated {:.0f} lbf at {:.2f} in, bottoming {:.0f} lbf\n",
                      tire.diameter / units::in, tire.width / units::in, tire.rated_load / units::lbf,
                      tire.rated_deflection / units::in, tire.bottoming_load / units::lbf);
  text +=
      fmt::format("  range      {:.0f} to {:.0f} kt, bed up to {:.0f} in, up to {:.0f} % of the largest penetration\n",
                  table.speed_range()[0] / units::kt, table.speed_range()[1] / units::kt,
                  table.depth_range()[1] / units::in, 100.0 * table.ratio_range()[1]);
  text += fmt::format("  source     {}\n", from.source);
  if (from.refused > 0) text += fmt::format("  runs       {}, {} of them refused\n", from.runs, from.refused);
  if (!from.command.empty()) text += fmt::format("  command    {}\n", from.command);
  TextTable errors{{"response", "points", "rms %", "left out %", "to axle %", "R2"}, {}};
  for (const auto& each : table.quality())
    errors.rows.push_back({each.response, fmt::format("{}", each.points),
                           fmt::format("{:.2f}", 100.0 * each.rms_relative),
                           fmt::format("{:.2f}", 100.0 * each.loo_rms_relative),
                           fmt::format("{:.2f}", 100.0 * each.loo_rms_to_axle), fmt::format("{:.4f}", each.r2)});
  text += aligned(errors);
  if (table.data().growth_correction > 0.0005)
    text += fmt::format("  ripples of up to {:.1f} % of the largest vertical load were levelled\n",
                        100.0 * table.data().growth_correction);
  text += fmt::format(
      "  vertical load falls with penetration by at most {:.1f} % (at {:.2f} % of {} points); deeper than the axle by "
      "{:.1f} %\n",
      100.0 * check.largest_fall, 100.0 * check.falling_share, check.points, 100.0 * check.largest_fall_beyond);
  for (const auto& failure : check.failures) text += fmt::format("  bad: {}\n", failure);
  return text;
}

std::string table_slices(const loadtables::LoadTable& table, double speed, report::UnitSystem units) {
  using report::number;
  namespace measure = report::measure;
  const auto scaled = [&](double value, const report::Measure& what) {
    return number(value / what.in(units).factor, what.in(units).digits);
  };
  std::string text;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double depth = share * table.depth_range()[1], largest = table.maximum_penetration(depth);
    text += fmt::format("bed {}, at {}\n", report::shown(depth, measure::depth, units),
                        report::shown(speed, measure::speed, units));
    TextTable rows{{"of largest %", fmt::format("penetration {}", measure::depth.in(units).unit),
                    fmt::format("drag {}", measure::force.in(units).unit),
                    fmt::format("vertical {}", measure::force.in(units).unit),
                    fmt::format("rut {}", measure::depth.in(units).unit), "spin ratio"},
                   {}};
    for (int k = 1; k <= 10; ++k) {
      const double penetration = 0.1 * k * largest;
      const auto load = table.load({speed, depth, penetration});
      rows.rows.push_back({fmt::format("{}", 10 * k), scaled(penetration, measure::depth),
                           scaled(load.drag, measure::force), scaled(load.vertical, measure::force),
                           scaled(load.rut_depth, measure::depth), fmt::format("{:.3f}", load.spin_ratio)});
    }
    text += aligned(rows);
  }
  return text;
}

std::string status_report(const std::vector<loadtables::RunStatus>& list, const std::filesystem::path& folder) {
  std::map<std::string, int> count;
  double wall = 0.0, done = 0.0, all = 0.0;
  TextTable refused{{"run", "speed kt", "bed in", "of largest %", "state", "why"}, {}};
  for (const auto& each : list) {
    all += loadtables::estimated_work(each.planned);
    if (!each.outcome) continue;
    ++count[each.outcome->state];
    wall += each.outcome->wall_s;
    done += loadtables::estimated_work(each.planned);
    if (!each.outcome->steady())
      refused.rows.push_back({fmt::format("{}", each.planned.id),
                              fmt::format("{:.0f}", each.planned.contact.speed / units::kt),
                              fmt::format("{:.0f}", each.planned.contact.bed_depth / units::in),
                              fmt::format("{:.0f}", 100.0 * each.planned.relative_penetration), each.outcome->state,
                              each.outcome->message});
  }
  std::string text = fmt::format("{} runs planned", list.size());
  for (const auto& [state, number] : count) text += fmt::format(", {} {}", number, state);
  text += fmt::format("; {:.1f} core minutes so far", wall / 60.0);
  if (done > 0.0 && done < all) text += fmt::format(", about {:.1f} to go", wall / 60.0 * (all - done) / done);
  text += "\n";
  if (!refused.rows.empty()) text += aligned(refused);
  if (done < all)
    text += fmt::format("Go on with: apc loads run {}\n", folder.string());
  else
    text += fmt::format("Fit with: apc loads fit {} -o TABLE.h5\n", folder.string());
  return text;
}

}  // namespace apc::cli
