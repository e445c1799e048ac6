/// How an effect is tried: its shapes (all parameters but the amplitude), and the prior of its amplitude.
#pragma once

#include "apc/effects/effect.h"

namespace apc::learning {

/// Shapes worth trying for an effect where the longest run is this long (m): the amplitude is left at its neutral
/// value.
std::vector<effects::Applied> shapes_of(const effects::Effect&, double longest_way);

/// Standard deviation of an amplitude's prior: its range is 95 %.
double amplitude_deviation(const effects::Parameter&);
bool amplitude_positive(const effects::Parameter&);

}  // namespace apc::learning
