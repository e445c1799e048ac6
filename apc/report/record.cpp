#include "apc/report/record.h"

#include <algorithm>
#include <set>

namespace apc::report {

WorstMargin worst_margin(const simulation::Result& result) {
  WorstMargin worst;
  const auto consider = [&](const WorstMargin& candidate) {
    if (candidate.limit > 0 && candidate.peak > 0 && (worst.gear.empty() || candidate.margin < worst.margin))
      worst = candidate;
  };
  for (const auto& gear : result.gears) {
    consider({gear.name, "drag", gear.drag_rule, gear.drag_margin, gear.peak_drag, gear.drag_limit,
              gear.peak_drag_distance});
    consider({gear.name, "vertical", gear.vertical_rule, gear.vertical_margin, gear.peak_vertical, gear.vertical_limit,
              gear.peak_vertical_distance});
  }
  return worst;
}

std::vector<std::size_t> thinned_rows(const simulation::History& history, std::size_t count) {
  std::set<std::size_t> rows;
  const std::size_t total = history.time.size();
  if (total == 0) return {};
  rows.insert({std::size_t{0}, total - 1});
  // Half of the rows go by distance (the default axis), half by time (the end of the roll, where distance stands
  // still).
  const double reach = history.distance.back() - history.distance.front();
  const double lasts = history.time.back() - history.time.front();
  double next_distance = history.distance.front(), next_time = history.time.front();
  for (std::size_t row = 0; row < total; ++row) {
    if (history.distance[row] >= next_distance && reach > 0) {
      rows.insert(row);
      next_distance = history.distance[row] + 2.0 * reach / static_cast<double>(count);
    }
    if (history.time[row] >= next_time && lasts > 0) {
      rows.insert(row);
      next_time = history.time[row] + 2.0 * lasts / static_cast<double>(count);
    }
  }
  const auto keep_peak = [&](const std::vector<double>& column) {
    if (column.size() != total) return;
    const auto [low, high] = std::minmax_element(column.begin(), column.end());
    rows.insert({static_cast<std::size_t>(low - column.begin()), static_cast<std::size_t>(high - column.begin())});
  };
  keep_peak(history.deceleration);
  keep_peak(history.pitch);
  for (const auto& gear : history.gears)
    for (const auto* column : {&gear.drag, &gear.vertical, &gear.stroke, &gear.penetration, &gear.rut})
      keep_peak(*column);
  return {rows.begin(), rows.end()};
}

}  // namespace apc::report
