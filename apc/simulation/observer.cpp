#include "apc/simulation/observer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aircraft/static_stand.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::simulation {

namespace {

constexpr double ultimate_factor = 1.5;  // 14 CFR 25.303

}  // namespace

/// By the trapezoid: half an interval that begins or ends in the air.
void Observer::Airborne::see(bool now, double passed, double at) {
  time += passed * 0.5 * ((now ? 1.0 : 0.0) + (before_ ? 1.0 : 0.0));
  if (now && std::isnan(first_at)) first_at = at;
  before_ = now;
}

/// A maximum between three neighbours is the vertex of the parabola through them.
void Peak::see(double time, double sample, double at) {
  if (sample > value) value = sample, distance = at;
  if (count_ >= 2 && last_[0] >= last_[1] && last_[0] >= sample && last_[0] > 0.98 * value - 1e-12) {
    const double before = last_[1] - last_[0], after = sample - last_[0];  // both ≤ 0
    const double t0 = time_[1] - time_[0], t1 = time - time_[0];           // < 0, > 0
    const double curvature = (after / t1 - before / t0) / (t1 - t0), slope = after / t1 - curvature * t1;
    if (curvature < 0.0) {
      const double shift = -0.5 * slope / curvature, vertex = last_[0] + 0.5 * slope * shift;
      if (shift > t0 && shift < t1 && vertex > value) {
        value = vertex;
        distance = where_[0] + (at - where_[0]) * shift / t1;
      }
    }
  }
  last_[1] = last_[0];
  time_[1] = time_[0];
  where_[1] = where_[0];
  last_[0] = sample;
  time_[0] = time;
  where_[0] = at;
  ++count_;
}

std::array<double, 2> group_load(const Plant& plant, std::size_t group, const Moment& moment) {
  std::array<double, 2> sum{};
  const auto& g = plant.groups[group];
  for (int r = g.first_row; r < g.first_row + g.rows; ++r) {
    const auto& row = moment.rows[static_cast<std::size_t>(r)];
    const bool spinning_up = plant.brake_mode == BrakeMode::friction;  // slip then carries wheel inertia only
    sum[0] -= row.force_x + (spinning_up ? row.slip_force * row.tangent.x : 0.0);
    sum[1] += row.force_z + (spinning_up ? row.slip_force * row.tangent.z : 0.0);
  }
  return sum;
}

Observer::Observer(const Model& model, const Plant& plant, double interval, int rows_every)
    : model_(model), plant_(plant), interval_(interval), rows_every_(rows_every), gears_(plant.groups.size()) {
  for (const auto& gear : model.aircraft.gears) limits_.push_back(aircraft::load_limits(model.aircraft, gear));
  history_.gears.resize(plant.groups.size());
}

void Observer::record(double time, const double* y, const Moment& moment, double dissipated) {
  const double* rate = y + plant_.degrees();
  const double c = std::cos(y[2]), s = std::sin(y[2]);
  const double ax = moment.cg_acceleration.x, az = moment.cg_acceleration.z + units::g0;
  history_.time.push_back(time);
  history_.distance.push_back(moment.rows[0].distance);
  history_.speed.push_back(moment.cg_velocity.x);
  history_.deceleration.push_back(-ax);
  history_.acceleration_x.push_back(ax * c + az * s);
  history_.acceleration_z.push_back(-ax * s + az * c - units::g0);
  history_.pitch.push_back(y[2]);
  history_.pitch_rate.push_back(rate[2]);
  history_.heave.push_back(moment.cg_position.z - model_.aircraft.cg_height);
  history_.dissipated.push_back(dissipated);
  for (std::size_t g = 0; g < gears_.size(); ++g) {
    auto& gear = history_.gears[g];
    const auto& row = moment.rows[static_cast<std::size_t>(plant_.groups[g].first_row)];
    const auto load = group_load(plant_, g, moment);
    gear.drag.push_back(load[0]);
    gear.vertical.push_back(load[1]);
    gear.stroke.push_back(moment.groups[g].stroke);
    gear.stroke_rate.push_back(moment.groups[g].stroke_rate);
    gear.penetration.push_back(std::max(0.0, row.penetration));
    gear.rut.push_back(row.penetration > 0.0 ? row.ground.load.rut_depth : 0.0);
    gear.bed_depth.push_back(row.bed_depth);
    gear.spin.push_back(row.spin);
    gear.distance.push_back(row.distance);
  }
}

void Observer::see(double time, const double* y, const Surroundings& around, const Moment& moment, double dissipated) {
  see_between(time, y, around, moment);
  if (rows_every_ > 0 && instants_ % rows_every_ == 0) record(time, y, moment, dissipated);
  ++instants_;
}

