/// CVODES (SUNDIALS 6) behind one class: variable-order BDF, dense Newton with the caller's Jacobian, pure quadratures
/// outside the error control, forward sensitivities (staggered, inside it), dense output. One context per object, so
/// objects on different threads never meet. Exceptions of the callbacks are carried across the C code and rethrown.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apc/simulation/result.h"

namespace apc::simulation {

struct OdeProblem {
  int states = 0;
  std::function<void(double t, const double* y, double* dydt)> rate;
  std::function<void(double t, const double* y, double* matrix)> jacobian;  ///< row-major
  int quadratures = 0;
  std::function<void(double t, const double* y, double* integrand)> integrand;
  int parameters = 0;
  std::vector<double> parameter_scales;  ///< size of each parameter: a sensitivity's error is weighed as state / scale
  /// ds/dt = J s + ∂f/∂p of one parameter.
  std::function<void(double t, const double* y, int parameter, const double* s, double* dsdt)> sensitivity;
  std::function<std::string(const double* y)> describe;  ///< a state in words, for messages; optional
};

struct OdeTolerances {
  double relative = 1e-6;
  std::vector<double> absolute;  ///< per state
  double longest_step = 0.0;     ///< s; 0 = no bound
};

class Cvode {
 public:
  Cvode(OdeProblem, OdeTolerances);
  ~Cvode();
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;

  /// Starts (or restarts) here; quadratures continue from `integrals`, sensitivities (parameters × states) from `s`.
  void start(double t, const std::vector<double>& y, const std::vector<double>& integrals = {},
             const std::vector<double>& s = {});
  /// The next step ends at `t` at the latest; holds for that step alone. Infinite: no bound.
  void stop_at(double t);
  /// One step of the solver's own choice; returns the time reached. SolveError when it gives up.
  double step();
  double previous_time() const { return previous_; }
  double time() const { return time_; }
  /// Dense output anywhere in the last step.
  void state(double t, double* y) const;
  void integrals(double t, double* q) const;
  void sensitivities(double t, double* s) const;
  /// Counts since construction.
  SolverStatistics statistics() const;

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
  double previous_ = 0.0, time_ = 0.0;
};

}  // namespace apc::simulation
