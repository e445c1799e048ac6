/// One tire on pavement, ramp or bed: the steady table, altered by effects, and the rut of the row ahead. The only
/// place where loads of the ground are asked for.
///
/// A trailing tire of a bogie meets the rut D₀ of the row ahead, made at the penetration P* with the vertical load
/// F_z*:
///   P ≤ D₀                       no contact
///   F_tire(P − D₀) ≤ c_g F_z*    rides on the floor of the rut: F_z = F_tire(P − D₀), F_x = μ_r F_z, D = D₀
///   otherwise                    deepens it to D = D₀ + rut(P̂) − rut(P*), P̂ from F_tire(P − D) = c V(P̂) with
///                                V(P̂) = F_z* + F_z(P̂) − F_z(P*): F_z = F_tire(P − D),
///                                F_x = F_x(P̂) − F_x(P*) + μ_r F_z: only the further compaction is paid for
/// c = 1 + (c_g − 1) √(D₀/D): on an old floor both halves of the contact patch bear (c_g ≈ 2), in virgin material the
/// front half only; the root keeps the load growing with penetration. Differences to P* make the law continuous
/// whatever the log's interpolation. c_g and μ_r have no public data; they are inputs (estimated).
#pragma once

#include <array>

#include "apc/effects/alterations.h"
#include "apc/simulation/rut_log.h"
#include "apc/simulation/simulate.h"
#include "loadtables/load_table.h"

namespace apc::simulation {

/// The ground as one tire of a gear group meets it.
struct TireBed {
  const loadtables::LoadTable* table = nullptr;
  const effects::Alterations* alterations = nullptr;  ///< null: the plain table
  effects::TireFacts facts;
  RutFollowing following;
};

/// Load with its derivatives by speed, bed depth, penetration and distance along the bed.
struct GroundLoad {
  TireLoad load;
  double virgin_penetration = 0.0, virgin_drag = 0.0, virgin_vertical = 0.0;  ///< what the row behind will find
  std::array<double, 4> drag{}, vertical{}, rut_depth{}, spin_ratio{};
};

/// Ruts shallower than the first count as untouched ground; from the second on they are followed; C¹ in between.
inline constexpr double shallowest_rut = 1e-3, plain_rut = 20e-3;  // m

/// Values only; `ahead` is the rut found at this place, or null for a leading row.
GroundLoad ground_load(const TireBed&, const effects::TirePlace&, const Rut* ahead);
/// Values and derivatives: from the table's own slopes where it is used plainly, by differences where it is altered.
GroundLoad ground_load_with_slopes(const TireBed&, const effects::TirePlace&, const Rut* ahead);

}  // namespace apc::simulation
