#include "loadtables/spline_sum.h"

namespace apc::loadtables {

const SplineKernels& spline_kernels() {
  static const SplineKernels& best = __builtin_cpu_supports("x86-64-v4")   ? spline_kernels_v4()
                                     : __builtin_cpu_supports("x86-64-v3") ? spline_kernels_v3()
                                                                           : spline_kernels_v2();
  return best;
}

}  // namespace apc::loadtables
