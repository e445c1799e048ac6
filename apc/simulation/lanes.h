/// Several numbers side by side, one per run, in one vector of the processor; conditions side by side. For the sources
/// that are compiled once per instruction set (lanes_v2/_v3/_v4.cpp) only: `W` is the width of that set's vectors, so
/// that every function made from these types has a name of its own per instruction set.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "apc/simulation/dual.h"

namespace apc::simulation {

/// The vectors themselves (GCC gives a template's own width too late).
template <int W>
struct Vectors;
template <>
struct Vectors<2> {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef double Unaligned __attribute__((vector_size(16), aligned(8), may_alias));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
};
template <>
struct Vectors<4> {
  typedef double Numbers __attribute__((vector_size(32)));
  typedef double Unaligned __attribute__((vector_size(32), aligned(8), may_alias));
  typedef std::int64_t Bits __attribute__((vector_size(32)));
};
template <>
struct Vectors<8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef double Unaligned __attribute__((vector_size(64), aligned(8), may_alias));
  typedef std::int64_t Bits __attribute__((vector_size(64)));
};

template <int W>
struct Lanes;

template <int W>
struct Mask {
  using Vector = typename Vectors<W>::Bits;
  Vector m;

  friend Mask operator&(const Mask& a, const Mask& b) { return {a.m & b.m}; }
  friend Mask operator|(const Mask& a, const Mask& b) { return {a.m | b.m}; }
  friend Mask operator!(const Mask& a) { return {~a.m}; }
  bool operator[](int lane) const { return m[lane] != 0; }
  friend Lanes<W> select(const Mask& mask, const Lanes<W>& yes, const Lanes<W>& no) {
    return Lanes<W>(mask.m ? yes.v : no.v);
  }
};

inline __attribute__((always_inline)) unsigned bits(const Mask<2>& mask) {
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask.m)));
}
#ifdef __AVX2__
inline __attribute__((always_inline)) unsigned bits(const Mask<4>& mask) {
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask.m)));
}
#endif
#ifdef __AVX512DQ__
inline __attribute__((always_inline)) unsigned bits(const Mask<8>& mask) {
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask.m));
}
#endif
template <int W>
bool any(const Mask<W>& mask) {
  return bits(mask) != 0;
}
template <int W>
bool all(const Mask<W>& mask) {
  return bits(mask) == (1u << W) - 1u;
}

template <int W>
struct Lanes {
  using Vector = typename Vectors<W>::Numbers;
  using Unaligned = typename Vectors<W>::Unaligned;  ///< of any eight doubles in memory
  Vector v;

  Lanes() = default;
  Lanes(double same) : v(same - Vector{}) {}  // NOLINT: one number for all lanes
  explicit Lanes(Vector vector) : v(vector) {}
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v / b.v); }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.v); }
  Lanes& operator+=(const Lanes& b) { return v += b.v, *this; }
  Lanes& operator-=(const Lanes& b) { return v -= b.v, *this; }
  Lanes& operator*=(const Lanes& b) { return v *= b.v, *this; }
  friend Mask<W> operator<(const Lanes& a, const Lanes& b) { return {a.v < b.v}; }
  friend Mask<W> operator>(const Lanes& a, const Lanes& b) { return {a.v > b.v}; }
  friend Mask<W> operator<=(const Lanes& a, const Lanes& b) { return {a.v <= b.v}; }
  friend Mask<W> operator>=(const Lanes& a, const Lanes& b) { return {a.v >= b.v}; }
  friend Mask<W> operator==(const Lanes& a, const Lanes& b) { return {a.v == b.v}; }
  friend Mask<W> operator!=(const Lanes& a, const Lanes& b) { return {a.v != b.v}; }
  friend Lanes abs(const Lanes& a) {
    using Bits = typename Mask<W>::Vector;
    return Lanes(reinterpret_cast<Vector>(reinterpret_cast<Bits>(a.v) & 0x7fffffffffffffff));
  }
};

