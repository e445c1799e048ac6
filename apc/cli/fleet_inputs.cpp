#include "apc/cli/fleet_inputs.h"

#include <algorithm>
#include <map>

#include "apc/base/require.h"
#include "apc/design/profile.h"

namespace apc::cli {
namespace {

void check_case(const design::FleetCase& each, const aircraft::Aircraft& plane, const std::string& place) {
  const auto& run = each.overrun;
  const auto where = concat(place, ": case \"", each.aircraft, ", ", each.name, "\": ");
  require(run.mass == 0 || (run.mass >= 0.4 * plane.mass && run.mass <= 1.6 * plane.mass), where, "mass ", run.mass,
          " kg is no mass of a ", plane.name, " (its file says ", plane.mass, " kg; 40 to 160 % of that is taken)");
  double last = 0.0;
  for (const auto& gear : plane.gears) last = std::max(last, gear.behind_nose_gear);
  require(run.cg_behind_nose_gear < last, where, "centre of gravity ", run.cg_behind_nose_gear,
          " m behind the nose gear lies behind the rearmost gear (", last, " m): the aircraft would tip over");
}

/// A bed that only carries what every bed of this space has; its depth is not used.
bed::Bed site_of(const design::BedSpace& space) {
  const design::Profile any{space.minimum_ramp, 2 * space.minimum_ramp, {space.minimum_depth}};
  return design::bed_of(space, any, 3 * space.minimum_ramp);
}

}  // namespace

FleetModels load_fleet_models(const design::Fleet& fleet, const report::InputFile& fleet_note, const Choice& choice) {
  FleetModels out;
  std::map<std::string, simulation::Model> by_name;
  for (const auto& name : design::aircraft_names(fleet)) {
    auto one = choice;
    one.aircraft = name;
    auto inputs = read_inputs(one, site_of(fleet.bed), fleet_note);
    by_name.emplace(name, std::move(inputs.model));
    for (const auto& file : inputs.files) {
      const bool known = std::any_of(out.files.begin(), out.files.end(),
                                     [&](const report::InputFile& other) { return other.path == file.path; });
      if (known) continue;
      out.files.push_back(file);
      out.identity += file.sha256;
    }
  }
  for (const auto& each : fleet.cases) {
    const auto& model = by_name.at(each.aircraft);
    check_case(each, model.aircraft, fleet_note.path);
    out.models.push_back(model);
  }
  return out;
}

}  // namespace apc::cli
