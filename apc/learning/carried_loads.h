/// What each gear of a measured run carried. It follows from the aircraft's vertical and pitching accelerations (from
/// statics where they were not measured), without any model of the bed:
///     ΣV = m (g + z̈) − lift,    V_nose · wheelbase = I q̇ + m |v̇| · arm + ΣV (x_main − x_cg)
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

/// Where the static load goes.
struct Share {
  double nose = 0.0, main = 0.0;  ///< m behind the nose gear
  /// Static load of one tire, N.
  double static_load(const GearFacts&, double mass, double cg) const;
};
Share share_of(const std::vector<GearFacts>& gears);

/// A gear that bounces off keeps this share of its static load: the tables say little of lighter tires.
inline constexpr double least_share = 0.15;

using PerGear = std::vector<std::vector<double>>;  ///< per gear group, then per sample of the motion

/// What each gear group carries, N, all wheels; at least 0.15 of its static load. `bias` is taken off acceleration_z.
/// `steady`: by statics alone, the measured braking included.
PerGear carried_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&, bool steady,
                      double bias = 0.0);

/// Fills the motion's loads.
void load_motion(const Case&, const std::vector<GearFacts>&, const Run&, Motion&);

}  // namespace apc::learning
