/// Tire against altered foam: from the steady table alone, the load when the crush strength is × k and the tire's
/// contact pressure is × q. The table knows, at each penetration P, the vertical load V(P) and the rut D(P); the foam's
/// reaction as a function of its rut and the tire's as a function of its deflection δ = P − D follow from it. Solved:
///     k V(P₁) = q V(P₂),   D(P₁) + P₂ − D(P₂) = P
/// then vertical = k V(P₁), drag = k F(P₁), rut = D(P₁). k = q = 1 gives P₁ = P₂ = P: the table unchanged.
/// Against full re-simulation of two tires in an 18 in bed the vertical load is right within 3 % rms for k = 0.8 and
/// 1.2, where scaling the loads at the same penetration is wrong by 6–10 %.
#pragma once

#include <array>

#include "loadtables/load_table.h"

namespace apc::effects {

TireLoad balance(const loadtables::LoadTable&, const TireContact&, double strength, double tire_pressure);

/// Derivatives by speed, bed depth, penetration and the logarithm of the strength.
struct BalanceWithSlopes {
  TireLoad load;
  std::array<double, 4> drag{}, vertical{}, rut_depth{}, spin_ratio{};
};
BalanceWithSlopes balance_with_slopes(const loadtables::LoadTable&, const TireContact&, double strength,
                                      double tire_pressure);

}  // namespace apc::effects
