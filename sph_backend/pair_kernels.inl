// Body of kernels_v2.cpp, kernels_v3.cpp and kernels_v4.cpp; APC_LANES is the vector width in floats. Only functions
// with internal linkage here: a shared inline compiled for a wide instruction set must never be picked by the linker.
#include <immintrin.h>

#include "sph_backend/pair_kernels.h"

namespace apc::sph {
namespace {

constexpr int width = APC_LANES;
typedef float Vec __attribute__((vector_size(4 * APC_LANES)));

inline __attribute__((always_inline)) Vec splat(float a) { return a - Vec{}; }
#if APC_LANES == 16
constexpr __mmask16 all = 0xffff;  // the unmasked intrinsics warn about their undefined source in GCC 12
inline __attribute__((always_inline)) Vec vmax(Vec a, Vec b) {
  return (Vec)_mm512_maskz_max_ps(all, (__m512)a, (__m512)b);
}
inline __attribute__((always_inline)) Vec vmin(Vec a, Vec b) {
  return (Vec)_mm512_maskz_min_ps(all, (__m512)a, (__m512)b);
}
inline __attribute__((always_inline)) Vec rsqrt0(Vec a) { return (Vec)_mm512_maskz_rsqrt14_ps(all, (__m512)a); }
inline __attribute__((always_inline)) Vec rcp0(Vec a) { return (Vec)_mm512_maskz_rcp14_ps(all, (__m512)a); }
inline __attribute__((always_inline)) Vec vsqrt(Vec a) { return (Vec)_mm512_maskz_sqrt_ps(all, (__m512)a); }
#elif APC_LANES == 8
inline __attribute__((always_inline)) Vec vmax(Vec a, Vec b) { return (Vec)_mm256_max_ps((__m256)a, (__m256)b); }
inline __attribute__((always_inline)) Vec vmin(Vec a, Vec b) { return (Vec)_mm256_min_ps((__m256)a, (__m256)b); }
inline __attribute__((always_inline)) Vec rsqrt0(Vec a) { return (Vec)_mm256_rsqrt_ps((__m256)a); }
inline __attribute__((always_inline)) Vec rcp0(Vec a) { return (Vec)_mm256_rcp_ps((__m256)a); }
inline __attribute__((always_inline)) Vec vsqrt(Vec a) { return (Vec)_mm256_sqrt_ps((__m256)a); }
#else
inline __attribute__((always_inline)) Vec vmax(Vec a, Vec b) { return (Vec)_mm_max_ps((__m128)a, (__m128)b); }
inline __attribute__((always_inline)) Vec vmin(Vec a, Vec b) { return (Vec)_mm_min_ps((__m128)a, (__m128)b); }
inline __attribute__((always_inline)) Vec rsqrt0(Vec a) { return (Vec)_mm_rsqrt_ps((__m128)a); }
inline __attribute__((always_inline)) Vec rcp0(Vec a) { return (Vec)_mm_rcp_ps((__m128)a); }
inline __attribute__((always_inline)) Vec vsqrt(Vec a) { return (Vec)_mm_sqrt_ps((__m128)a); }
#endif
// One Newton step on the hardware's estimate: as good as the division, at a third of its cost.
inline __attribute__((always_inline)) Vec rsqrt(Vec a) {
  const Vec y = rsqrt0(a);
  return y * (1.5f - 0.5f * a * y * y);
}
inline __attribute__((always_inline)) Vec vabs(Vec a) { return vmax(a, -a); }
inline __attribute__((always_inline)) Vec load(const float* p) {
  Vec v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline __attribute__((always_inline)) void store(float* p, Vec v) { __builtin_memcpy(p, &v, sizeof v); }
inline __attribute__((always_inline)) Vec column(const float* records, int first, int field) {
  Vec v;
  for (int l = 0; l < width; ++l) v[l] = records[(first + l) * record::size + field];
  return v;
}
#if APC_LANES == 16
inline bool any_negative(Vec a) { return _mm512_movepi32_mask((__m512i)a) != 0; }
#elif APC_LANES == 8
inline bool any_negative(Vec a) { return _mm256_movemask_ps((__m256)a) != 0; }
#else
inline bool any_negative(Vec a) { return _mm_movemask_ps((__m128)a) != 0; }
#endif
inline double sum(Vec a) {
  double total = 0.0;
  for (int l = 0; l < width; ++l) total += a[l];
  return total;
}

constexpr float grad = 2.08890857f;  // 105/(16 π)
constexpr float tiny = 1e-16f;       // keeps r of a particle with itself finite; its terms vanish with the distance

#include "sph_backend/foam_kernels.inl"

void strain(const PairWork& w, int first_cluster, int last_cluster) {
  for (int c = first_cluster; c < last_cluster; ++c) {
    double internal = 0.0, damped = 0.0;
    for (int base = c * lanes; base < (c + 1) * lanes; base += width) {
      const float* rec = w.records;
      const Vec x = column(rec, base, record::x), y = column(rec, base, record::y), z = column(rec, base, record::z);
      const Vec half_g = 0.5f * column(rec, base, record::inverse_h);
      const Vec vx = column(rec, base, record::vx), vy = column(rec, base, record::vy),
                vz = column(rec, base, record::vz);
      Gradient s{};
      for (std::uint32_t k = w.first[c]; k < w.first[c + 1]; ++k) {
        const float* q = rec + static_cast<std::size_t>(w.neighbour[k]) * record::size;
        const Vec dx = x - q[record::x], dy = y - q[record::y], dz = z - q[record::z];
        const Vec r2 = dx * dx + dy * dy + dz * dz + tiny;
        const Vec r = r2 * rsqrt(r2);
        const Vec g = half_g + 0.5f * q[record::inverse_h];
        const Vec t = vmax(1.0f - 0.5f * r * g, Vec{});
        const Vec g2 = g * g;
        const Vec weight = t * t * t * (g2 * g2 * g);
        const Vec ax = weight * (vx - q[record::vx]), ay = weight * (vy - q[record::vy]),
                  az = weight * (vz - q[record::vz]);
        s.xx += ax * dx, s.xy += ax * dy, s.xz += ax * dz;
        s.yx += ay * dx, s.yy += ay * dy, s.yz += ay * dz;
        s.zx += az * dx, s.zy += az * dy, s.zz += az * dz;
      }
      update_stress(w, base, s, internal, damped);
    }
    w.internal[c] = internal, w.damped[c] = damped;
  }
}

void accelerate(const PairWork& w, int first_cluster, int last_cluster) {
  for (int c = first_cluster; c < last_cluster; ++c) {
    double viscous = 0.0;
    for (int base = c * lanes; base < (c + 1) * lanes; base += width) {
      const float* rec = w.records;
      const Vec x = column(rec, base, record::x), y = column(rec, base, record::y), z = column(rec, base, record::z);
      const Vec half_g = 0.5f * column(rec, base, record::inverse_h);
      const Vec vx = column(rec, base, record::vx), vy = column(rec, base, record::vy),
                vz = column(rec, base, record::vz);
      const Vec sxx = column(rec, base, record::sxx), syy = column(rec, base, record::syy),
                szz = column(rec, base, record::szz), sxy = column(rec, base, record::sxy),
                sxz = column(rec, base, record::sxz), syz = column(rec, base, record::syz);
      const Vec va = column(rec, base, record::visc_a), vb = column(rec, base, record::visc_b);
      Vec fx{}, fy{}, fz{}, heat{};
      for (std::uint32_t k = w.first[c]; k < w.first[c + 1]; ++k) {
        const float* q = rec + static_cast<std::size_t>(w.neighbour[k]) * record::size;
        const Vec dx = x - q[record::x], dy = y - q[record::y], dz = z - q[record::z];
        const Vec r2 = dx * dx + dy * dy + dz * dz + tiny;
        const Vec r = r2 * rsqrt(r2);
        const Vec g = half_g + 0.5f * q[record::inverse_h];
        const Vec q_r = r * g;
        const Vec t = vmax(1.0f - 0.5f * q_r, Vec{});
        const Vec g2 = g * g;
        const Vec weight = t * t * t * (g2 * g2 * g);
        const Vec vr = dx * (vx - q[record::vx]) + dy * (vy - q[record::vy]) + dz * (vz - q[record::vz]);
        const Vec approach = vmin(vr, Vec{});
        const Vec mu = approach * g * rcp0(q_r * q_r + 0.01f);
        const Vec pi = mu * ((vb + q[record::visc_b]) * mu - (va + q[record::visc_a]));
        const Vec push = weight * pi;
        heat -= push * approach;
        const Vec txx = sxx + q[record::sxx], tyy = syy + q[record::syy], tzz = szz + q[record::szz];
        const Vec txy = sxy + q[record::sxy], txz = sxz + q[record::sxz], tyz = syz + q[record::syz];
        fx += push * dx - weight * (txx * dx + txy * dy + txz * dz);
        fy += push * dy - weight * (txy * dx + tyy * dy + tyz * dz);
        fz += push * dz - weight * (txz * dx + tyz * dy + tzz * dz);
      }
      store(w.acceleration[0] + base, grad * fx);
      store(w.acceleration[1] + base, grad * fy);
      store(w.acceleration[2] + base, grad * fz);
      viscous += sum((0.5f * grad * w.mass * w.dt) * heat);
    }
    w.viscous[c] = viscous;
  }
}

double multiply_add(long rounds) {
  Vec chain[8];
  for (int k = 0; k < 8; ++k) chain[k] = splat(1.0f + 0.1f * static_cast<float>(k));
  const Vec factor = splat(0.999f), term = splat(0.001f);
  for (long r = 0; r < rounds; ++r) {
#pragma GCC unroll 8
    for (int k = 0; k < 8; ++k) chain[k] = chain[k] * factor + term;
  }
  volatile float keep = 0.0f;
  for (int k = 0; k < 8; ++k) keep = keep + chain[k][0];
  return 2.0 * 8.0 * width * static_cast<double>(rounds);
}

// Branch-free: the reach of a pair is its kernel support, a little more because h may grow, and what both may travel.
int filter(const FilterWork& w, int cluster, const std::uint32_t* candidates, int count, std::uint32_t* kept) {
  int n = 0;
  Vec x[lanes / width], y[lanes / width], z[lanes / width], half_g[lanes / width], reach[lanes / width];
  for (int s = 0; s < lanes / width; ++s) {
    const int base = cluster * lanes + s * width;
    x[s] = column(w.records, base, record::x), y[s] = column(w.records, base, record::y);
    z[s] = column(w.records, base, record::z), half_g[s] = 0.5f * column(w.records, base, record::inverse_h);
    reach[s] = load(w.reach + base);
  }
  for (int k = 0; k < count; ++k) {
    const float* q = w.records + static_cast<std::size_t>(candidates[k]) * record::size;
    const float travel = w.reach[candidates[k]];
    Vec nearest = splat(1.0f);
    for (int s = 0; s < lanes / width; ++s) {
      const Vec dx = x[s] - q[record::x], dy = y[s] - q[record::y], dz = z[s] - q[record::z];
      const Vec limit = 2.04f * rcp0(half_g[s] + 0.5f * q[record::inverse_h]) + reach[s] + travel;
      nearest = vmin(nearest, dx * dx + dy * dy + dz * dz - limit * limit);
    }
    kept[n] = candidates[k];
    n += any_negative(nearest);
  }
  return n;
}

}  // namespace
}  // namespace apc::sph
