/// The energy account: what is stored at a state, and the power every sink takes at an instant. Stored at entry −
/// stored now = Σ ∫ sinks, to the accuracy of the integration: the balance checks equations and solver together.
#pragma once

#include <array>
#include <string_view>

#include "apc/simulation/equations.h"

namespace apc::simulation {

enum class Sink { bed, tires, brakes, wheel_slip, oleo_damping, strut_friction, bogie_damping, aero, thrust };
inline constexpr std::array<std::string_view, 9> sink_names{
    "bed", "tires", "brakes", "wheel_slip", "oleo_damping", "strut_friction", "bogie_damping", "aero", "thrust"};
inline constexpr std::size_t sinks = sink_names.size();

/// J: `bed` and `tires` are the work of the contact forces in the bed and on the pavement (compression included).
struct Stores {
  double kinetic = 0.0, potential = 0.0, oleo_gas = 0.0, stops = 0.0;
  double sum() const { return kinetic + potential + oleo_gas + stops; }
};

Stores stores(const Plant&, const double* y);
/// W taken from the stores by each sink at the instant `moment` of state `y`.
std::array<double, sinks> powers(const Plant&, const Surroundings&, const double* y, const Moment& moment);

}  // namespace apc::simulation
