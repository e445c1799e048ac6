// Spline sums for x86-64-v3: 4 doubles per vector.
#define APC_LANES 4
#include "loadtables/spline_sum.inl"

const SplineKernels& spline_kernels_v3() {
  static constexpr SplineKernels kernels{value, slopes, line};
  return kernels;
}

}  // namespace apc::loadtables
