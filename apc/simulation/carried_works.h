/// Works along a run and how they move with a parameter:  d/dp ∫ P dt = ∫ (dP/dp) dt, and at an instant t_c where P
/// jumps + (P⁻ − P⁺) dt_c/dp, and at the end + P dt_e/dp. Simpson over each step of the solver.
#pragma once

#include "apc/simulation/energy.h"
#include "apc/simulation/neighbours.h"

namespace apc::simulation {

class CarriedWorks {
 public:
  explicit CarriedWorks(Neighbours&);

  /// P of every sink, then per gear group the drag of one strut × the nose wheel's speed, and their slopes.
  struct Powers {
    std::vector<double> value, slope;
  };
  Powers at(double t, const std::vector<double>& y, const std::vector<double>& s);
  void add(double duration, const Powers& begin, const Powers& middle, const Powers& end);
  void jump(const Powers& before, const Powers& after, double later);

  double sink(std::size_t i) const { return sum_.slope[i]; }
  double drag_work(std::size_t group) const { return sum_.value[sinks + group]; }
  double drag_work_slope(std::size_t group) const { return sum_.slope[sinks + group]; }

 private:
  std::vector<double> powers_of(const Variant&, double t, const double* y);
  Neighbours& neighbours_;
  std::vector<double> rate_;
  Moment moment_;
  std::array<double, most_rows> depth_{};  ///< at p: says for p ± ε, too, whether a row works on bed or pavement
  bool depth_known_ = false;
  Powers sum_;
};

}  // namespace apc::simulation
