/// What makes a whole run's drag differ from that of the next, though nothing is hidden: blocks do not average out over
/// the way, the bed is another from day to day, mass and entry speed are known to a percent. Logarithm of the strength.
///     σ² = σ_run² + σ_block² · ½(1 + lateral) · K(way/ℓ) + (σ_m/m)² + (2 σ_v/v)²,   K as in mean_of_scatter.h
#pragma once

#include "apc/learning/measured.h"

namespace apc::learning {

/// Standard deviation; `block_strength` and `correlation` (m) as the case quotes them.
double level_deviation(const Run&, double bed_length, double block_strength, double correlation);

}  // namespace apc::learning