void Observer::see_between(double time, const double* y, const Surroundings& around, const Moment& moment) {
  const double nose = moment.rows[0].distance, speed = moment.cg_velocity.x;
  deceleration_.see(time, -moment.cg_acceleration.x, nose);
  pitch_up_.see(time, y[2], nose);
  pitch_down_.see(time, -y[2], nose);
  speeds_.push_back({time, speed});
  constexpr double mean_over = 0.1;  // s
  while (window_ + 1 < speeds_.size() && speeds_[window_ + 1][0] <= time - mean_over) ++window_;
  if (speeds_[window_][0] <= time - mean_over) {
    const auto &from = speeds_[window_], &to = speeds_[window_ + 1];
    const double share = (time - mean_over - from[0]) / (to[0] - from[0]);
    mean_100ms_.see(time, (from[1] + share * (to[1] - from[1]) - speed) / mean_over, nose);
  }

  const double step = instants_ == 0 ? 0.0 : nose - last_distance_;
  const double passed = instants_ == 0 ? 0.0 : time - last_time_;
  bool none_down = true;
  for (std::size_t g = 0; g < gears_.size(); ++g) {
    auto& watch = gears_[g];
    const auto& group = plant_.groups[g];
    const auto load = group_load(plant_, g, moment);
    const double each = 1.0 / group.struts, drag = load[0] * each;
    watch.drag.see(time, drag, nose);
    watch.vertical.see(time, load[1] * each, nose);
    watch.stroke.see(time, moment.groups[g].stroke, nose);
    watch.drag_work += 0.5 * (drag + watch.last_drag) * step;
    watch.last_drag = drag;
    const double vertical = load[1] * each;
    if (!watch.failed_by) {
      const auto& limit = limits_[g];
      if (limit.drag_ultimate > 0.0 && drag >= limit.drag_ultimate)
        watch.failed_by = "drag";
      else if (limit.vertical_limit > 0.0 && vertical >= ultimate_factor * limit.vertical_limit)
        watch.failed_by = "vertical";
      if (watch.failed_by) watch.failed_at = nose, watch.failed_time = time;
    }
    double deepest_rut = 0.0, deepest = 0.0, tire = 0.0;
    for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
      const auto& row = moment.rows[static_cast<std::size_t>(r)];
      if (row.penetration > 0.0) deepest_rut = std::max(deepest_rut, row.ground.load.rut_depth);
      deepest = std::max(deepest, row.penetration);
      tire = std::max(tire, row.ground.load.vertical);
    }
    watch.rut.see(time, deepest_rut, nose);
    watch.penetration.see(time, deepest, nose);
    watch.tire.see(time, tire, nose);
    watch.airborne.see(tire <= 0.0, passed, nose);
    none_down = none_down && tire <= 0.0;
    see_coverage(g, passed, around, moment);
  }
  all_airborne_.see(none_down, passed, nose);
  last_distance_ = nose;
  last_time_ = time;
}

/// Outside is an instant at which any row of the gear is.
void Observer::see_coverage(std::size_t g, double passed, const Surroundings& around, const Moment& moment) {
  auto& watch = gears_[g];
  const auto& group = plant_.groups[g];
  const auto& table = *group.ground.table;
  bool in_bed = false, below = false, above = false;
  loadtables::Coverage inside;
  for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
    const auto& row = moment.rows[static_cast<std::size_t>(r)];
    if (!around.in_bed[static_cast<std::size_t>(r)] || !(row.bed_depth > 0.0)) continue;
    in_bed = true;
    if (row.bed_depth != watch.depth)
      watch.depth = row.bed_depth, watch.maximum_penetration = table.maximum_penetration(row.bed_depth);
    const double speed = std::abs(row.speed);
    const auto here = table.coverage({speed, row.bed_depth, row.penetration}, watch.maximum_penetration);
    (speed > table.speed_range()[1] ? above : below) |= !here.speed;
    inside.speed = inside.speed && here.speed;
    inside.bed_depth = inside.bed_depth && here.bed_depth;
    inside.penetration = inside.penetration && here.penetration;
  }
  if (!in_bed) return;
  watch.in_bed += passed;
  if (below) watch.below_speed += passed;
  if (above) watch.above_speed += passed;
  if (!inside.bed_depth) watch.outside_depth += passed;
  if (!inside.penetration) watch.outside_penetration += passed;
  if (!inside.inside()) watch.outside += passed;
}

/// Earliest first: what fails later fails in a run that had already ended for the gear.
void Observer::report_failures(Result& result) const {
  std::vector<const GearSummary*> failed;
  for (const auto& gear : result.gears)
    if (!gear.failed_by.empty()) failed.push_back(&gear);
  if (failed.empty()) return;
  std::stable_sort(failed.begin(), failed.end(),
                   [](const auto* a, const auto* b) { return a->failed_time < b->failed_time; });
  std::string first;
  for (const auto* gear : failed)
    first +=
        fmt::format("{} gear: {} passed its ultimate load {:.1f} m ({:.0f} ft) into the bed; ", gear->name,
                    gear->failed_by == "drag" ? "drag" : "vertical load", gear->failed_at, gear->failed_at / units::ft);
  result.message = first + result.message + (failed.size() > 1 ? ", if the gears had held" : ", if the gear had held");
  if (result.outcome != Outcome::pitched_over) result.outcome = Outcome::gear_limit;
}

