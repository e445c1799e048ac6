/// The balance of forces along a measured motion, at the loads the wheels carried (carried_loads.h). The tables say how
/// deep a tire sinks under its load, what drag it feels and what rut it leaves; speed, deceleration and the surveyed
/// ruts are compared. Turned this way the balance is well conditioned: a tire near lock-up carries any load in the same
/// rut, but a rut tells its load badly.
///
/// On the plateau of a foam a few percent of load are a quarter of the depth, so what a wheel does between two places
/// counts: with P its penetration, α its path against the base and m its axle's mass,
///     V(P) (1 + α/sin θ) + m P̈ = carried,    α = dP/ds + slope of the base
/// (the response to sinking of a rigid wheel, simulation::Sinking; α/sin θ within ± 0.6), solved from sample to sample.
/// Loads are turned with a falling base. On pavement a tire rolls with the table's resistance there; in the bed the
/// table has it already.
#pragma once

#include "apc/learning/carried_loads.h"

namespace apc::learning {

/// Loads of all wheels of a gear (N) in the tire's own axes, rut and penetration (m), the force along the runway (N);
/// per sample the acceleration all of them make together, m/s².
struct Balance {
  PerGear drag, vertical, rut, penetration, force_x;
  Eigen::VectorXd along;
};

/// Loads, ruts and acceleration where every gear carries `motion.carried`, with the given alterations.
Balance balance_at_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
                         const effects::Alterations&);

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
