#include "apc/design/constraint.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"

namespace apc::design {
namespace {

double drag_limit(const simulation::GearSummary& gear, Criterion criterion) {
  return criterion == Criterion::limit ? gear.drag_limit : gear.drag_ultimate;
}

/// 14 CFR 25.303: ultimate = 1.5 × limit.
double vertical_limit(const simulation::GearSummary& gear, Criterion criterion) {
  return gear.vertical_limit * (criterion == Criterion::limit ? 1.0 : 1.5);
}

/// `value` at a place, straight between rows; rows advance along the bed.
double value_at(const std::vector<double>& value, const std::vector<double>& place, double at) {
  const auto above = std::upper_bound(place.begin(), place.end(), at);
  if (above == place.begin()) return value.front();
  if (above == place.end()) return value.back();
  const auto i = static_cast<std::size_t>(above - place.begin());
  const double width = place[i] - place[i - 1];
  return width > 0 ? value[i - 1] + (value[i] - value[i - 1]) * (at - place[i - 1]) / width : value[i];
}

double penetration_use(const simulation::Result& result, const simulation::Model& model) {
  double use = 0.0;
  const auto& history = result.history;
  for (std::size_t g = 0; g < history.gears.size() && g < model.tables.size(); ++g)
    for (std::size_t i = 0; i < history.gears[g].penetration.size(); ++i) {
      const double depth = history.gears[g].bed_depth[i], penetration = history.gears[g].penetration[i];
      if (depth > 0 && penetration > 0) use = std::max(use, penetration / model.tables[g].maximum_penetration(depth));
    }
  return use;
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

/// The same walk over the limits for names and for values: `add(kind, gear index, use)`.
template <class Add>
void walk_limits(const simulation::Result& result, const Limits& limits, double table_use, const Add& add) {
  for (const auto& gear : result.gears) {
    const double drag = counts(limits, gear.name, "drag") ? drag_limit(gear, limits.criterion) : 0.0;
    const double vertical = counts(limits, gear.name, "vertical") ? vertical_limit(gear, limits.criterion) : 0.0;
    add(Kind::drag, gear.name, drag > 0 ? gear.peak_drag / drag : 0.0);
    add(Kind::vertical, gear.name, vertical > 0 ? gear.peak_vertical / vertical : 0.0);
  }
  add(Kind::deceleration, "", limits.deceleration > 0 ? result.peak_deceleration / limits.deceleration : 0.0);
  add(Kind::deceleration_100ms, "",
      limits.deceleration_100ms > 0 ? result.peak_deceleration_100ms / limits.deceleration_100ms : 0.0);
  add(Kind::table_range, "", limits.table_range ? table_use : 0.0);
}

}  // namespace

std::vector<Constraint> load_constraints(const Fleet& fleet, std::size_t fleet_case, const simulation::Model& model) {
  simulation::Result like;  // only its gears' names are read
  for (const auto& gear : model.aircraft.gears) like.gears.emplace_back().name = gear.name;
  std::vector<Constraint> out;
  walk_limits(like, fleet.limits, 0.0, [&](Kind kind, const std::string& gear, double) {
    out.push_back({kind, fleet_case, gear, -1, ""});
  });
  return out;
}

double worst_use(const simulation::Result& result, const simulation::Model& model, const Limits& limits) {
  double worst = 0.0;
  walk_limits(result, limits, limits.table_range ? penetration_use(result, model) : 0.0,
              [&](Kind, const std::string&, double use) { worst = std::max(worst, use); });
  return worst;
}

Figures figures(const simulation::Result& result, const simulation::Model& model, const Limits& limits,
                double bed_length, const std::vector<double>& places) {
  Figures out;
  const double left_over = result.exit_speed * result.exit_speed / (2 * 0.05 * units::g0);
  out.distance = std::isfinite(result.stop_distance) ? result.stop_distance : bed_length + left_over;
  walk_limits(result, limits, penetration_use(result, model),
              [&](Kind, const std::string&, double use) { out.use.push_back(use); });
  for (std::size_t g = 0; g < result.gears.size() && g < result.history.gears.size(); ++g) {
    if (result.gears[g].name != "nose") continue;
    const auto& history = result.history.gears[g];
    const double per_strut = counts(limits, "nose", "drag") ? drag_limit(result.gears[g], limits.criterion) : 0.0;
    const double limit = per_strut * result.gears[g].struts;
    if (history.distance.empty()) continue;
    const double last = std::max(0.0, history.distance.back() - 1.0);
    for (const double at : places)
      out.nose_use.push_back(limit > 0 ? value_at(history.drag, history.distance, std::min(at, last)) / limit : 0.0);
  }
  if (out.nose_use.empty()) out.nose_use.assign(places.size(), 0.0);
  return out;
}

}  // namespace apc::design
