/// Elementary functions in plain arithmetic (no fused products, no library calls), so that a run has the same bits on
/// every processor; each within 3 ulp. Rational forms after S. L. Moshier, Methods and Programs for Mathematical
/// Functions (1989), the Cephes library.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace apc::simulation::elementary {

struct SineCosine {
  double sine, cosine;
};

/// |x| ≤ π/4 by polynomials (pitch and beam angles never leave it in a run that means something), the library beyond.
inline SineCosine sine_cosine(double x) {
  if (!(x > -0.785 && x < 0.785)) [[unlikely]]
    return {std::sin(x), std::cos(x)};
  const double z = x * x;
  const double s =
      ((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) * z -
        1.98412698295895385996e-4) *
           z +
       8.33333333332211858878e-3) *
          z -
      1.66666666666666307295e-1;
  const double c =
      ((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) * z +
        2.48015872888517045348e-5) *
           z -
       1.38888888888730564116e-3) *
          z +
      4.16666666666665929218e-2;
  return {x + x * z * s, (1.0 - 0.5 * z) + z * z * c};
}

/// −700 < x < 700.
inline double exponential(double x) {
  const double n = std::floor(1.4426950408889634074 * x + 0.5);
  x -= n * 6.93145751953125e-1;
  x -= n * 1.42860682030941723212e-6;
  const double z = x * x;
  const double p = x * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 1.0);
  const double q =
      ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z + 2.27265548208155028766e-1) * z + 2.0;
  const std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(n) + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return (1.0 + 2.0 * (p / (q - p))) * power;
}

/// x > 0, normal. 2 artanh((m − 1)/(m + 1)) with m the mantissa within √½ … √2.
inline double logarithm(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  auto exponent = static_cast<std::int64_t>(bits >> 52) - 1023;
  bits = (bits & 0x000fffffffffffffu) | 0x3ff0000000000000u;
  double m;
  std::memcpy(&m, &bits, sizeof m);
  if (m > 1.41421356237309505) m *= 0.5, ++exponent;
  const double s = (m - 1.0) / (m + 1.0), z = s * s;
  double sum = 1.0 / 21.0;
  for (int k = 19; k >= 3; k -= 2) sum = sum * z + 1.0 / k;
  const double n = static_cast<double>(exponent);
  return n * 6.93145751953125e-1 + ((2.0 * s + 2.0 * s * z * sum) + n * 1.42860682030941723212e-6);
}

/// x > 0; NaN otherwise, as where the gas law has no value.
inline double power(double x, double exponent) {
  if (!(x > 1e-300)) [[unlikely]]
    return NAN;
  return exponential(exponent * logarithm(x));
}

inline double hyperbolic_tangent(double x) {
  const double size = std::abs(x);
  if (size > 20.0) return x < 0.0 ? -1.0 : 1.0;
  if (size > 0.625) {
    const double t = 1.0 - 2.0 / (exponential(2.0 * size) + 1.0);
    return x < 0.0 ? -t : t;
  }
  const double z = x * x;
  const double p = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3;
  const double q = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z + 4.84406305325125486048e3;
  return x + x * z * (p / q);
}

}  // namespace apc::simulation::elementary
