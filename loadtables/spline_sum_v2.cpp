// Spline sums for x86-64-v2: 2 doubles per vector.
#define APC_LANES 2
#include "loadtables/spline_sum.inl"

const SplineKernels& spline_kernels_v2() {
  static constexpr SplineKernels kernels{value, slopes, line};
  return kernels;
}

}  // namespace apc::loadtables
