/// Engines still push: T0 until `hold` after entry, then down to nothing in a straight line over `ramp`; on the whole
/// aircraft. Source: thrust levers closed late; range estimated.
#include <algorithm>

#include "apc/effects/other_forms.h"

namespace apc::effects {
Effect thrust_held() {
  Effect e = thrust();
  e.form = "held";
  e.law = "T0 until hold after entry, then linearly to 0 over ramp; whole aircraft";
  e.parameters[1] = {"hold", "s", dimension::time, 0.0, 4.0, 1.0, 0.0};
  e.parameters.push_back({"ramp", "s", dimension::time, 0.5, 8.0, 3.0, 0.0});
  for (const double hold : {0.5, 1.5})
    for (const double ramp : {1.5, 3.5}) e.shapes.push_back({hold, ramp});
  e.thrust = [](double time, Values q) { return q[0] * std::clamp(1.0 - (time - q[1]) / q[2], 0.0, 1.0); };
  return e;
}

}  // namespace apc::effects
