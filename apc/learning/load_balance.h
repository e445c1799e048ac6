/// The balance of forces along a measured motion, at the loads the wheels carried. What each gear carries follows from
/// the aircraft's vertical and pitching accelerations (from statics where they were not measured), without any model
/// of the bed:
///     ΣV = m (g + z̈) − lift,    V_nose · wheelbase = I q̇ + m |v̇| · arm + ΣV (x_main − x_cg)
/// The tables then say how deep a tire sinks under its load, what drag it feels and what rut it leaves; speed,
/// deceleration and the surveyed ruts are compared. Turned this way the balance is well conditioned: a tire near
/// lock-up carries any load in the same rut, but a rut tells its load badly.
///
/// On the plateau of a foam a few percent of load are a quarter of the depth, so what a wheel does between two places
/// counts: with P its penetration, α its path against the base and m its axle's mass,
///     V(P) (1 + α/sin θ) + m P̈ = carried,    α = dP/ds + slope of the base
/// (the response to sinking of a rigid wheel, simulation::Sinking; α/sin θ within ± 0.6), solved from sample to sample.
/// Loads are turned with a falling base, and the tire's own rolling resistance, as on pavement, goes on in the bed.
#pragma once

#include "apc/learning/motion.h"

namespace apc::learning {

/// A gear group as the balance needs it.
struct GearFacts {
  bool nose = false;
  double behind = 0.0;  ///< m behind the nose gear
  int wheels = 2;       ///< of all struts
  double radius = 0.0;
  double unsprung_mass = 0.0;  ///< kg, of one wheel's share
  const loadtables::LoadTable* table = nullptr;
  effects::TireFacts tire;
};

/// Nose and one main group on single axles; empty for any other aircraft, which this balance cannot tell apart.
std::vector<GearFacts> gear_facts(const Case&);

/// A gear that bounces off keeps this share of its static load: the tables say little of lighter tires.
inline constexpr double least_share = 0.15;

using PerGear = std::vector<std::vector<double>>;  ///< per gear group, then per sample of the motion

/// What each gear group carries, N, all wheels; at least 0.15 of its static load. `bias` is taken off acceleration_z.
/// `steady`: by statics alone, the measured braking included.
PerGear carried_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&, bool steady,
                      double bias = 0.0);

/// Loads of all wheels of a gear (N) in the tire's own axes, rut and penetration (m), the force along the runway (N);
/// per sample the acceleration all of them make together, m/s².
struct Balance {
  PerGear drag, vertical, rut, penetration, force_x;
  Eigen::VectorXd along;
};

/// Loads, ruts and acceleration where every gear carries `motion.carried`, with the given alterations.
Balance balance_at_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
                         const effects::Alterations&);

/// Fills the motion's loads.
void load_motion(const Case&, const std::vector<GearFacts>&, const Run&, Motion&);

/// Relative changes of one gear at one sample: of the tables' drag and vertical load at a penetration, of the bed's
/// strength, of the load carried.
struct LoadChange {
  double drag = 0.0, table_vertical = 0.0, strength = 0.0, carried = 0.0;
};

/// A balance with its derivatives, per gear and sample: of a tire's relative load, of the drag of all wheels and of the
/// rut, by penetration and by the logarithm of strength; of the relative load by the two penetrations before.
struct Response {
  Balance base;
  PerGear load_by_depth, load_by_strength, drag_by_depth, drag_by_strength, rut_by_depth, rut_by_strength;
  PerGear load_by_last, load_by_second_last;
  PerGear sinking;  ///< share of the load that is response to sinking
  /// `base` changed to first order.
  Balance to(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
             const std::function<LoadChange(std::size_t gear, std::size_t sample)>&) const;
};
Response response_at_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
                           const effects::Alterations&);

}  // namespace apc::learning
