#include "apc/simulation/rosenbrock.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/simulation/overrun_run.h"

namespace apc::simulation {
namespace {

double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }

}  // namespace

ErrorWeights error_weights(int groups, int bogies, int rows) {
  ErrorWeights weights;
  const int n = 3 + groups + bogies, beams = 3 + groups;
  for (int i = 0; i < 2 * n + rows; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool rate = i >= n, spin = i >= 2 * n;
    const int kind = rate ? i - n : i;
    const bool angle = kind == 2 || kind >= beams;
    // Strokes and beams rattle on their friction and on the ruts; what they miss in one step hardly reaches the stop.
    const bool stroke = kind >= 3 && !angle, beam = kind >= beams;
    weights.constant[k] = spin        ? 100.0
                          : kind == 0 ? (rate ? 1.0 : 3.0)
                          : beam      ? (rate ? 30.0 : 3.0)
                          : angle     ? (rate ? 0.3 : 0.05)
                          : stroke    ? (rate ? 10.0 : 0.1)
                                      : (rate ? 1.0 : 0.1);
    weights.by_size[k] = spin || (rate && kind == 0) ? 1.0 : 0.0;
  }
  return weights;
}

void StepControl::start() {
  h_ = 2e-3;
  last_h_ = 0.0;
  rejected_ = false;
}

double StepControl::step(double speed, double at_most) {
  constexpr double middle = 20.0, slowest = 0.5 * middle;  // m/s
  const double ease = middle / std::max(slowest, std::abs(speed));
  tolerance_ = rtol_ * (ease * ease);
  h_ = std::min(h_, longest_way_ / std::max(1.0, std::abs(speed)));
  planned_ = at_most < h_ ? h_ : 0.0;
  return h_ = std::min(h_, at_most);
}

bool StepControl::accepts(double size, double time, const double* y, const Plant& plant) {
  const double h = h_, error = size / tolerance_;
  const bool finite = std::isfinite(error);
  if (finite && error <= 1.0 && planned_ > 0.0) {  // a step cut short says little about the next one
    rejected_ = false;
    h_ = std::min(planned_, 0.9 * h / fourth_root(std::max(error, 1e-8)));
    return true;
  }
  if (finite && error <= 1.0) {
    double factor = fourth_root(std::max(error, 1e-8)) / 0.9;
    if (last_h_ > 0.0)
      factor = std::max(factor,
                        last_h_ / h * fourth_root(std::max(error, 1e-8) * std::max(error, 1e-8) / last_error_) / 0.9);
    factor = std::clamp(factor, 1.0 / 6.0, 5.0);
    if (rejected_) factor = std::max(1.0, factor);
    last_h_ = h;
    last_error_ = std::max(1e-2, error);
    rejected_ = false;
    h_ = h / factor;
    return true;
  }
  rejected_ = true;
  h_ = finite ? h / std::clamp(fourth_root(error) / 0.9, 1.2, 5.0) : 0.2 * h;
  if (h_ < 1e-9)
    throw SolveError(concat("RODAS4 gave up at t = ", time, " s (step size below 1e-9 s): ", in_words(plant, y),
                            ". Try the reference method, or a looser tolerance"),
                     time);
  return false;
}

Rosenbrock::Rosenbrock(const Plant& plant, const Surroundings& around, double rtol, double longest_way)
    : plant_(plant), around_(around), control_(rtol, longest_way) {
  work_.degrees = plant.degrees();
  work_.spins = static_cast<int>(plant.rows.size());
  work_.states = plant.states();
  const auto weights = error_weights(static_cast<int>(plant.groups.size()), plant.bogies, work_.spins);
  work_.weight = weights.constant;
  work_.weight_by_size = weights.by_size;
  statistics_.method = "RODAS4";
  statistics_.rtol = rtol;
}

void Rosenbrock::start(double t, const std::vector<double>& y) {
  std::copy(y.begin(), y.end(), work_.y.begin());
  time_ = previous_ = t;
  control_.start();
  linearised_ = false;
}

const Moment& Rosenbrock::moment() {
  if (!linearised_) {
    jacobian(plant_, around_, time_, work_.y.data(), work_.f0.data(), work_.jacobian.data(), &moment_);
    ++statistics_.jacobians;
    ++statistics_.rhs_calls;
    linearised_ = true;
  }
  return moment_;
}

const Moment* Rosenbrock::known(double t, double* y) {
  state(t, y);
  return t == time_ ? &moment() : nullptr;
}

double Rosenbrock::attempt(double h) {
  const auto& kernel = step_kernel(work_);
  if (!kernel.eliminate(work_, h)) return NAN;
  for (int stage = 0; stage < 6; ++stage) {
    if (stage > 0) {
      kernel.place(work_, stage);
      derivatives(plant_, around_, time_ + stage_time[stage] * h, (stage < 4 ? work_.at : work_.next).data(),
                  work_.f.data());
      ++statistics_.rhs_calls;
    }
    kernel.solve(work_, stage, h, plant_.timed_thrust ? h * stage_time_share[stage] : 0.0);
  }
  return kernel.norm(work_);
}

double Rosenbrock::step() {
  moment();
  const auto states = static_cast<std::size_t>(work_.states);
  if (plant_.timed_thrust) {
    const double dt = 1e-5;
    derivatives(plant_, around_, time_ + dt, work_.y.data(), work_.f.data());
    for (std::size_t i = 0; i < states; ++i) work_.dfdt[i] = (work_.f[i] - work_.f0[i]) / dt;
  }
  for (;;) {
    const double h = control_.step(work_.y[static_cast<std::size_t>(work_.degrees)], time_to_corner(plant_, moment_));
    if (control_.accepts(attempt(h), time_, work_.y.data(), plant_)) {
      dense_[0] = work_.y;
      dense_[1] = work_.y = work_.next;
      step_kernel(work_).dense(work_, dense_[2].data(), dense_[3].data());
      previous_ = time_;
      time_ += h;
      linearised_ = false;
      ++statistics_.steps;
      return time_;
    }
    ++statistics_.error_test_failures;
  }
}

void Rosenbrock::state(double t, double* y) const {
  if (t == time_) {
    std::copy(work_.y.begin(), work_.y.begin() + work_.states, y);
    return;
  }
  const double theta = (t - previous_) / (time_ - previous_), other = 1.0 - theta;
  for (int i = 0; i < work_.states; ++i) {
    const auto k = static_cast<std::size_t>(i);
    y[i] = dense_[0][k] * other + theta * (dense_[1][k] + other * (dense_[2][k] + theta * dense_[3][k]));
  }
}

}  // namespace apc::simulation
