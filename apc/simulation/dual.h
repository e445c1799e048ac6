/// Forward-mode differentiation: a number that carries its derivatives by N independent variables through every
/// operation. Exact to rounding; used for Jacobians (N = number of states) and sensitivities (N = 1).
#pragma once

#include <cmath>

#include "apc/simulation/elementary.h"

namespace apc::simulation {

template <int N>
struct Dual {
  double value;
  double d[N];

  Dual() = default;
  Dual(double constant) : value(constant), d{} {}  // NOLINT: constants mix freely with duals
  /// The variable with number `lane`.
  static Dual variable(double at, int lane) {
    Dual x(at);
    x.d[lane] = 1.0;
    return x;
  }
};

/// A number without derivatives that calls the same functions.
template <>
struct Dual<0> {
  double value;
  static inline double d[1];  ///< never touched

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT
};

/// f(x) with f′(x) known: the chain rule.
template <int N>
inline Dual<N> chain(double value, double slope, const Dual<N>& x) {
  Dual<N> y;
  y.value = value;
  for (int i = 0; i < N; ++i) y.d[i] = slope * x.d[i];
  return y;
}
inline double chain(double value, double, double) { return value; }

inline double value_of(double x) { return x; }
template <int N>
inline double value_of(const Dual<N>& x) {
  return x.value;
}

template <int N>
inline Dual<N>& operator+=(Dual<N>& a, const Dual<N>& b) {
  a.value += b.value;
  for (int i = 0; i < N; ++i) a.d[i] += b.d[i];
  return a;
}
template <int N>
inline Dual<N>& operator-=(Dual<N>& a, const Dual<N>& b) {
  a.value -= b.value;
  for (int i = 0; i < N; ++i) a.d[i] -= b.d[i];
  return a;
}
template <int N>
inline Dual<N> operator+(Dual<N> a, const Dual<N>& b) {
  a += b;
  return a;
}
template <int N>
inline Dual<N> operator-(Dual<N> a, const Dual<N>& b) {
  a -= b;
  return a;
}
template <int N>
inline Dual<N> operator+(Dual<N> a, double b) {
  a.value += b;
  return a;
}
template <int N>
inline Dual<N> operator+(double b, Dual<N> a) {
  a.value += b;
  return a;
}
template <int N>
inline Dual<N> operator-(Dual<N> a, double b) {
  a.value -= b;
  return a;
}
template <int N>
inline Dual<N> operator-(double b, const Dual<N>& a) {
  return chain(b - a.value, -1.0, a);
}
template <int N>
inline Dual<N> operator-(const Dual<N>& a) {
  return chain(-a.value, -1.0, a);
}
template <int N>
inline Dual<N> operator*(const Dual<N>& a, const Dual<N>& b) {
  Dual<N> c;
  c.value = a.value * b.value;
  for (int i = 0; i < N; ++i) c.d[i] = a.value * b.d[i] + b.value * a.d[i];
  return c;
}
template <int N>
inline Dual<N> operator*(double b, const Dual<N>& a) {
  return chain(b * a.value, b, a);
}
template <int N>
inline Dual<N> operator*(const Dual<N>& a, double b) {
  return chain(b * a.value, b, a);
}
template <int N>
inline Dual<N> operator/(const Dual<N>& a, const Dual<N>& b) {
  Dual<N> c;
  const double inverse = 1.0 / b.value;
  c.value = a.value * inverse;
  for (int i = 0; i < N; ++i) c.d[i] = inverse * (a.d[i] - c.value * b.d[i]);
  return c;
}
template <int N>
inline Dual<N> operator/(double a, const Dual<N>& b) {
  const double value = a / b.value;
  return chain(value, -value / b.value, b);
}
template <int N>
inline Dual<N> operator/(const Dual<N>& a, double b) {
  return a * (1.0 / b);
}

template <int N>
inline bool operator<(const Dual<N>& a, double b) {
  return a.value < b;
}
template <int N>
inline bool operator>(const Dual<N>& a, double b) {
  return a.value > b;
}

template <int N>
inline Dual<N> sin(const Dual<N>& x) {
  const auto at = elementary::sine_cosine(x.value);
  return chain(at.sine, at.cosine, x);
}
template <int N>
inline Dual<N> cos(const Dual<N>& x) {
  const auto at = elementary::sine_cosine(x.value);
  return chain(at.cosine, -at.sine, x);
}
/// tanh; where its series needs four terms, the series.
inline double quick_tanh(double x) {
  const double s = x * x;
  if (s < 4e-4) return x * (1.0 - s * (1.0 / 3.0 - s * (2.0 / 15.0 - s * (17.0 / 315.0))));
  return elementary::hyperbolic_tangent(x);
}
template <int N>
inline Dual<N> quick_tanh(const Dual<N>& x) {
  const double y = quick_tanh(x.value);
  return chain(y, 1.0 - y * y, x);
}
template <int N>
inline Dual<N> tanh(const Dual<N>& x) {
  return quick_tanh(x);
}
template <int N>
inline Dual<N> sqrt(const Dual<N>& x) {
  const double y = std::sqrt(x.value);
  return N == 0 ? Dual<N>(y) : chain(y, 0.5 / y, x);
}
template <int N>
inline Dual<N> abs(const Dual<N>& x) {
  return x.value < 0.0 ? -x : x;
}
template <int N>
inline Dual<N> pow(const Dual<N>& x, double exponent) {
  const double y = elementary::power(x.value, exponent);
  return chain(y, exponent * y / x.value, x);
}

}  // namespace apc::simulation
