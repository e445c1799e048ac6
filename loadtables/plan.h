/// Which runs to make for one tire in one material: corner points of the box, so that the metamodel never extrapolates
/// inside it, and a maximin Latin hypercube between them, improved by swapping pairs (Morris and Mitchell 1995, J.
/// Stat. Plan. Inference 43, 381–402). Ranges and the definition of relative penetration: ACRP Report 29, §9.4.4.1.
///
/// Coordinates of the hypercube: speed; logarithm of the bed depth (then rounded to an increment, as beds are built of
/// courses); relative penetration, with 85 % of the runs in [0.3, 1], where tires ride.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/units.h"
#include "loadtables/load_table.h"

namespace apc::loadtables {

struct PlanOptions {
  int runs = 60;  ///< corners included
  unsigned seed = 1;
  std::array<double, 2> speed{10.0 * units::kt, 70.0 * units::kt};
  std::array<double, 2> bed_depth{3.0 * units::in, 36.0 * units::in};
  std::array<double, 2> relative_penetration{0.1, 1.0};
  double depth_increment = 1.0 * units::in;
};

struct PlannedRun {
  int id = 0;  ///< from 1
  TireContact contact;
  double relative_penetration = 0.0;
};

/// In an order in which any first part of the runs covers the box about evenly.
struct Plan {
  std::string material;
  TableTire tire;
  PlanOptions options;
  std::vector<PlannedRun> runs;  ///< options.runs of the design, and any that were added later
};

/// InputError for ranges that make no box or too few runs. The same seed gives the same plan everywhere.
Plan make_plan(const TableTire&, const std::string& material, const PlanOptions& = {});

/// plan.json, schema "apc-load-plan/1".
void write_plan(const Plan&, const std::filesystem::path& folder);
Plan read_plan(const std::filesystem::path& folder);

}  // namespace apc::loadtables
