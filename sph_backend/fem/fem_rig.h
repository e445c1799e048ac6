/// The rolling rig of tire_rig.h on finite elements: same tire, contact, path, window, settling and energy account; the
/// mesh has elements of the case's `spacing`, and its columns outside the window are held instead of dropped.
#pragma once

#include "sph_backend/fem/fem_press.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph::fem {

/// Only `progress` and `stop` of the options are used: such runs take minutes.
RollingResult roll(const RollingCase&, const Elements& = {}, const RollOptions& = {});

}  // namespace apc::sph::fem
