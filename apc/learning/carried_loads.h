/// What each gear of a measured run carried. It follows from the aircraft's vertical and pitching accelerations (from
/// statics where they were not measured):
///     ΣV = m (g + z̈) − lift,    V_nose · wheelbase = I q̇ + m |v̇| · arm + ΣV (x_main − x_cg)
/// and V_nose from its load cell where there is one, freed of the likely part of what it reads above statics before the
/// bed. Instruments shake: each is smoothed after the bounce of a model led along the measured speed has been taken off
/// (simulated_swing.h), which is then put back: loads fall faster at the leading edge than any smoothing lets them.
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

/// What a gear that bounces off keeps of its static load: the tables say little of lighter tires.
double least_load(const GearFacts&, const Share&, const Run&);

using PerGear = std::vector<std::vector<double>>;  ///< per gear group, then per sample of the motion

/// What each gear group carries, N, all wheels; never below least_load(). `bias` is taken off acceleration_z.
/// `steady`: by statics alone, the measured braking included; the motion must have these before the others are asked.
PerGear carried_loads(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&, bool steady,
                      double bias = 0.0);

/// Fills the motion's loads; its bounce of the led model must be set.
void load_motion(const Case&, const std::vector<GearFacts>&, const Run&, Motion&);

}  // namespace apc::learning
