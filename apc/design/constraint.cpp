#include "apc/design/constraint.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/design/windows.h"

namespace apc::design {
namespace {

double drag_limit(const simulation::GearSummary& gear, Criterion criterion) {
  return criterion == Criterion::limit ? gear.drag_limit : gear.drag_ultimate;
}

/// 14 CFR 25.303: ultimate = 1.5 × limit.
double vertical_limit(const simulation::GearSummary& gear, Criterion criterion) {
  return gear.vertical_limit * (criterion == Criterion::limit ? 1.0 : 1.5);
}

/// Penetration of the deepest tire over what its table was fitted to, per row of the history.
std::vector<double> penetration_use(const simulation::Result& result, const simulation::Model& model) {
  const auto& history = result.history;
  std::vector<double> use(history.distance.size(), 0.0);
  for (std::size_t g = 0; g < history.gears.size() && g < model.tables.size(); ++g)
    for (std::size_t i = 0; i < history.gears[g].penetration.size(); ++i) {
      const double depth = history.gears[g].bed_depth[i], penetration = history.gears[g].penetration[i];
      if (depth > 0 && penetration > 0)
        use[i] = std::max(use[i], penetration / model.tables[g].maximum_penetration(depth));
    }
  return use;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

std::string describe(const Constraint& constraint, const Fleet& fleet) {
  if (constraint.kind == Kind::slope || constraint.kind == Kind::bound) return constraint.what;
  const auto& each = fleet.cases[constraint.fleet_case];
  auto name = each.aircraft + ", " + each.name + ": ";
  switch (constraint.kind) {
    case Kind::stop:
      return name + "stop distance";
    case Kind::drag:
      return name + constraint.gear + " gear drag";
    case Kind::vertical:
      return name + constraint.gear + " gear vertical load";
    case Kind::deceleration:
      return name + "peak deceleration";
    case Kind::deceleration_100ms:
      return name + "deceleration over 0.1 s";
    case Kind::table_range:
      return name + "range of the load tables";
    default:
      return name;
  }
}

namespace {

/// The same walk over the limits for names and for values: `add(kind, gear, its limit or 0 when none counts)`; loads of
/// gears per strut.
template <class Add>
void walk_limits(const std::vector<simulation::GearSummary>& gears, const Limits& limits, const Add& add) {
  for (const auto& gear : gears) {
    add(Kind::drag, gear.name, counts(limits, gear.name, "drag") ? drag_limit(gear, limits.criterion) : 0.0);
    add(Kind::vertical, gear.name,
        counts(limits, gear.name, "vertical") ? vertical_limit(gear, limits.criterion) : 0.0);
  }
  add(Kind::deceleration, "", limits.deceleration);
  add(Kind::deceleration_100ms, "", limits.deceleration_100ms);
  add(Kind::table_range, "", limits.table_range ? 1.0 : 0.0);
}

const simulation::GearSummary& gear_of(const simulation::Result& result, const std::string& name) {
  return *std::find_if(result.gears.begin(), result.gears.end(), [&](const auto& gear) { return gear.name == name; });
}

double peak(const simulation::Result& result, const simulation::Model& model, Kind kind, const std::string& gear) {
  switch (kind) {
    case Kind::drag:
      return gear_of(result, gear).peak_drag;
    case Kind::vertical:
      return gear_of(result, gear).peak_vertical;
    case Kind::deceleration:
      return result.peak_deceleration;
    case Kind::deceleration_100ms:
      return result.peak_deceleration_100ms;
    default:
      return largest(penetration_use(result, model));
  }
}

/// The load along the way, per strut; empty where the history does not hold it.
std::vector<double> along(const simulation::Result& result, const simulation::Model& model, Kind kind,
                          const std::string& gear) {
  if (kind == Kind::deceleration) return result.history.deceleration;
  if (kind == Kind::table_range) return penetration_use(result, model);
  if (kind != Kind::drag && kind != Kind::vertical) return {};
  const auto& summary = gear_of(result, gear);
  const auto g = static_cast<std::size_t>(&summary - result.gears.data());
  if (g >= result.history.gears.size()) return {};
  auto load = kind == Kind::drag ? result.history.gears[g].drag : result.history.gears[g].vertical;
  for (double& each : load) each /= summary.struts;
  return load;
}

const std::vector<double>& edges_of(Kind kind, const std::string& gear, const Watch& watch) {
  return kind == Kind::drag && gear == "nose" ? watch.fine : watch.coarse;
}

}  // namespace

std::vector<Constraint> load_constraints(const Fleet& fleet, std::size_t fleet_case, const simulation::Model& model) {
  std::vector<simulation::GearSummary> gears;  // only their names are read
  for (const auto& gear : model.aircraft.gears) gears.emplace_back().name = gear.name;
  std::vector<Constraint> out;
  walk_limits(gears, fleet.limits, [&](Kind kind, const std::string& gear, double) {
    out.push_back({kind, fleet_case, gear, -1, ""});
  });
  return out;
}

double worst_use(const simulation::Result& result, const simulation::Model& model, const Limits& limits) {
  double worst = 0.0;
  walk_limits(result.gears, limits, [&](Kind kind, const std::string& gear, double limit) {
    if (limit > 0) worst = std::max(worst, peak(result, model, kind, gear) / limit);
  });
  return worst;
}

std::size_t windows_of(const Constraint& constraint, const Watch& watch) {
  const auto& edges = edges_of(constraint.kind, constraint.gear, watch);
  return constraint.kind == Kind::deceleration_100ms || edges.size() < 2 ? 1 : 2 * edges.size();
}

Figures figures(const simulation::Result& result, const simulation::Model& model, const Limits& limits,
                double bed_length, const Watch& watch) {
  Figures out;
  const double left_over = result.exit_speed * result.exit_speed / (2 * 0.05 * units::g0);
  out.distance = std::isfinite(result.stop_distance) ? result.stop_distance : bed_length + left_over;
  walk_limits(result.gears, limits, [&](Kind kind, const std::string& gear, double limit) {
    out.use.push_back(limit > 0 ? peak(result, model, kind, gear) / limit : 0.0);
    const auto count = windows_of({kind, 0, gear, -1, ""}, watch);
    out.windows.emplace_back(count, limit > 0 ? out.use.back() : 0.0);
    if (count < 2 || limit <= 0) return;
    auto load = along(result, model, kind, gear);
    if (load.size() != result.history.distance.size()) return;
    for (double& each : load) each /= limit;
    out.windows.back() = window_peaks(result.history.distance, load, edges_of(kind, gear, watch));
  });
  return out;
}

}  // namespace apc::design
