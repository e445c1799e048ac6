/// The press of press_rig.h on finite elements.
#pragma once

#include "sph_backend/fem/mesh.h"
#include "sph_backend/press_rig.h"

namespace apc::sph::fem {

/// How the elements are integrated and steadied.
struct Elements {
  Integration integration = Integration::one_point;
  Hourglass hourglass = Hourglass::stiffness;
  double hourglass_factor = 0.05;
  double cfl = 0.5;
};

PressResult press(const PressCase&, const Elements& = {});

}  // namespace apc::sph::fem
