// Pair kernels for x86-64-v4: 8 particles and two of their neighbours per vector.
#define APC_LANES 16
#include "sph_backend/pair_kernels.inl"

namespace apc::sph {

const PairKernels& kernels_v4() {
  static constexpr PairKernels kernels{"x86-64-v4", strain, accelerate, multiply_add, read, filter};
  return kernels;
}

}  // namespace apc::sph
