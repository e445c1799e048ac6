/// Where a contact lies on a table's axes, and the spline's sums there; for the look-ups themselves.
#pragma once

#include <algorithm>
#include <cmath>

#include "loadtables/load_table_data.h"
#include "loadtables/spline_sum.h"

namespace apc::loadtables {

/// Place of a contact on the table's axes.
struct Place {
  double speed, u, ratio, scale;  ///< scale = P_max
};

inline Place place(const LoadTable::Data& data, const TireContact& contact) {
  const double depth = contact.bed_depth > 0.0 ? contact.bed_depth : 0.0;
  const double scale = data.penetration.at(depth);
  return {std::abs(contact.speed), DepthScale::at(depth), contact.penetration / scale, scale};
}

inline const double* line(const LoadTable::Data& data, const Weights& v, int i, const Weights& u, int j,
                          const Weights& r) {
  const std::size_t depth = static_cast<std::size_t>(data.depth.coefficients()),
                    ratio = static_cast<std::size_t>(data.ratio.coefficients());
  return data.coefficients.data() +
         ((static_cast<std::size_t>(v.first + i) * depth + static_cast<std::size_t>(u.first + j)) * ratio +
          static_cast<std::size_t>(r.first)) *
             responses;
}

inline SplineCell cell(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r) {
  const std::size_t by_j = static_cast<std::size_t>(data.ratio.coefficients()) * responses;
  return {line(data, v, 0, u, 0, r),
          static_cast<std::size_t>(data.depth.coefficients()) * by_j,
          by_j,
          v.value,
          u.value,
          r.value,
          v.slope,
          u.slope,
          r.slope};
}

inline void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r,
                     double (&value)[responses]) {
  spline_kernels().value(cell(data, v, u, r), value);
}

inline void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r,
                     SplineSums& point) {
  spline_kernels().slopes(cell(data, v, u, r), point);
}

/// Beyond it the spline is no longer asked: there the tire stands on crushed foam (crushed_through.h).
inline double last_ratio(const Axis& ratio) { return std::min(1.0, ratio.high()); }
/// The same in intervals of the axis; all look-ups ask in intervals, so that they agree about contacts on the edge.
inline double last_ratio_steps(const Axis& ratio) { return (last_ratio(ratio) - ratio.low) * (1.0 / ratio.step); }
inline bool beyond_ratio(const Axis& axis, double ratio) {
  const double steps = (ratio - axis.low) * (1.0 / axis.step);
  return !(steps >= 0.0 && steps <= last_ratio_steps(axis));
}

inline bool beyond(const Axis& axis, double x) { return x < axis.low || x > axis.high(); }

}  // namespace apc::loadtables
