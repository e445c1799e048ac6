#include "aircraft/strut.h"

#include <algorithm>

namespace apc::aircraft {

double gas_energy(const Strut& strut, double stroke) {
  const double length = strut.extended_gas_volume / strut.piston_area, x = stroke / length;
  const double n = strut.polytropic_exponent, force = strut.extended_pressure * strut.piston_area;
  const double compression =
      std::abs(n - 1.0) < 1e-9 ? -std::log(1.0 - x) : (std::pow(1.0 - x, 1.0 - n) - 1.0) / (n - 1.0);
  return force * length * compression - atmospheric_pressure * strut.piston_area * stroke;
}

double stop_energy(const Strut& strut, double stroke) {
  const double beyond = std::max({0.0, -stroke, stroke - strut.stroke}), d = stop_softness;
  return strut.end_stop * (0.5 * beyond * beyond - d * beyond + d * d * std::log1p(beyond / d));
}

double static_stroke(const Strut& strut, double load) {
  const double limit = strut.extended_gas_volume / strut.piston_area;
  const double pressure = load / strut.piston_area + atmospheric_pressure;
  if (pressure > 0.0) {  // between the stops the polytrope can be inverted
    const double gas = limit * (1.0 - std::pow(strut.extended_pressure / pressure, 1.0 / strut.polytropic_exponent));
    if (gas >= 0.0 && gas <= strut.stroke) return gas;
  }
  double low = -0.1 * strut.stroke, high = limit * (1.0 - 1e-9);
  while (gas_force(strut, low) + stop_force(strut, low) > load) low *= 2.0;
  for (int i = 0; i < 200 && high - low > 1e-15 * limit; ++i) {
    const double middle = 0.5 * (low + high);
    (gas_force(strut, middle) + stop_force(strut, middle) < load ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace apc::aircraft
