/// Looks at the measurements without any force model: clocks, signs, units, clipping, gaps, copies of one run. What can
/// be repaired beyond doubt is repaired; what cannot is dropped or set aside; every deed is remarked.
///
/// The test between channels is kinematic: speed = v₀ + a ∫ax dt + b t. The regression's a must be near 1 (a near −1: a
/// flipped sign; near 9.81, 0.102, 1.94, 0.514, 3.28, 0.305, 3.6: a wrong unit); ∫ speed dt must give the stop
/// distance.
#pragma once

#include "apc/learning/measured.h"

namespace apc::learning {

/// Checks and repairs all runs of the case; appends to `remarks`.
void check_runs(Case&);

/// Result of regressing speed on the integral of the acceleration.
struct KinematicFit {
  double scale = 1.0, bias = 0.0;  ///< a; b in m/s²
  double residual = 0.0;           ///< rms of speed, m/s
  int samples = 0;
};
/// `bias_prior` is the standard deviation of the accelerometer's constant error, m/s².
KinematicFit kinematic_fit(const Channel& speed, const Channel& acceleration, double bias_prior);

}  // namespace apc::learning
