// A vector of APC_LANES floats and what the kernels do with it; part of pair_kernels.inl. Only functions with internal
// linkage here: a shared inline compiled for a wide instruction set must never be picked by the linker.
#include <immintrin.h>

namespace apc::sph {
namespace {

#define APC_INLINE inline __attribute__((always_inline))

constexpr int width = APC_LANES;
typedef float Vec __attribute__((vector_size(4 * APC_LANES)));

APC_INLINE Vec splat(float a) { return a - Vec{}; }
APC_INLINE Vec load(const float* p) {
  Vec v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
APC_INLINE void store(float* p, Vec v) { __builtin_memcpy(p, &v, sizeof v); }

#if APC_LANES == 16
constexpr __mmask16 all = 0xffff;  // the unmasked intrinsics warn about their undefined source in GCC 12
APC_INLINE Vec vmax(Vec a, Vec b) { return (Vec)_mm512_maskz_max_ps(all, (__m512)a, (__m512)b); }
APC_INLINE Vec vmin(Vec a, Vec b) { return (Vec)_mm512_maskz_min_ps(all, (__m512)a, (__m512)b); }
APC_INLINE Vec rsqrt0(Vec a) { return (Vec)_mm512_maskz_rsqrt14_ps(all, (__m512)a); }
APC_INLINE Vec rcp0(Vec a) { return (Vec)_mm512_maskz_rcp14_ps(all, (__m512)a); }
APC_INLINE Vec vsqrt(Vec a) { return (Vec)_mm512_maskz_sqrt_ps(all, (__m512)a); }
/// Bit l: lane l is negative.
APC_INLINE unsigned negative(Vec a) { return _mm512_movepi32_mask((__m512i)a); }

/// Appends to `to` the entries of `from` whose bit is set; returns how many. Room for a whole vector is needed.
APC_INLINE int keep(unsigned bits, const std::uint32_t* from, std::uint32_t* to) {
  const auto mask = static_cast<__mmask16>(bits);
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, _mm512_loadu_si512(from)));
  return __builtin_popcount(bits);
}

/// Two neighbours, one in either half: their records by four floats.
struct Near {
  __m512 part[4];
};
template <int parts>
APC_INLINE Near near(const float* records, const std::uint32_t* list) {
  const float *a = records + list[0] * std::size_t{record::size}, *b = records + list[1] * std::size_t{record::size};
  Near n;
  for (int k = 0; k < parts; ++k)
    n.part[k] = _mm512_mask_broadcast_f32x4(_mm512_maskz_broadcast_f32x4(all, _mm_loadu_ps(a + 4 * k)), 0xff00,
                                            _mm_loadu_ps(b + 4 * k));
  return n;
}
template <int field>
APC_INLINE Vec of(const Near& n) {
  return (Vec)_mm512_maskz_permute_ps(all, n.part[field / 4], (field % 4) * 0x55);
}
/// Sums over both halves of two clusters' vectors, side by side.
APC_INLINE Vec join(Vec first, Vec second) {
  const __m512 a = (__m512)first, b = (__m512)second;
  return (Vec)_mm512_maskz_shuffle_f32x4(all, a, b, 0x44) + (Vec)_mm512_maskz_shuffle_f32x4(all, a, b, 0xee);
}
#else
#if APC_LANES == 8
APC_INLINE Vec vmax(Vec a, Vec b) { return (Vec)_mm256_max_ps((__m256)a, (__m256)b); }
APC_INLINE Vec vmin(Vec a, Vec b) { return (Vec)_mm256_min_ps((__m256)a, (__m256)b); }
APC_INLINE Vec rsqrt0(Vec a) { return (Vec)_mm256_rsqrt_ps((__m256)a); }
APC_INLINE Vec rcp0(Vec a) { return (Vec)_mm256_rcp_ps((__m256)a); }
APC_INLINE Vec vsqrt(Vec a) { return (Vec)_mm256_sqrt_ps((__m256)a); }
APC_INLINE unsigned negative(Vec a) { return static_cast<unsigned>(_mm256_movemask_ps((__m256)a)); }
#else
APC_INLINE Vec vmax(Vec a, Vec b) { return (Vec)_mm_max_ps((__m128)a, (__m128)b); }
APC_INLINE Vec vmin(Vec a, Vec b) { return (Vec)_mm_min_ps((__m128)a, (__m128)b); }
APC_INLINE Vec rsqrt0(Vec a) { return (Vec)_mm_rsqrt_ps((__m128)a); }
APC_INLINE Vec rcp0(Vec a) { return (Vec)_mm_rcp_ps((__m128)a); }
APC_INLINE Vec vsqrt(Vec a) { return (Vec)_mm_sqrt_ps((__m128)a); }
APC_INLINE unsigned negative(Vec a) { return static_cast<unsigned>(_mm_movemask_ps((__m128)a)); }
#endif
#endif

APC_INLINE Vec where_negative(Vec a, Vec yes, Vec no) { return a < 0.0f ? yes : no; }
APC_INLINE double sum(Vec a) {
  double total = 0.0;
  for (int l = 0; l < width; ++l) total += a[l];
  return total;
}

}  // namespace
}  // namespace apc::sph
