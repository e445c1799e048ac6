/// Engines still push (or reverse): T0 e^(−t/τ), t from entry, T0 before; on the whole aircraft.
/// Source: spool-down of turbofans; range estimated.
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::effects {

Effect thrust() {
  Effect e;
  e.id = "thrust";
  e.title = "engines still push";
  e.law = "T0 e^(−t/tau) along x, t from entry, T0 before; whole aircraft";
  e.source = "spool-down of turbofans; range estimated";
  e.touches = "deceleration before the bed, fades with time";
  e.confused_with = "slope, aero";
  e.parameters = {{"T0", "N", dimension::force, -4.0e4, 4.0e4, 2.0e4, 0.0},
                  {"tau", "s", dimension::time, 0.5, 10.0, 3.0, 0.0}};
  e.thrust = [](double time, Values q) { return q[0] * (time > 0.0 ? std::exp(-time / q[1]) : 1.0); };
  return e;
}

}  // namespace apc::effects
