/// The sum over the 4 × 4 × 4 spline coefficients around a point, four responses at a time: the inner loop of every
/// look-up. Compiled once per instruction set, the processor picks at run time; the order of operations is the same at
/// every width and products are not fused with sums, so that all processors give the same bits.
///
///     value = Σ v_i u_j r_k c_ijk;  the slopes with v′, u′ or r′ in place of v, u or r
/// Depth is summed first (along a level bed once for all, table_lanes.h), then speed, then ratio: 176 multiply-adds on
/// vectors of four instead of the 1,024 of the plain triple sum.
#pragma once

#include <cstddef>

namespace apc::loadtables {

/// Coefficients around the point: `first` is c_000; neighbours in k are 4 numbers apart (the responses), in j and i
/// `by_j` and `by_i` numbers. Weights and slopes: four each.
struct SplineCell {
  const double* first;
  std::size_t by_i, by_j;
  const double *v, *u, *r, *v_slope, *u_slope, *r_slope;
};

struct SplineSums {
  double value[4], by_v[4], by_u[4], by_r[4];
};

struct SplineKernels {
  void (*value)(const SplineCell&, double* value);  ///< four values
  void (*slopes)(const SplineCell&, SplineSums&);
  void (*line)(const SplineCell&, double* sum);  ///< over v and u only: 8 coefficients along r × 4 responses
};

/// For the widest instruction set this processor has: AVX-512, AVX2 with FMA, or SSE4.
const SplineKernels& spline_kernels();
const SplineKernels& spline_kernels_v2();
const SplineKernels& spline_kernels_v3();
const SplineKernels& spline_kernels_v4();

}  // namespace apc::loadtables
