/// Laws of other form for effects of the catalogue: what happens to a bed seldom keeps to the formula somebody wrote
/// down for it. They carry the id of their effect and the name of their form; the learning weighs them beside the
/// catalogue's law under the same id.
#pragma once

#include "apc/effects/catalogue.h"

namespace apc::effects {

Effect softening_rows();
Effect inertial_limited();
Effect thrust_held();
Effect aero_wind();
Effect depth_as_built_wave();
Effect tire_loss_slow();
Effect rate_strain();

/// All of the above, in this order.
const std::vector<Effect>& other_forms();

/// "softening", "softening (rows)".
std::string named(const Effect&);

/// Not weighed but part of the background of every case: tables of even foam lock up more sharply than scattered
/// blocks.
Effect lock_up_gradual();

}  // namespace apc::effects
