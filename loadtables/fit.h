/// From samples to a table: radial-basis metamodel per response on physically scaled loads, shape chosen by
/// leave-one-out error (Rippa 1999), then resampled to a C² tensor-product cubic B-spline.
#pragma once

#include "loadtables/samples.h"

namespace apc::loadtables {

struct FitOptions {
  int speed_nodes = 8, depth_nodes = 29, ratio_nodes = 61;  ///< of the spline table
  double strength = 0.0;  ///< nominal crushing strength, Pa, for the scaling; 0 = estimated from the samples
  double rolling_resistance = 0.014;  ///< drag / vertical on the pavement row
};

/// Throws InputError when the samples cannot carry a table (too few, a response missing, not finite).
LoadTable fit(const SampleSet&, const TableTire&, const Provenance&, const FitOptions& = {});

}  // namespace apc::loadtables