void Observer::report_lift_off(Result& result) const {
  constexpr double noticeable = 0.02;  // s
  const auto lifted = [](const std::string& what, double time, double at) {
    return fmt::format("{} off the ground for {:.2f} s in all, first {:.1f} m ({:.0f} ft) into the bed", what, time, at,
                       at / units::ft);
  };
  for (const auto& gear : result.gears)
    if (gear.airborne > noticeable)
      result.warnings.push_back(lifted("the " + gear.name + " wheels were", gear.airborne, gear.lifted_at));
  if (result.airborne > noticeable)
    result.warnings.push_back(lifted("all wheels were", result.airborne, result.lifted_at));
}

void Observer::finish(Result& result) const {
  result.peak_deceleration = deceleration_.value;
  result.peak_deceleration_100ms = mean_100ms_.value > -1e299 ? mean_100ms_.value : deceleration_.value;
  result.peak_pitch = pitch_up_.value;
  result.lowest_pitch = -pitch_down_.value;
  auto as_run = model_.aircraft;
  as_run.mass = result.mass;
  as_run.cg_behind_nose_gear = result.cg_behind_nose_gear;
  const auto stand = aircraft::static_stand(as_run);
  const double reached = std::max(last_distance_, 1e-9);
  for (std::size_t g = 0; g < gears_.size(); ++g) {
    const auto& watch = gears_[g];
    const auto& gear = model_.aircraft.gears[g];
    const auto& limit = limits_[g];
    GearSummary summary;
    summary.name = gear.name;
    summary.struts = gear.struts;
    summary.wheels = gear.wheels() / gear.struts;
    summary.peak_drag = watch.drag.value;
    summary.peak_drag_distance = watch.drag.distance;
    summary.peak_vertical = watch.vertical.value;
    summary.peak_vertical_distance = watch.vertical.distance;
    summary.mean_drag = watch.drag_work / reached;
    summary.drag_limit = limit.drag_limit;
    summary.drag_ultimate = limit.drag_ultimate;
    summary.vertical_limit = limit.vertical_limit;
    summary.vertical_ultimate = ultimate_factor * limit.vertical_limit;
    summary.drag_rule = limit.drag_rule;
    summary.vertical_rule = limit.vertical_rule;
    const auto margin = [](double allowed, double peak) {
      return allowed > 0.0 && peak > 0.0 ? allowed / peak - 1.0 : 0.0;
    };
    summary.drag_margin = margin(limit.drag_limit, watch.drag.value);
    summary.ultimate_margin = margin(limit.drag_ultimate, watch.drag.value);
    summary.vertical_margin = margin(limit.vertical_limit, watch.vertical.value);
    summary.peak_stroke = watch.stroke.value;
    summary.stroke = gear.strut.stroke;
    summary.bottomed = watch.stroke.value >= gear.strut.stroke;
    summary.peak_rut = std::max(0.0, watch.rut.value);
    summary.peak_penetration = std::max(0.0, watch.penetration.value);
    summary.static_vertical = stand.gears[g].vertical;
    if (watch.failed_by)
      summary.failed_by = watch.failed_by, summary.failed_at = watch.failed_at, summary.failed_time = watch.failed_time;
    summary.airborne = watch.airborne.time;
    summary.lifted_at = watch.airborne.first_at;
    summary.tire = gear.tire;
    summary.peak_tire_load = std::max(0.0, watch.tire.value);
    summary.tire_bottoming_load = model_.aircraft.tires.at(gear.tire).bottoming_load;
    summary.tire_bottomed = summary.peak_tire_load > summary.tire_bottoming_load;
    result.gears.push_back(summary);
    const double time = std::max(watch.in_bed, 1e-12);
    CoverageSummary coverage{gear.name, gear.tire, 1.0, 0.0, 0.0, 0.0, 0.0};
    if (watch.in_bed > 0.0)
      coverage = {gear.name,
                  gear.tire,
                  1.0 - watch.outside / time,
                  watch.below_speed / time,
                  watch.above_speed / time,
                  watch.outside_depth / time,
                  watch.outside_penetration / time};
    result.coverage.push_back(coverage);
    if (summary.bottomed) result.warnings.push_back(concat("the ", gear.name, " strut reached its stop"));
    if (summary.tire_bottomed)
      result.warnings.push_back(fmt::format("a {} tire ({}) carried {:.2f} times its bottoming load", gear.name,
                                            gear.tire, summary.peak_tire_load / summary.tire_bottoming_load));
    // Every stop passes through the speeds below the table's range; all else deserves a word.
    const auto warn = [&](double share, const char* what) {
      if (share > 0.001)
        result.warnings.push_back(concat("the ", gear.name, " tire's ", what, " its load table for ",
                                         std::lround(1000.0 * share) / 10.0, " % of its time in the bed"));
    };
    warn(coverage.speed_above, "speed lay above");
    warn(coverage.depth_outside, "bed depth lay outside");
    warn(coverage.penetration_outside, "penetration lay outside");
  }
  result.airborne = all_airborne_.time;
  result.lifted_at = all_airborne_.first_at;
  report_lift_off(result);
  report_failures(result);
  result.history = history_;
}

}  // namespace apc::simulation
