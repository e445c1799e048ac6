#include "apc/base/require.h"
#include "apc/simulation/simulate.h"

namespace apc::simulation {

Model make_model(aircraft::Aircraft plane, bed::Bed bed, const std::vector<loadtables::LoadTable>& tables) {
  Model model;
  for (const auto& gear : plane.gears) {
    const loadtables::LoadTable* found = nullptr;
    std::string names;
    for (const auto& table : tables) {
      names += (names.empty() ? "" : ", ") + table.tire().name;
      if (table.tire().name == gear.tire) found = &table;
    }
    require(found != nullptr, "no load table for the tire ", gear.tire, " of the ", gear.name, " gear of the ",
            plane.name, " in ", bed.material, " (there are: ", names.empty() ? "none" : names,
            "). Make one with `apc loads`");
    model.tables.push_back(*found);
  }
  model.aircraft = std::move(plane);
  model.bed = std::move(bed);
  return model;
}

}  // namespace apc::simulation
