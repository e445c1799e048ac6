/// What was learned from the samples: the crush balance times a smooth ratio per response (logarithms for the loads and
/// the rut, differences for the slip), over speed × bed depth × relative penetration.
///
/// Outside the samples the ratio bends to a constant while the balance goes on: towards v = 0 (level there), P → 0, and
/// above the largest relative penetration, where the balance follows the tire's own curve. Between the pavement (h = 0,
/// the tire's curve itself) and the thinnest sampled bed the ratio fades in smoothly.
#pragma once

#include <array>
#include <vector>

#include "loadtables/crush_balance.h"
#include "loadtables/load_table_data.h"
#include "loadtables/radial_basis.h"

namespace apc::loadtables {

struct Metamodel {
  CrushBalance balance;
  PenetrationScale penetration;
  std::array<double, 2> speeds{}, depths{}, ratios{};  ///< of the samples
  std::vector<RadialBasis> ratio;                      ///< one per response

  /// drag, vertical, rut depth, slip at speed (m/s), bed depth (m) and relative penetration.
  std::array<double, responses> operator()(double speed, double bed_depth, double relative_penetration) const;
};

/// Samples on a bed that is too thin to count (< 2 cm) or without penetration are left out.
std::vector<Sample> usable(const SampleSet&);

Metamodel learn(const std::vector<Sample>&, const TableTire&, double strength, double rolling_resistance);

/// Relative errors of leaving each sample out, rms over the samples with at most this penetration (m), divided by their
/// mean response.
std::array<double, responses> leave_one_out_errors(const Metamodel&, const std::vector<Sample>&, double deepest);

}  // namespace apc::loadtables
