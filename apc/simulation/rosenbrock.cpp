#include "apc/simulation/rosenbrock.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::simulation {
namespace {

double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }

}  // namespace

Rosenbrock::Rosenbrock(const Plant& plant, const Surroundings& around, double rtol, double longest_way)
    : plant_(plant), around_(around), rtol_(rtol), longest_way_(longest_way) {
  work_.degrees = plant.degrees();
  work_.spins = static_cast<int>(plant.rows.size());
  work_.states = plant.states();
  const int n = work_.degrees, beams = 3 + static_cast<int>(plant.groups.size());
  for (int i = 0; i < work_.states; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool rate = i >= n, spin = i >= 2 * n;
    const int kind = rate ? i - n : i;
    const bool angle = kind == 2 || kind >= beams;
    // Strokes and beams rattle on their friction and on the ruts; what they miss in one step hardly reaches the stop.
    const bool stroke = kind >= 3 && !angle, beam = kind >= beams;
    work_.weight[k] = spin        ? 100.0
                      : kind == 0 ? (rate ? 1.0 : 3.0)
                      : beam      ? (rate ? 30.0 : 3.0)
                      : angle     ? (rate ? 0.3 : 0.05)
                      : stroke    ? (rate ? 10.0 : 0.1)
                                  : (rate ? 1.0 : 0.1);
    work_.weight_by_size[k] = spin || (rate && kind == 0) ? 1.0 : 0.0;
  }
  statistics_.method = "RODAS4";
  statistics_.rtol = rtol;
}

void Rosenbrock::start(double t, const std::vector<double>& y) {
  std::copy(y.begin(), y.end(), work_.y.begin());
  time_ = previous_ = t;
  h_ = 2e-3;
  last_h_ = 0.0;
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

bool Rosenbrock::attempt(double h, double& error) {
  const auto& kernel = step_kernel(work_);
  if (!kernel.eliminate(work_, h)) return false;
  for (int stage = 0; stage < 6; ++stage) {
    if (stage > 0) {
      kernel.place(work_, stage);
      derivatives(plant_, around_, time_ + stage_time[stage] * h, (stage < 4 ? work_.at : work_.next).data(),
                  work_.f.data());
      ++statistics_.rhs_calls;
    }
    kernel.solve(work_, stage, h, plant_.timed_thrust ? h * stage_time_share[stage] : 0.0);
  }
  error = kernel.norm(work_) / rtol_;
  return std::isfinite(error);
}

double Rosenbrock::step() {
  moment();
  const auto states = static_cast<std::size_t>(work_.states);
  if (plant_.timed_thrust) {
    const double dt = 1e-5;
    derivatives(plant_, around_, time_ + dt, work_.y.data(), work_.f.data());
    for (std::size_t i = 0; i < states; ++i) work_.dfdt[i] = (work_.f[i] - work_.f0[i]) / dt;
  }
  bool rejected = false;
  h_ = std::min(h_, longest_way_ / std::max(1.0, std::abs(work_.y[static_cast<std::size_t>(work_.degrees)])));
  for (;;) {
    double error = 0.0;
    const double h = h_;
    const bool finite = attempt(h, error);
    if (finite && error <= 1.0) {
      double factor = fourth_root(std::max(error, 1e-8)) / 0.9;
      if (last_h_ > 0.0)  // predictive controller of Gustafsson
        factor = std::max(factor,
                          last_h_ / h * fourth_root(std::max(error, 1e-8) * std::max(error, 1e-8) / last_error_) / 0.9);
      factor = std::clamp(factor, 1.0 / 6.0, 5.0);
      if (rejected) factor = std::max(1.0, factor);
      last_h_ = h;
      last_error_ = std::max(1e-2, error);
      dense_[0] = work_.y;
      dense_[1] = work_.y = work_.next;
      step_kernel(work_).dense(work_, dense_[2].data(), dense_[3].data());
      previous_ = time_;
      time_ += h;
      h_ = h / factor;
      linearised_ = false;
      ++statistics_.steps;
      return time_;
    }
    rejected = true;
    ++statistics_.error_test_failures;
    h_ = finite ? h / std::clamp(fourth_root(error) / 0.9, 1.2, 5.0) : 0.2 * h;
    if (h_ < 1e-9)
      throw SolveError(concat("RODAS4 gave up at t = ", time_, " s (step size below 1e-9 s), speed ",
                              work_.y[static_cast<std::size_t>(work_.degrees)], " m/s, pitch ", work_.y[2],
                              " rad, nose stroke ", work_.y[3], " m. Try the reference method, or a looser tolerance"),
                       time_);
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
