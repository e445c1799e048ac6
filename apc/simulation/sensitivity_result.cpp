#include "apc/simulation/sensitivity_result.h"

#include <algorithm>
#include <limits>

#include "apc/simulation/overrun_run.h"

namespace apc::simulation {
namespace {

double deceleration(const Variant& variant, double t, const double* y, std::vector<double>& rate) {
  Moment moment;
  derivatives(variant.plant, variant.around, t, y, rate.data(), &moment);
  return -moment.cg_acceleration.x;
}

std::vector<double> stored(const Variant& variant, const double* y) {
  const auto now = stores(variant.plant, y);
  return {now.kinetic, now.potential, now.oleo_gas, now.stops};
}

}  // namespace

Sensitivity sensitivity_at_end(Neighbours& runs, bool stopped, double t, const std::vector<double>& y,
                               const std::vector<double>& s, CarriedWorks& works) {
  const auto& plant = runs.base.plant;
  std::vector<double> rate(y.size()), unused(y.size());
  const double slowing = deceleration(runs.base, t, y.data(), rate);
  const double nose_speed = row_motion(plant, 0, y.data())[1];
  const double nose = runs.total(y, s, [](const Variant& v, const double* at) { return nose_distance(v.plant, at); });
  const double speed = runs.total(y, s, [](const Variant& v, const double* at) { return cg_speed(v.plant, at); });
  const double length = runs.held([](const Variant& v) { return v.plant.profile.length(); });
  const double later = stopped ? speed / slowing : (length - nose) / nose_speed;  // dt/dp of the end
  auto moving = s;
  for (std::size_t i = 0; i < s.size(); ++i) moving[i] += rate[i] * later;

  Sensitivity result;
  const double entry = runs.base.overrun.entry_speed, last = stopped ? 0.0 : cg_speed(plant, y.data());
  double way = nose_distance(plant, y.data()), way_moved = stopped ? nose + nose_speed * later : length;
  const double reached = way, reached_moved = way_moved;
  result.stop_time = later;
  if (stopped) {
    const double slowing_moved =
        runs.total(y, moving, [&](const Variant& v, const double* at) { return deceleration(v, t, at, unused); });
    const auto rest = come_to_rest(slowing);  // both fall with the deceleration
    result.stop_time -= rest.time * slowing_moved / slowing;
    way += rest.distance;
    way_moved -= rest.distance * slowing_moved / slowing;
    result.stop_distance = way_moved;
  } else {
    result.outcome = Outcome::left_bed;
    result.stop_distance = std::numeric_limits<double>::quiet_NaN();
    result.exit_speed = speed - slowing * later;
  }
  const double entry_moved = runs.held([](const Variant& v) { return v.overrun.entry_speed; });
  result.mean_deceleration = (entry * entry_moved - last * result.exit_speed) / way -
                             (entry * entry - last * last) / (2.0 * way * way) * way_moved;

  const auto powers = works.at(t, y, s);
  for (std::size_t i = 0; i < sinks; ++i)
    result.energy[std::string(sink_names[i])] = works.sink(i) + powers.value[i] * later;
  const auto at_end = runs.totals(y, moving, [](const Variant& v, const double* at) { return stored(v, at); });
  std::vector<double> at_entry(at_end.size());
  for (std::size_t i = 0; i < at_entry.size(); ++i)
    at_entry[i] = runs.held([i](const Variant& v) { return stored(v, v.start.data())[i]; });
  result.energy["kinetic"] = at_entry[0];
  result.energy["kinetic_left"] = at_end[0];
  result.energy["potential"] = at_end[1] - at_entry[1];
  result.energy["oleo_gas"] = at_end[2] - at_entry[2];
  result.energy["stops"] = at_end[3] - at_entry[3];

  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    Sensitivity::Gear gear;
    gear.name = plant.groups[g].name;
    const double work = works.drag_work(g), moved = works.drag_work_slope(g) + powers.value[sinks + g] * later;
    gear.mean_drag = moved / reached - work / (reached * reached) * reached_moved;
    result.gears.push_back(gear);
  }
  return result;
}

}  // namespace apc::simulation
