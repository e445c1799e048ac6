/// Whole runs beside carried sensitivities: central differences at a tight tolerance.
#pragma once

#include "apc/simulation/sensitivity.h"
#include "tests/support/simulation_models.h"

namespace apc::testing {

using simulation::Model, simulation::Options, simulation::Overrun, simulation::ScalarParameter;

struct Difference {
  double stop, exit, drag, vertical;
};

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
