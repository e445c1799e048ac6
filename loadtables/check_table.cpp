#include "loadtables/check_table.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "loadtables/metamodel.h"

namespace apc::loadtables {
namespace {

std::string where(const TireContact& at) {
  return concat("at ", std::round(10.0 * at.speed / units::kt) / 10.0, " kt, bed ",
                std::round(100.0 * at.bed_depth / units::in) / 100.0, " in, penetration ",
                std::round(100.0 * at.penetration / units::in) / 100.0, " in");
}

void look_along_penetration(const LoadTable& table, double speed, double depth, TableCheck& check) {
  constexpr int steps = 240;
  double highest = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const TireContact at{speed, depth, 1.2 * k / steps * table.maximum_penetration(depth)};
    const auto found = table.load_with_slopes(at);
    ++check.points;
    check.least_drag = std::min(check.least_drag, found.load.drag);
    check.least_vertical = std::min(check.least_vertical, found.load.vertical);
    highest = std::max(highest, found.load.vertical);
    const double fall = highest > 0.0 ? 1.0 - found.load.vertical / highest : 0.0;
    if (at.penetration > 0.5 * table.tire().diameter) {
      if (fall > check.largest_fall_beyond) check.largest_fall_beyond = fall, check.largest_fall_beyond_at = at;
      continue;
    }
    if (found.vertical.penetration < 0.0) check.falling_share += 1.0;
    if (-found.vertical.penetration > check.steepest_fall)
      check.steepest_fall = -found.vertical.penetration, check.steepest_at = at;
    if (fall > check.largest_fall) check.largest_fall = fall, check.largest_fall_at = at;
  }
}

void compare_with_samples(const LoadTable& table, TableCheck& check) {
  const auto samples = usable(table.data().samples);
  if (samples.empty()) return;
  double drag = 0.0, vertical = 0.0;
  for (const auto& sample : samples) {
    drag += sample.load.drag / static_cast<double>(samples.size());
    vertical += sample.load.vertical / static_cast<double>(samples.size());
  }
  for (const auto& sample : samples) {
    const auto load = table.load(sample.contact);
    const double by_drag = std::abs(load.drag - sample.load.drag) / drag,
                 by_vertical = std::abs(load.vertical - sample.load.vertical) / vertical;
    check.drag_rms += by_drag * by_drag / static_cast<double>(samples.size());
    check.vertical_rms += by_vertical * by_vertical / static_cast<double>(samples.size());
    check.worst_drag = std::max(check.worst_drag, by_drag);
    check.worst_vertical = std::max(check.worst_vertical, by_vertical);
  }
  check.drag_rms = std::sqrt(check.drag_rms);
  check.vertical_rms = std::sqrt(check.vertical_rms);
}

}  // namespace

TableCheck check_table(const LoadTable& table, double allowed_fall) {
  TableCheck check;
  constexpr int speeds = 8, depths = 37;
  for (int i = 0; i < speeds; ++i)
    for (int j = 0; j < depths; ++j)
      look_along_penetration(table, table.speed_range()[1] * i / (speeds - 1),
                             table.depth_range()[1] * j / (depths - 1), check);
  check.falling_share /= check.points;
  compare_with_samples(table, check);

  if (check.least_drag < 0.0) check.failures.push_back(concat("drag falls to ", check.least_drag, " N"));
  if (check.least_vertical < 0.0)
    check.failures.push_back(concat("the vertical load falls to ", check.least_vertical, " N"));
  if (check.largest_fall > allowed_fall)
    check.failures.push_back(concat("the vertical load falls by ", std::round(1000.0 * check.largest_fall) / 10.0,
                                    " % with growing penetration ", where(check.largest_fall_at)));
  for (const auto& quality : table.quality()) {
    const double found = quality.response == "drag"       ? check.drag_rms
                         : quality.response == "vertical" ? check.vertical_rms
                                                          : quality.rms_relative;
    if (found > 1.001 * quality.rms_relative + 1e-6)
      check.failures.push_back(concat("the ", quality.response, " of the samples comes back with an error of ", found,
                                      ", the table states ", quality.rms_relative));
  }
  return check;
}

}  // namespace apc::loadtables
