/// Elementary functions in plain arithmetic (no fused products, no library calls), so that a run has the same bits on
/// every processor and beside any other run; each within 3 ulp. Rational forms after S. L. Moshier, Methods and
/// Programs for Mathematical Functions (1989), the Cephes library. `T` is a double or several side by side (lanes.h),
/// which bring their own choices between the forms.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "apc/base/select.h"

namespace apc::simulation::elementary {

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// |x| ≤ π/4.
template <class T>
inline SineCosine<T> small_sine_cosine(const T& x) {
  const T z = x * x;
  const T s = ((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) * z -
                1.98412698295895385996e-4) *
                   z +
               8.33333333332211858878e-3) *
                  z -
              1.66666666666666307295e-1;
  const T c = ((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) * z +
                2.48015872888517045348e-5) *
                   z -
               1.38888888888730564116e-3) *
                  z +
              4.16666666666665929218e-2;
  return {x + x * z * s, (1.0 - 0.5 * z) + z * z * c};
}
/// Polynomials where pitch and beam angles are in a run that means something, the library beyond.
inline SineCosine<double> sine_cosine(double x) {
  if (!(x > -0.785 && x < 0.785)) [[unlikely]]
    return {std::sin(x), std::cos(x)};
  return small_sine_cosine(x);
}

/// 2^n for whole |n| ≤ 1022.
inline double power_of_two(double n) {
  const std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(n) + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}
/// Mantissa in [1, 2) and exponent of a normal number > 0.
inline double mantissa_of(double x, double& exponent) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  exponent = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  bits = (bits & 0x000fffffffffffffu) | 0x3ff0000000000000u;
  double m;
  std::memcpy(&m, &bits, sizeof m);
  return m;
}

/// −700 < x < 700.
template <class T>
inline T exponential(const T& exponent) {
  using std::floor;
  const T n = floor(1.4426950408889634074 * exponent + 0.5);
  const T x = (exponent - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
  const T z = x * x;
  const T p = x * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 1.0);
  const T q = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z + 2.27265548208155028766e-1) * z + 2.0;
  return (1.0 + 2.0 * (p / (q - p))) * power_of_two(n);
}

/// x > 0, normal. 2 artanh((m − 1)/(m + 1)) with m the mantissa within √½ … √2.
template <class T>
inline T logarithm(const T& x) {
  T n;
  T m = mantissa_of(x, n);
  const auto high = m > 1.41421356237309505;
  m = select(high, m * 0.5, m);
  n = select(high, n + 1.0, n);
  const T s = (m - 1.0) / (m + 1.0), z = s * s;
  T sum = 1.0 / 21.0;
  for (int k = 19; k >= 3; k -= 2) sum = sum * z + 1.0 / k;
  return n * 6.93145751953125e-1 + ((2.0 * s + 2.0 * s * z * sum) + n * 1.42860682030941723212e-6);
}

/// x > 0; NaN otherwise, as where the gas law has no value.
inline double power(double x, double exponent) {
  if (!(x > 1e-300)) [[unlikely]]
    return NAN;
  return exponential(exponent * logarithm(x));
}

/// tanh |x| for 0.625 < size = |x| ≤ 20, and tanh x for |x| ≤ 0.625.
template <class T>
inline T exponential_tangent(const T& size) {
  return 1.0 - 2.0 / (exponential(2.0 * size) + 1.0);
}
template <class T>
inline T rational_tangent(const T& x) {
  const T z = x * x;
  const T p = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3;
  const T q = ((z + 1.12811678491631932402e2) * z + 2.23548839060100448583e3) * z + 4.84406305325125486048e3;
  return x + x * z * (p / q);
}
/// tanh x for x² = s < 4e-4.
template <class T>
inline T tangent_series(const T& x, const T& s) {
  return x * (1.0 - s * (1.0 / 3.0 - s * (2.0 / 15.0 - s * (17.0 / 315.0))));
}

inline double hyperbolic_tangent(double x) {
  const double size = std::abs(x);
  if (size > 20.0) return x < 0.0 ? -1.0 : 1.0;
  if (size > 0.625) {
    const double t = exponential_tangent(size);
    return x < 0.0 ? -t : t;
  }
  return rational_tangent(x);
}

}  // namespace apc::simulation::elementary
