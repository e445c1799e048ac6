/// A run at a parameter p beside its neighbours at p ± ε: model, plant and ruts of each, and derivatives of whatever
/// depends on plant and state, by a central difference along the carried sensitivity of the state.
#pragma once

#include <vector>

#include "apc/simulation/equations.h"
#include "apc/simulation/sensitivity.h"

namespace apc::simulation {

/// The run at one value of the parameter, with ruts of its own.
struct Variant {
  Variant(const Model&, const Overrun&, const ScalarParameter&, double amount);
  Variant(const Variant&) = delete;
  Variant& operator=(const Variant&) = delete;

  Model model;
  Overrun overrun;
  Plant plant;
  Surroundings around;
  std::vector<double> start;
};

struct Neighbours {
  Neighbours(const Model&, const Overrun&, const ScalarParameter&);

  const double epsilon;
  Variant base, up, down;

  std::vector<double> start_slope() const { return difference(up.start, down.start); }
  /// d/dp of a vector f(variant, state) where the state moves with `s`.
  template <class F>
  std::vector<double> totals(const std::vector<double>& y, const std::vector<double>& s, const F& f) {
    above_ = below_ = y;
    for (std::size_t i = 0; i < s.size(); ++i) above_[i] += epsilon * s[i], below_[i] -= epsilon * s[i];
    return difference(f(up, above_.data()), f(down, below_.data()));
  }
  /// The same of a number.
  template <class F>
  double total(const std::vector<double>& y, const std::vector<double>& s, const F& f) {
    return totals(y, s, [&](Variant& v, const double* at) { return std::vector<double>{f(v, at)}; }).front();
  }
  /// d/dp of what the variants hold, whatever the state.
  template <class F>
  double held(const F& f) const {
    return (f(up) - f(down)) / (2.0 * epsilon);
  }

 private:
  std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) const {
    std::vector<double> slope(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) slope[i] = (a[i] - b[i]) / (2.0 * epsilon);
    return slope;
  }
  std::vector<double> above_, below_;
};

}  // namespace apc::simulation
