/// The swing of a gear's load where no vertical acceleration was recorded: a model led along the measured speed meets
/// the same ramp at the same time and bounces off it alike, for a second or two.
#pragma once

#include "apc/learning/carried_loads.h"

namespace apc::learning {

/// True where the swing of the loads does not follow from what was measured.
bool swing_unknown(const Run&);

/// Share of the main gear's simulated swing that is the prior mean of the true one. Calibrated: the slope of measured
/// on simulated swing over the 28 measured cases with known truth that record acceleration_z (correlation 0.92 in the
/// first second of the main gear in the bed, 0.6 in the next). The nose gear's simulated swing says little (0.5, 0.3)
/// and is left out.
inline constexpr double swing_believed = 0.75;

/// Sets swing and load of the main gear by a run of the nominal model led along the measured speed, its response to
/// sinking that of `sinking` rigid wheels; leaves them where the model cannot be run.
void simulate_swing(const Case&, const Layout&, const std::vector<GearFacts>&, std::size_t run, double sinking,
                    Motion&);

}  // namespace apc::learning
