/// The bounce of a model led along the measured speed: it meets the same ramp at the same time and bounces off it
/// alike, for a second or two. Where vertical acceleration was recorded it sharpens what instruments tell of the loads;
/// where it was not, it stands for them.
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

/// Sets `led`; leaves it empty where the model cannot be run.
void lead_swing(const Case&, const Layout&, std::size_t run, double sinking, Motion&);

/// Sets swing and load of the main gear by a run of the nominal model led along the measured speed, its response to
/// sinking that of `sinking` rigid wheels; leaves them where the model cannot be run.
void simulate_swing(const Case&, const Layout&, const std::vector<GearFacts>&, std::size_t run, double sinking,
                    Motion&);

}  // namespace apc::learning
