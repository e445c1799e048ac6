// Body of spline_sum_v2/_v3/_v4.cpp; APC_LANES doubles per vector. Nothing here may call inline functions of shared
// headers: the linker keeps one copy of those, and it must not be one for a wider processor.
#include "loadtables/spline_sum.h"

namespace apc::loadtables {
namespace {

using Lanes = double __attribute__((vector_size(8 * APC_LANES), aligned(8), may_alias));
constexpr int parts = 16 / APC_LANES;  // of a row of 4 ratios × 4 responses

inline const Lanes& part(const double* row, int p) { return *reinterpret_cast<const Lanes*>(row + p * APC_LANES); }
inline Lanes& part(double* row, int p) { return *reinterpret_cast<Lanes*>(row + p * APC_LANES); }

inline void along_ratio(const double* row, const double* weight, double* result) {
  for (int m = 0; m < 4; ++m)
    result[m] = weight[0] * row[m] + weight[1] * row[4 + m] + weight[2] * row[8 + m] + weight[3] * row[12 + m];
}

/// Over the depth, for speed `i`.
inline Lanes along_depth(const SplineCell& cell, int i, const double* u, int p) {
  const double* c = cell.first + static_cast<std::size_t>(i) * cell.by_i;
  return u[0] * part(c, p) + u[1] * part(c + cell.by_j, p) + u[2] * part(c + 2 * cell.by_j, p) +
         u[3] * part(c + 3 * cell.by_j, p);
}

void value(const SplineCell& cell, double* result) {
  double sum[16];
  for (int p = 0; p < parts; ++p) {
    Lanes total{};
    for (int i = 0; i < 4; ++i) total += cell.v[i] * along_depth(cell, i, cell.u, p);
    part(sum, p) = total;
  }
  along_ratio(sum, cell.r, result);
}

void slopes(const SplineCell& cell, SplineSums& result) {
  double sum[16], by_v[16], by_u[16];
  for (int p = 0; p < parts; ++p) {
    Lanes total{}, along_v{}, along_u{};
    for (int i = 0; i < 4; ++i) {
      const Lanes line = along_depth(cell, i, cell.u, p);
      total += cell.v[i] * line;
      along_v += cell.v_slope[i] * line;
      along_u += cell.v[i] * along_depth(cell, i, cell.u_slope, p);
    }
    part(sum, p) = total, part(by_v, p) = along_v, part(by_u, p) = along_u;
  }
  along_ratio(sum, cell.r, result.value);
  along_ratio(sum, cell.r_slope, result.by_r);
  along_ratio(by_v, cell.r, result.by_v);
  along_ratio(by_u, cell.r, result.by_u);
}

void line(const SplineCell& cell, double* sum) {
  for (int p = 0; p < 2 * parts; ++p) {
    Lanes total{};
    for (int i = 0; i < 4; ++i) total += cell.v[i] * along_depth(cell, i, cell.u, p);
    part(sum, p) = total;
  }
}

}  // namespace
