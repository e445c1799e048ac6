/// Models of shipped files alone: aircraft, tires, beds and load tables as a user has them.
#pragma once

#include "apc/bed/bed.h"
#include "tests/support/simulation_models.h"

namespace apc::testing {

/// The shipped tables of an aircraft's tires in 50 psi foam.
inline std::vector<loadtables::LoadTable> shipped_tables(const aircraft::Aircraft& plane) {
  std::vector<loadtables::LoadTable> tables;
  for (const auto& [name, tire] : plane.tires)
    tables.push_back(loadtables::load_table(shipped("loadtables/data/" + name + "_foam_50psi.h5")));
  return tables;
}

inline simulation::Model shipped_model(const std::string& aircraft, const bed::Bed& bed) {
  auto plane = shipped_aircraft(aircraft);
  const auto tables = shipped_tables(plane);
  return simulation::make_model(std::move(plane), bed, tables);
}

/// A shipped bed, lengthened until everything stops in it.
inline simulation::Model shipped_model(const std::string& aircraft, const std::string& bed_name) {
  auto bed = bed::load_bed(shipped("designs/beds/" + bed_name + ".json"));
  bed.distance.push_back(bed.distance.back() + 1500.0);
  bed.depth.push_back(bed.depth.back());
  return shipped_model(aircraft, bed);
}

}  // namespace apc::testing
