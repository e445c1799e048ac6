/// The last second on the pavement. The state at the leading edge is the quasi-steady trim at the entry speed, so the
/// run meets the entry speed exactly and starts without a transient; the way there is that same quasi-steady motion
/// followed backwards: V(t) from dV/dt = a(V) of the trims, posture between them.
#pragma once

#include "apc/simulation/observer.h"
#include "apc/simulation/trim.h"

namespace apc::simulation {

/// Records history rows at −1 s … −interval before entry, `interval` apart.
void record_roll_in(const Plant&, const Trim& at_entry, double interval, Observer&);

}  // namespace apc::simulation
