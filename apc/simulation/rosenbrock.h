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
#include "apc/simulation/rosenbrock_step.h"

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
  /// The instant at time(), known from the next step's Jacobian.
  const Moment& moment();
  SolverStatistics statistics() const { return statistics_; }

 private:
  bool attempt(double h, double& error);

  const Plant& plant_;
  const Surroundings& around_;
  double rtol_, longest_way_, h_ = 1e-3, last_h_ = 0.0, last_error_ = 1.0;
  double time_ = 0.0, previous_ = 0.0;
  bool linearised_ = false;  ///< Jacobian, rate and moment belong to the present state
  StepWork work_;
  std::array<StateVector, 4> dense_{};
  Moment moment_;
  SolverStatistics statistics_;
};

}  // namespace apc::simulation
