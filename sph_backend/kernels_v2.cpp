// Pair kernels for x86-64-v2: 4 particles per vector.
#define APC_LANES 4
#include "sph_backend/pair_kernels.inl"

namespace apc::sph {

const PairKernels& kernels_v2() {
  static constexpr PairKernels kernels{"x86-64-v2", strain, accelerate, multiply_add, read, filter};
  return kernels;
}

}  // namespace apc::sph
