/// The shipped effects, one file each.
#pragma once

#include "apc/effects/effect.h"

namespace apc::effects {

Effect inertial();
Effect rate();
Effect seams();
Effect softening();
Effect ageing();
Effect temperature();
Effect wall_tear();
Effect adhesion();
Effect rubble_friction();
Effect debris();
Effect cover();
Effect lock_up();
Effect depth_as_built();
Effect slope();
Effect aero();
Effect thrust();
Effect tire_loss();
Effect oleo_friction();

/// All of the above, in this order.
const std::vector<Effect>& catalogue();

/// By id. InputError with the nearest id when there is none.
const Effect& find_effect(const std::vector<Effect>&, const std::string& id);

}  // namespace apc::effects
