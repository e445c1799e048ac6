/// What a load table is made of; for the builder, the HDF5 file and the checks. Users call LoadTable.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "loadtables/bspline.h"
#include "loadtables/load_table.h"
#include "loadtables/penetration_scale.h"
#include "loadtables/samples.h"

namespace apc::loadtables {

/// Order of the responses in the coefficients. All four vanish with two derivatives at zero penetration.
enum Response : std::size_t { drag, vertical, rut_depth, slip, responses };  // slip = 1 − spin ratio

/// Depth axis of the spline, u(h) = √(1 + h/h₀): fine on the ramp where the loads change fast, coarse in deep beds.
struct DepthScale {
  static constexpr double reference = 0.03;  ///< h₀, m
  static double at(double bed_depth);
  static double slope(double bed_depth);  ///< du/dh, 1/m
  static double depth(double u);
};

struct LoadTable::Data {
  TableTire tire;
  Provenance provenance;
  std::vector<FitQuality> quality;
  std::array<double, 2> speeds{}, depths{}, ratios{};  ///< fitted ranges: m/s, m, 1
  PenetrationScale penetration;                        ///< P_max(h)
  Axis speed, depth, ratio;                            ///< m/s, u(h), r = P / P_max(h)
  /// Shape (speed + 2) × (depth + 2) × (ratio + 2) × responses, last fastest; N, N, m, 1.
  std::vector<double> coefficients;
  /// Largest change made to a node's vertical load so that it grows with penetration, relative to the line's largest.
  double growth_correction = 0.0;
  SampleSet samples;  ///< what it was fitted to, so that it can be refitted, checked and exported
};

}  // namespace apc::loadtables
