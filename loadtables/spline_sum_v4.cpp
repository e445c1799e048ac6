// Spline sums for x86-64-v4: 8 doubles per vector.
#define APC_LANES 8
#include "loadtables/spline_sum.inl"

const SplineKernels& spline_kernels_v4() {
  static constexpr SplineKernels kernels{value, slopes, line};
  return kernels;
}

}  // namespace apc::loadtables
