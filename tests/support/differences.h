/// Whole runs beside carried sensitivities: central differences at a tight tolerance.
#pragma once

#include <map>
#include <string>

#include "apc/simulation/sensitivity.h"
#include "tests/support/simulation_models.h"

namespace apc::testing {

using simulation::Model, simulation::Options, simulation::Overrun, simulation::ScalarParameter;

struct Difference {
  double stop, exit, drag, vertical;
};

/// Every scalar of a result that a sensitivity has a derivative of, by name.
inline std::map<std::string, double> scalars(const simulation::Result& result) {
  std::map<std::string, double> all{{"stop_distance", result.stop_distance},
                                    {"exit_speed", result.exit_speed},
                                    {"stop_time", result.stop_time},
                                    {"peak_deceleration", result.peak_deceleration},
                                    {"peak_deceleration_100ms", result.peak_deceleration_100ms},
                                    {"mean_deceleration", result.mean_deceleration},
                                    {"peak_pitch", result.peak_pitch},
                                    {"lowest_pitch", result.lowest_pitch}};
  for (const auto& gear : result.gears)
    for (const auto& [name, value] : {std::pair{"peak_drag", gear.peak_drag},
                                      {"peak_vertical", gear.peak_vertical},
                                      {"mean_drag", gear.mean_drag},
                                      {"drag_margin", gear.drag_margin},
                                      {"ultimate_margin", gear.ultimate_margin},
                                      {"vertical_margin", gear.vertical_margin},
                                      {"peak_stroke", gear.peak_stroke},
                                      {"peak_rut", gear.peak_rut},
                                      {"peak_penetration", gear.peak_penetration},
                                      {"peak_tire_load", gear.peak_tire_load}})
      all[gear.name + " " + name] = value;
  for (const auto& [name, value] : result.energy)
    if (name != "residual") all["energy " + name] = value;
  return all;
}
inline std::map<std::string, double> scalars(const simulation::Sensitivity& by) {
  simulation::Result as_result;  // the same names hold the derivatives
  as_result.stop_distance = by.stop_distance, as_result.exit_speed = by.exit_speed;
  as_result.stop_time = by.stop_time, as_result.peak_deceleration = by.peak_deceleration;
  as_result.peak_deceleration_100ms = by.peak_deceleration_100ms;
  as_result.mean_deceleration = by.mean_deceleration;
  as_result.peak_pitch = by.peak_pitch, as_result.lowest_pitch = by.lowest_pitch;
  for (const auto& gear : by.gears) {
    simulation::GearSummary one;
    one.name = gear.name;
    one.peak_drag = gear.peak_drag, one.peak_vertical = gear.peak_vertical, one.mean_drag = gear.mean_drag;
    one.drag_margin = gear.drag_margin, one.ultimate_margin = gear.ultimate_margin;
    one.vertical_margin = gear.vertical_margin, one.peak_stroke = gear.peak_stroke, one.peak_rut = gear.peak_rut;
    one.peak_penetration = gear.peak_penetration, one.peak_tire_load = gear.peak_tire_load;
    as_result.gears.push_back(one);
  }
  as_result.energy = by.energy;
  return scalars(as_result);
}

/// Central differences of all of them, with two steps: where these disagree, differences are no measure.
struct Differences {
  std::map<std::string, double> base, narrow, wide;
};
/// Extremes are seen at instants `sampling` apart: a corner between two of them is met within half of that.
inline Differences all_differences(const Model& model, const Overrun& overrun, const ScalarParameter& parameter,
                                   double step, double sampling) {
  Options options;
  options.rtol = 1e-9;
  options.sampling = sampling;
  const auto run = [&](double amount) {
    auto changed = model;
    auto other = overrun;
    parameter.shift(changed, other, amount);
    return scalars(simulation::simulate(changed, other, options));
  };
  const auto slope = [&](double by) {
    const auto up = run(by), down = run(-by);
    std::map<std::string, double> all;
    for (const auto& [name, value] : up) all[name] = (value - down.at(name)) / (2 * by);
    return all;
  };
  return {run(0.0), slope(step), slope(2 * step)};
}

/// Central difference through whole runs at tight tolerance.
inline Difference differenced(const Model& model, const Overrun& overrun, const ScalarParameter& parameter,
                              double step) {
  Options options;
  options.rtol = 1e-9;
  options.sampling = 0.0;
  const auto run = [&](double amount) {
    auto changed = model;
    auto other = overrun;
    parameter.shift(changed, other, amount);
    return simulation::simulate(changed, other, options);
  };
  const auto up = run(step), down = run(-step);
  return {(up.stop_distance - down.stop_distance) / (2 * step), (up.exit_speed - down.exit_speed) / (2 * step),
          (up.gears[0].peak_drag - down.gears[0].peak_drag) / (2 * step),
          (up.gears[1].peak_vertical - down.gears[1].peak_vertical) / (2 * step)};
}

inline Overrun braked(double knots) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  overrun.braking = 0.2;
  return overrun;
}

}  // namespace apc::testing
