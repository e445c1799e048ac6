/// Forward-mode differentiation: a number that carries its derivatives by N independent variables through every
/// operation. Exact to rounding; used for Jacobians (N = number of states) and sensitivities (N = 1). `V` is a double
/// or several side by side (lanes.h).
#pragma once

#include <cmath>
#include <type_traits>

#include "apc/base/select.h"
#include "apc/simulation/elementary.h"

namespace apc::simulation {

using apc::all;
using apc::any;
using apc::select;

template <int N, class V = double>
struct Dual {
  V value;
  V d[N];

  Dual() = default;
  template <class Constant>
  requires std::is_convertible_v<Constant, V> Dual(const Constant& constant)
      : value(constant) {  // NOLINT: constants mix freely with duals
    for (auto& each : d) each = V(0.0);
  }
  /// The variable with number `lane`.
  static Dual variable(const V& at, int lane) {
    Dual x(at);
    x.d[lane] = V(1.0);
    return x;
  }
};

/// A number without derivatives that calls the same functions.
template <class V>
struct Dual<0, V> {
  V value;
  /// Stands for derivatives in loops that never run.
  [[no_unique_address]] struct {
    V& operator[](int) const { __builtin_unreachable(); }
  } d;

  Dual() = default;
  template <class Constant>
  requires std::is_convertible_v<Constant, V> Dual(const Constant& constant) : value(constant) {}  // NOLINT
};

template <class V>
using Same = std::type_identity_t<V>;

/// f(x) with f′(x) known: the chain rule.
template <int N, class V>
inline Dual<N, V> chain(const Same<V>& value, const Same<V>& slope, const Dual<N, V>& x) {
  Dual<N, V> y;
  y.value = value;
  for (int i = 0; i < N; ++i) y.d[i] = slope * x.d[i];
  return y;
}
inline double chain(double value, double, double) { return value; }

inline double value_of(double x) { return x; }
template <int N, class V>
inline V value_of(const Dual<N, V>& x) {
  return x.value;
}

template <int N, class V>
inline Dual<N, V>& operator+=(Dual<N, V>& a, const Dual<N, V>& b) {
  a.value += b.value;
  for (int i = 0; i < N; ++i) a.d[i] += b.d[i];
  return a;
}
template <int N, class V>
inline Dual<N, V>& operator-=(Dual<N, V>& a, const Dual<N, V>& b) {
  a.value -= b.value;
  for (int i = 0; i < N; ++i) a.d[i] -= b.d[i];
  return a;
}
template <int N, class V>
inline Dual<N, V> operator+(Dual<N, V> a, const Dual<N, V>& b) {
  a += b;
  return a;
}
template <int N, class V>
inline Dual<N, V> operator-(Dual<N, V> a, const Dual<N, V>& b) {
  a -= b;
  return a;
}
template <int N, class V>
inline Dual<N, V> operator+(Dual<N, V> a, const Same<V>& b) {
  a.value += b;
  return a;
}
template <int N, class V>
inline Dual<N, V> operator+(const Same<V>& b, Dual<N, V> a) {
  a.value += b;
  return a;
}
template <int N, class V>
inline Dual<N, V> operator-(Dual<N, V> a, const Same<V>& b) {
  a.value -= b;
  return a;
}
template <int N, class V>
inline Dual<N, V> operator-(const Same<V>& b, const Dual<N, V>& a) {
  return chain(b - a.value, -1.0, a);
}
template <int N, class V>
inline Dual<N, V> operator-(const Dual<N, V>& a) {
  return chain(-a.value, -1.0, a);
}
template <int N, class V>
inline Dual<N, V> operator*(const Dual<N, V>& a, const Dual<N, V>& b) {
  Dual<N, V> c;
  c.value = a.value * b.value;
  for (int i = 0; i < N; ++i) c.d[i] = a.value * b.d[i] + b.value * a.d[i];
  return c;
}
template <int N, class V>
inline Dual<N, V> operator*(const Same<V>& b, const Dual<N, V>& a) {
  return chain(b * a.value, b, a);
}
template <int N, class V>
inline Dual<N, V> operator*(const Dual<N, V>& a, const Same<V>& b) {
  return chain(b * a.value, b, a);
}
template <int N, class V>
inline Dual<N, V> operator/(const Dual<N, V>& a, const Dual<N, V>& b) {
  Dual<N, V> c;
  const V inverse = 1.0 / b.value;
  c.value = a.value * inverse;
  for (int i = 0; i < N; ++i) c.d[i] = inverse * (a.d[i] - c.value * b.d[i]);
  return c;
}
template <int N, class V>
inline Dual<N, V> operator/(const Same<V>& a, const Dual<N, V>& b) {
  const V value = a / b.value;
  return chain(value, -value / b.value, b);
}
template <int N, class V>
inline Dual<N, V> operator/(const Dual<N, V>& a, const Same<V>& b) {
  return a * (1.0 / b);
}

template <int N, class V>
inline auto operator<(const Dual<N, V>& a, const Same<V>& b) {
  return a.value < b;
}
template <int N, class V>
inline auto operator>(const Dual<N, V>& a, const Same<V>& b) {
  return a.value > b;
}

using elementary::power;
using elementary::sine_cosine;

template <int N, class V>
inline Dual<N, V> sin(const Dual<N, V>& x) {
  const auto at = sine_cosine(x.value);
  return chain(at.sine, at.cosine, x);
}
template <int N, class V>
inline Dual<N, V> cos(const Dual<N, V>& x) {
  const auto at = sine_cosine(x.value);
  return chain(at.cosine, -at.sine, x);
}
/// tanh; where its series needs four terms, the series.
inline double quick_tanh(double x) {
  const double s = x * x;
  if (s < 4e-4) return elementary::tangent_series(x, s);
  return elementary::hyperbolic_tangent(x);
}
template <int N, class V>
inline Dual<N, V> quick_tanh(const Dual<N, V>& x) {
  const V y = quick_tanh(x.value);
  return chain(y, 1.0 - y * y, x);
}
template <int N, class V>
inline Dual<N, V> tanh(const Dual<N, V>& x) {
  return quick_tanh(x);
}
template <int N, class V>
inline Dual<N, V> sqrt(const Dual<N, V>& x) {
  using std::sqrt;
  const V y = sqrt(x.value);
  return N == 0 ? Dual<N, V>(y) : chain(y, 0.5 / y, x);
}
template <int N, class V>
inline Dual<N, V> abs(const Dual<N, V>& x) {
  return select(x.value < 0.0, -x, x);
}
template <int N, class V>
inline Dual<N, V> pow(const Dual<N, V>& x, const Same<V>& exponent) {
  const V y = power(x.value, exponent);
  return chain(y, exponent * y / x.value, x);
}

}  // namespace apc::simulation
