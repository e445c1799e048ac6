/// Models for tests of the dynamics: shipped aircraft on ground whose law is known in closed form.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <string>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/units.h"
#include "apc/simulation/simulate.h"
#include "apc/simulation/table_tire.h"
#include "loadtables/crush_balance.h"
#include "loadtables/load_table_data.h"

namespace apc::testing {

inline aircraft::Aircraft shipped_aircraft(const std::string& name) {
  const auto folder = shipped("aircraft/data");
  return aircraft::load_aircraft(folder / (name + ".json"), aircraft::load_tires(folder / "tires.json"));
}

/// Loads that are affine in speed and in penetration (product terms allowed); the spline then holds them exactly.
using AffineLaw = std::function<TireLoad(double speed, double penetration)>;

inline loadtables::LoadTable exact_table(const aircraft::Tire& tire, const AffineLaw& law) {
  auto data = std::make_shared<loadtables::LoadTable::Data>();
  data->tire = simulation::table_tire(tire);
  data->provenance.material = "closed form";
  data->penetration = loadtables::penetration_scale(data->tire);
  data->speed = loadtables::axis(0.0, 80.0, 5);
  data->depth = loadtables::axis(1.0, loadtables::DepthScale::at(1.0), 5);
  data->ratio = loadtables::axis(0.0, 2.0, 5);
  data->speeds = {0.0, 80.0};
  data->depths = {0.0, 1.0};
  data->ratios = {0.0, 2.0};
  for (int i = 0; i < data->speed.coefficients(); ++i)
    for (int j = 0; j < data->depth.coefficients(); ++j)
      for (int k = 0; k < data->ratio.coefficients(); ++k) {
        const auto load = law(data->speed.node(i - 1), data->ratio.node(k - 1) * data->penetration.at(0.0));
        data->coefficients.insert(data->coefficients.end(), {load.drag, load.vertical, 0.0, 0.0});
      }
  return loadtables::LoadTable(std::shared_ptr<const loadtables::LoadTable::Data>(std::move(data)));
}

/// Pavement without end.
inline bed::Bed pavement() {
  bed::Bed bed;
  bed.name = "pavement";
  bed.source = "made for a test";
  bed.material = "closed form";
  bed.width = 60.0;
  bed.distance = {0.0, 5000.0};
  bed.depth = {0.0, 0.0};
  return bed;
}

/// Setback, a ramp down to `depth` over `ramp`, level to `length`; top flush.
inline bed::Bed foam_bed(double depth, double ramp = 15.24, double length = 900.0) {
  bed::Bed bed = pavement();
  bed.name = "foam";
  bed.setback = 15.24;
  if (ramp > 0.0) {
    bed.distance = {0.0, ramp, length};
    bed.depth = {0.0, depth, depth};
  } else {
    bed.distance = {0.0, length};
    bed.depth = {depth, depth};
  }
  return bed;
}

inline loadtables::CrushBalance crush_law(const aircraft::Tire& tire, double strength = 50 * units::psi) {
  loadtables::CrushBalance law;
  law.tire = tire.load_curve;
  law.radius = tire.radius();
  law.width = tire.width;
  law.strength = strength;
  return law;
}

/// The crush law at the nodes of a spline table (C² in between): what a fit to dense samples without noise would be.
inline loadtables::LoadTable law_table(const aircraft::Tire& tire, const loadtables::CrushBalance& law,
                                       int refine = 1) {
  auto data = std::make_shared<loadtables::LoadTable::Data>();
  data->tire = simulation::table_tire(tire);
  data->provenance.material = "closed form";
  data->penetration = loadtables::penetration_scale(data->tire);
  data->speed = loadtables::axis(0.0, 40.0, 4);
  data->depth = loadtables::axis(1.0, loadtables::DepthScale::at(1.0), 16 * refine + 1);
  data->ratio = loadtables::axis(0.0, 1.2, 24 * refine + 1);
  data->speeds = {5.0, 40.0};
  data->depths = {0.0, 1.0};
  data->ratios = {0.0, 1.0};
  const auto along_depth = loadtables::interpolation(data->depth, loadtables::LowerEnd::linear);
  const auto along_ratio = loadtables::interpolation(data->ratio, loadtables::LowerEnd::linear);
  // The law does not depend on speed: one depth × ratio plane per response serves all speeds.
  std::array<Eigen::MatrixXd, 4> planes;
  for (auto& plane : planes) plane.resize(data->depth.nodes, data->ratio.nodes);
  for (int j = 0; j < data->depth.nodes; ++j)
    for (int k = 0; k < data->ratio.nodes; ++k) {
      const double depth = loadtables::DepthScale::depth(data->depth.node(j));
      const auto load = law.load({10.0, depth, data->ratio.node(k) * data->penetration.at(depth)});
      planes[loadtables::drag](j, k) = load.drag;
      planes[loadtables::vertical](j, k) = load.vertical;
      planes[loadtables::rut_depth](j, k) = load.rut_depth;
      planes[loadtables::slip](j, k) = 1.0 - load.spin_ratio;
    }
  for (auto& plane : planes) plane = (along_depth * plane * along_ratio.transpose()).eval();
  for (int i = 0; i < data->speed.coefficients(); ++i)
    for (int j = 0; j < data->depth.coefficients(); ++j)
      for (int k = 0; k < data->ratio.coefficients(); ++k)
        for (const auto& plane : planes) data->coefficients.push_back(plane(j, k));
  return loadtables::LoadTable(std::shared_ptr<const loadtables::LoadTable::Data>(std::move(data)));
}

inline loadtables::LoadTable foam_table(const aircraft::Tire& tire, double strength = 50 * units::psi, int refine = 1) {
  return law_table(tire, crush_law(tire, strength), refine);
}

/// Shipped aircraft with tables of the crush law on a bed of 50 psi foam. Tables are made once per program.
inline simulation::Model foam_model(const std::string& name, const bed::Bed& bed) {
  static std::map<std::string, loadtables::LoadTable> tables;
  auto plane = shipped_aircraft(name);
  std::vector<loadtables::LoadTable> used;
  for (const auto& [tire_name, tire] : plane.tires) {
    if (!tables.contains(tire_name)) tables.emplace(tire_name, foam_table(tire));
    used.push_back(tables.at(tire_name));
  }
  return simulation::make_model(std::move(plane), bed, used);
}

/// Shipped aircraft on pavement with a law of its own for every tire, per newton of static load where wanted.
inline simulation::Model exact_model(aircraft::Aircraft plane, const AffineLaw& law) {
  std::vector<loadtables::LoadTable> tables;
  for (const auto& [name, tire] : plane.tires) tables.push_back(exact_table(tire, law));
  return simulation::make_model(std::move(plane), pavement(), tables);
}

}  // namespace apc::testing
