/// The fast path: RODAS4, a stiffly accurate Rosenbrock method of order 4 with an embedded order 3 and dense output of
/// order 3, written for these equations: second-order structure (x′ = v) halves the linear systems, wheel spins are
/// eliminated one by one, nothing is allocated while stepping.
///
/// Source: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), §IV.7, code RODAS.
#pragma once

#include <array>
#include <vector>

#include "apc/simulation/equations.h"
#include "apc/simulation/result.h"

namespace apc::simulation {

class Rosenbrock {
 public:
  /// Plant and surroundings must outlive this; the surroundings are read afresh at every call. No step goes further
  /// than `longest_way`, m.
  Rosenbrock(const Plant&, const Surroundings&, double rtol, double longest_way);

  void start(double t, const std::vector<double>& y);
  /// One accepted step; returns the time reached. SolveError when the step size collapses.
  double step();
  double previous_time() const { return previous_; }
  double time() const { return time_; }
  /// Dense output in the last step.
  void state(double t, double* y) const;
  SolverStatistics statistics() const { return statistics_; }

 private:
  using State = std::array<double, most_states>;
  bool attempt(double h, State& next, double& error);
  void factor(double h);
  void solve(const State& right, State& solution) const;
  double norm(const State& error, const State& next) const;

  const Plant& plant_;
  const Surroundings& around_;
  double rtol_, longest_way_, h_ = 1e-3, last_h_ = 0.0, last_error_ = 1.0;
  double time_ = 0.0, previous_ = 0.0;
  int states_, degrees_, spins_;
  State y_{}, scale_{}, f0_{}, dfdt_{};
  std::array<State, 6> u_{};
  State dense_[4]{};
  std::vector<double> jacobian_;
  // Factored system: E = 1/(hγ), reduced matrix M (degrees × degrees) with its pivots, and what eliminates the spins.
  double e_ = 0.0;
  std::array<double, most_degrees * most_degrees> m_{};
  std::array<int, most_degrees> pivot_{};
  std::array<double, most_rows * most_degrees> spin_by_rate_{}, rate_by_spin_{};
  std::array<double, most_rows> spin_inverse_{};
  SolverStatistics statistics_;
};

}  // namespace apc::simulation
