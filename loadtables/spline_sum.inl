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

void value(const SplineCell& cell, double* result) {
  const double *v = cell.v, *u = cell.u;
  double sum[16];
  for (int p = 0; p < parts; ++p) {
    Lanes total{};
    for (int j = 0; j < 4; ++j) {
      const double* c = cell.first + static_cast<std::size_t>(j) * cell.by_j;
      total += u[j] * (v[0] * part(c, p) + v[1] * part(c + cell.by_i, p) + v[2] * part(c + 2 * cell.by_i, p) +
                       v[3] * part(c + 3 * cell.by_i, p));
    }
    part(sum, p) = total;
  }
  along_ratio(sum, cell.r, result);
}

void slopes(const SplineCell& cell, SplineSums& result) {
  const double *v = cell.v, *u = cell.u, *dv = cell.v_slope, *du = cell.u_slope;
  double sum[16], by_v[16], by_u[16];
  for (int p = 0; p < parts; ++p) {
    Lanes total{}, along_v{}, along_u{};
    for (int j = 0; j < 4; ++j) {
      const double* c = cell.first + static_cast<std::size_t>(j) * cell.by_j;
      const Lanes c0 = part(c, p), c1 = part(c + cell.by_i, p), c2 = part(c + 2 * cell.by_i, p),
                  c3 = part(c + 3 * cell.by_i, p);
      const Lanes line = v[0] * c0 + v[1] * c1 + v[2] * c2 + v[3] * c3;
      total += u[j] * line;
      along_u += du[j] * line;
      along_v += u[j] * (dv[0] * c0 + dv[1] * c1 + dv[2] * c2 + dv[3] * c3);
    }
    part(sum, p) = total, part(by_v, p) = along_v, part(by_u, p) = along_u;
  }
  along_ratio(sum, cell.r, result.value);
  along_ratio(sum, cell.r_slope, result.by_r);
  along_ratio(by_v, cell.r, result.by_v);
  along_ratio(by_u, cell.r, result.by_u);
}

void line(const SplineCell& cell, double* sum) {
  const double *v = cell.v, *u = cell.u;
  for (int p = 0; p < 2 * parts; ++p) {
    Lanes total{};
    for (int j = 0; j < 4; ++j) {
      const double* c = cell.first + static_cast<std::size_t>(j) * cell.by_j;
      total += u[j] * (v[0] * part(c, p) + v[1] * part(c + cell.by_i, p) + v[2] * part(c + 2 * cell.by_i, p) +
                       v[3] * part(c + 3 * cell.by_i, p));
    }
    part(sum, p) = total;
  }
}

}  // namespace