inline __attribute__((always_inline)) Lanes<2> sqrt(const Lanes<2>& x) { return Lanes<2>(_mm_sqrt_pd(x.v)); }
inline __attribute__((always_inline)) Lanes<2> floor(const Lanes<2>& x) { return Lanes<2>(_mm_floor_pd(x.v)); }
#ifdef __AVX2__
inline __attribute__((always_inline)) Lanes<4> sqrt(const Lanes<4>& x) { return Lanes<4>(_mm256_sqrt_pd(x.v)); }
inline __attribute__((always_inline)) Lanes<4> floor(const Lanes<4>& x) { return Lanes<4>(_mm256_floor_pd(x.v)); }
#endif
#ifdef __AVX512DQ__  // all lanes, but said so: GCC 12 calls the plain forms uninitialised (bug 105593)
inline __attribute__((always_inline)) Lanes<8> sqrt(const Lanes<8>& x) {
  return Lanes<8>(_mm512_mask_sqrt_pd(x.v, 0xff, x.v));
}
inline __attribute__((always_inline)) Lanes<8> floor(const Lanes<8>& x) {
  return Lanes<8>(_mm512_mask_roundscale_pd(x.v, 0xff, x.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
}
#endif

template <int W>
Lanes<W> value_of(const Lanes<W>& x) {
  return x;
}
template <int W>
Lanes<W> chain(const Lanes<W>& value, const Lanes<W>&, const Lanes<W>&) {
  return value;
}
template <int N, int W>
Dual<N, Lanes<W>> select(const Mask<W>& mask, const Dual<N, Lanes<W>>& yes, const Dual<N, Lanes<W>>& no) {
  Dual<N, Lanes<W>> result;
  result.value = select(mask, yes.value, no.value);
  for (int i = 0; i < N; ++i) result.d[i] = select(mask, yes.d[i], no.d[i]);
  return result;
}

/// 2^n for whole |n| ≤ 1022: adding 1.5 · 2⁵² puts n + 1023 into the last bits.
template <int W>
Lanes<W> power_of_two(const Lanes<W>& n) {
  using Bits = typename Mask<W>::Vector;
  const Lanes<W> shifted = n + (0x1.8p52 + 1023.0);
  return Lanes<W>(reinterpret_cast<typename Lanes<W>::Vector>(reinterpret_cast<Bits>(shifted.v) << 52));
}

/// Mantissa in [1, 2) and exponent.
template <int W>
Lanes<W> mantissa_of(const Lanes<W>& x, Lanes<W>& exponent) {
  using Bits = typename Mask<W>::Vector;
  using Numbers = typename Lanes<W>::Vector;
  const Bits whole = reinterpret_cast<Bits>(x.v);
  const Bits biased = (whole >> 52) | 0x4330000000000000;  // 2⁵² + the biased exponent
  exponent = Lanes<W>(reinterpret_cast<Numbers>(biased)) - (0x1p52 + 1023.0);
  return Lanes<W>(reinterpret_cast<Numbers>((whole & 0x000fffffffffffff) | 0x3ff0000000000000));
}

template <int W>
Lanes<W> hyperbolic_tangent(const Lanes<W>& x) {
  const Lanes<W> size = abs(x);
  Lanes<W> result = select(x < 0.0, Lanes<W>(-1.0), Lanes<W>(1.0));
  const auto middle = (size > 0.625) & !(size > 20.0);
  if (any(middle)) {
    const auto t = elementary::exponential_tangent(select(middle, size, Lanes<W>(1.0)));
    result = select(middle, select(x < 0.0, -t, t), result);
  }
  const auto small = !(size > 0.625);
  if (any(small)) result = select(small, elementary::rational_tangent(x), result);
  return result;
}

template <int W>
elementary::SineCosine<Lanes<W>> sine_cosine(const Lanes<W>& x) {
  auto result = elementary::small_sine_cosine(x);
  const auto far = !((x > -0.785) & (x < 0.785));
  if (any(far)) [[unlikely]]
    for (int lane = 0; lane < W; ++lane)
      if (far[lane]) result.sine.set(lane, __builtin_sin(x[lane])), result.cosine.set(lane, __builtin_cos(x[lane]));
  return result;
}

template <int W>
Lanes<W> power(const Lanes<W>& x, const Lanes<W>& exponent) {
  return select(x > 1e-300, elementary::exponential(exponent * elementary::logarithm(x)), Lanes<W>(__builtin_nan("")));
}

template <int W>
Lanes<W> quick_tanh(const Lanes<W>& x) {
  const Lanes<W> s = x * x;
  const auto tiny = s < 4e-4;
  Lanes<W> result = elementary::tangent_series(x, s);
  if (!all(tiny)) result = select(tiny, result, hyperbolic_tangent(x));
  return result;
}

}  // namespace apc::simulation
