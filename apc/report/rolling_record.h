/// One SPH run of a tire rolling through foam, as reports need it: what was asked, what came out, where every joule
/// went. Plain numbers in SI; loads are of the whole tire, the energy account is of the modelled half.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apc/report/record.h"
#include "apc/report/unit_system.h"

namespace apc::report {

/// One measured length of the rut, m; NaN where there was nothing to measure.
struct ShapeOfRut {
  std::string key, name;
  double value = 0.0;
};

struct RollingRecord {
  std::string name, source, tire, material;
  double speed = 0.0, bed_depth = 0.0, penetration = 0.0, maximum_penetration = 0.0;
  double tire_diameter = 0.0, tire_width = 0.0, spacing = 0.0, friction = 0.0;
  double fall = 0.0;  ///< of the axle per length of way; loads are then means around the penetration

  std::string state, message;  ///< "steady", "did_not_settle", …
  bool steady = false;
  double drag = 0.0, vertical = 0.0, rut_depth = 0.0, surface_left = 0.0, spin_ratio = 0.0, tire_deflection = 0.0;
  double drag_change = 0.0, vertical_change = 0.0, spin_change = 0.0;  ///< between the last two windows
  double internal_energy_rate = 0.0;                                   ///< J/m
  double residual = 0.0;                                               ///< of the account, relative to its input
  std::vector<std::pair<std::string, double>> energy_in, energy_out;   ///< J of the modelled half
  double compaction = 0.0, partition_min = 0.0, partition_mean = 0.0;
  double particles = 0.0, steps = 0.0, particle_steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
  double bytes_per_particle = 0.0;

  std::vector<double> time, distance, drag_history, vertical_history, spin_history, deflection_history;
  std::vector<double> section_y, section_z, section_compaction;  ///< one slice behind the tire; z from the top up
  std::vector<double> wheel_y, wheel_z;                          ///< half of what the undeformed wheel would cut, m
  std::vector<ShapeOfRut> shape;                                 ///< what was measured in that slice, in lines
  Manifest manifest;
};

std::string rolling_brief(const RollingRecord&, UnitSystem);
std::string rolling_json(const RollingRecord&);
std::string rolling_csv(const RollingRecord&);
std::string rolling_page(const RollingRecord&);

}  // namespace apc::report
