/// The balance of forces along a measured motion: what the load tables say each wheel did in the rut it was surveyed
/// in, and what the aircraft's accelerations should then have been. At a given rut D of given speed and depth the
/// foam's vertical load and drag are those of the table at the penetration P with rut(P) = D; both are proportional to
/// the strength. Vertical loads carry the response to sinking of a rigid wheel (simulation::Sinking, factor 1), loads
/// are turned with a falling base, and the tire's own rolling resistance, as on pavement, goes on inside the bed.
#pragma once

#include "apc/learning/motion.h"

namespace apc::learning {

/// A gear group as the balance needs it.
struct GearFacts {
  bool nose = false;
  double behind = 0.0;  ///< m behind the nose gear
  int wheels = 2;       ///< of all struts
  double radius = 0.0;
  const loadtables::LoadTable* table = nullptr;
  effects::TireFacts tire;
};

/// Nose and one main group on single axles; empty for any other aircraft, which this balance cannot tell apart.
std::vector<GearFacts> gear_facts(const Case&);

/// Per gear group and sample: loads of all its wheels (N) in the tire's own axes and on the aircraft; per sample the
/// accelerations they make (m/s², m/s² over gravity, rad/s² nose up).
struct Balance {
  std::vector<std::vector<double>> drag, vertical, force_x, force_z;
  Eigen::VectorXd along, up, pitching;
};

/// Loads at the motion's ruts with the given alterations. `penetration`, where not null, receives what was found.
Balance balance_at_ruts(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
                        const effects::Alterations&, std::vector<std::vector<double>>* penetration = nullptr);

/// Relative changes of drag and vertical load of one gear at one sample.
struct LoadChange {
  double drag = 0.0, vertical = 0.0;
};
/// `base` with loads changed by `change(gear, sample)`, to first order and at the same ruts.
Balance changed(const Balance& base, const Case&, const std::vector<GearFacts>&, const Run&, const Motion&,
                const std::function<LoadChange(std::size_t, std::size_t)>& change);

/// Ruts and penetrations of a motion made to agree, within their errors, with the vertical loads that the measured
/// accelerations ask for: near lock-up the load tells the rut better than the survey does. Fills `penetration` and
/// `incline`. Without acceleration_z and pitch rate the survey stands alone.
void settle(const Case&, const std::vector<GearFacts>&, const Run&, Motion&);

}  // namespace apc::learning
