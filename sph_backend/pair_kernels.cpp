#include "sph_backend/pair_kernels.h"

namespace apc::sph {

const PairKernels* pair_kernels_of_width(int width) {
  if (width == 16 && __builtin_cpu_supports("x86-64-v4")) return &kernels_v4();
  if (width == 8 && __builtin_cpu_supports("x86-64-v3")) return &kernels_v3();
  if (width == 4 && __builtin_cpu_supports("x86-64-v2")) return &kernels_v2();
  return nullptr;
}

const PairKernels& pair_kernels() {
  for (int width = 16; width > 4; width /= 2)
    if (const auto* kernels = pair_kernels_of_width(width)) return *kernels;
  return kernels_v2();
}

}  // namespace apc::sph
