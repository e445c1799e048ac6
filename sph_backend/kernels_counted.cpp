// Pair kernels in counting arithmetic: slow, and the same work as the fast ones.
#define APC_LANES 8
#define APC_COUNTED
#include <utility>

#include "sph_backend/pair_kernels.inl"

namespace apc::sph {

const PairKernels& kernels_counted() {
  static constexpr PairKernels kernels{"counted", strain, accelerate, multiply_add, read, filter};
  return kernels;
}

long long take_operations() { return std::exchange(operations, 0); }

}  // namespace apc::sph
