/// Small cases shared by the SPH tests.
#pragma once

#include "apc/base/units.h"
#include "sph_backend/foam_bed.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph::testing {

inline TireShape main_tire() {
  using namespace units;
  return {"H44.5x16.5-21", 44.5 * in, 16.5 * in,      21.0 * in, 214.0 * psi,
          44700.0 * lbf,   3.5 * in,  121000.0 * lbf, 8.5 * in};
}

inline TireShape nose_tire() {
  using namespace units;
  return {"R18x4.4", 17.9 * in, 4.45 * in, 10.0 * in, 225.0 * psi, 4350.0 * lbf, 0.92 * in, 13050.0 * lbf, 2.02 * in};
}

/// Seconds on one core: a small tire, coarse particles, half-way into a thin bed.
inline RollingCase quick_case() {
  RollingCase c;
  c.tire = nose_tire();
  c.foam = ideal_foam_50psi();
  c.bed_depth = 6.0 * units::in, c.penetration = 3.0 * units::in, c.speed = 60.0 * units::kt;
  c.spacing = 0.9 * units::in;
  c.load_tolerance = 0.05, c.spin_tolerance = 0.05;
  return c;
}

/// A block in empty space, `columns` × rows × layers particles of one inch.
inline BedSpec free_block(int columns, int rows, int layers) {
  BedSpec s;
  s.foam = ideal_foam_50psi();
  s.foam.damping = 0.0;
  s.spacing = 1.0 * units::in;
  s.columns = columns, s.half_width = rows * units::in, s.depth = layers * units::in;
  s.free_body = true;
  s.alpha = s.beta = 0.0;
  return s;
}

}  // namespace apc::sph::testing
