// Pair kernels for x86-64-v3: 8 particles per vector.
#define APC_LANES 8
#include "sph_backend/pair_kernels.inl"

namespace apc::sph {

const PairKernels& kernels_v3() {
  static constexpr PairKernels kernels{"x86-64-v3", strain, accelerate, multiply_add, read, filter};
  return kernels;
}

}  // namespace apc::sph
