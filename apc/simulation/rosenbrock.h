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

/// What one unit of relative tolerance means for every state: constant + slope × |y|.
struct ErrorWeights {
  StateVector constant{}, by_size{};
};
ErrorWeights error_weights(int groups, int bogies, int rows);

/// Step sizes: Gustafsson's predictive controller. An error made fast has farther to roll, and where bogies bounce in
/// their ruts more time to grow: the tolerance is `rtol` at 20 m/s and falls with the square of the speed (four times
/// as much is allowed where the stop is near).
class StepControl {
 public:
  StepControl(double rtol, double longest_way) : rtol_(rtol), tolerance_(rtol), longest_way_(longest_way) {}
  void start();
  /// The next step to try at this forward speed, ending no later than after `at_most` s.
  double step(double speed, double at_most);
  /// Judges an attempt by its error in units of the weights (anything but a number: nothing came out of it). False:
  /// refused, step() is smaller. SolveError when it collapses.
  bool accepts(double size, double time, const double* y, const Plant&);

 private:
  double rtol_, tolerance_, longest_way_, h_ = 1e-3, last_h_ = 0.0, last_error_ = 1.0;
  double planned_ = 0.0;  ///< what a step cut short would have been; 0 = not cut
  bool rejected_ = false;
};

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
  /// State and moment at `t` where they are at hand, else null.
  const Moment* known(double t, double* y);
  SolverStatistics statistics() const { return statistics_; }

 private:
  double attempt(double h);

  const Plant& plant_;
  const Surroundings& around_;
  StepControl control_;
  double time_ = 0.0, previous_ = 0.0;
  bool linearised_ = false;  ///< Jacobian, rate and moment belong to the present state
  StepWork work_;
  std::array<StateVector, 4> dense_{};
  Moment moment_;
  SolverStatistics statistics_;
};

}  // namespace apc::simulation
