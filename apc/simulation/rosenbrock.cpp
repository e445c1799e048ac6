#include "apc/simulation/rosenbrock.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::simulation {
namespace {

constexpr double gamma = 0.25;
constexpr double a21 = 1.544, a31 = 0.9466785280815826, a32 = 0.2557011698983284, a41 = 3.314825187068521,
                 a42 = 2.896124015972201, a43 = 0.9986419139977817, a51 = 1.221224509226641, a52 = 6.019134481288629,
                 a53 = 12.53708332932087, a54 = -0.6878860361058950;
constexpr double c21 = -5.6688, c31 = -2.430093356833875, c32 = -0.2063599157091915, c41 = -0.1073529058151375,
                 c42 = -9.594562251023355, c43 = -20.47028614809616, c51 = 7.496443313967647, c52 = -10.24680431464352,
                 c53 = -33.99990352819905, c54 = 11.70890893206160, c61 = 8.083246795921522, c62 = -7.981132988064893,
                 c63 = -31.52159432874371, c64 = 16.31930543123136, c65 = -6.058818238834054;
constexpr double t2 = 0.386, t3 = 0.21, t4 = 0.63;
constexpr double d1 = 0.25, d2 = -0.1043, d3 = 0.1035, d4 = -0.0362;
constexpr double h21 = 10.12623508344586, h22 = -7.487995877610167, h23 = -34.80091861555747, h24 = -7.992771707568823,
                 h25 = 1.025137723295662, h31 = -0.6762803392801253, h32 = 6.087714651680015, h33 = 16.43084320892478,
                 h34 = 24.76722511418386, h35 = -6.594389125716872;

}  // namespace

Rosenbrock::Rosenbrock(const Plant& plant, const Surroundings& around, double rtol, double longest_way)
    : plant_(plant),
      around_(around),
      rtol_(rtol),
      longest_way_(longest_way),
      states_(plant.states()),
      degrees_(plant.degrees()),
      spins_(static_cast<int>(plant.rows.size())),
      jacobian_(static_cast<std::size_t>(states_ * states_)) {
  statistics_.method = "RODAS4";
  statistics_.rtol = rtol;
}

void Rosenbrock::start(double t, const std::vector<double>& y) {
  std::copy(y.begin(), y.end(), y_.begin());
  time_ = previous_ = t;
  h_ = 2e-3;
  last_h_ = 0.0;
}

/// Error weights: what one unit of relative tolerance means for each kind of state.
double Rosenbrock::norm(const State& error, const State& next) const {
  const auto kind = [&](int i) {
    if (i >= 2 * degrees_) return 10.0 + std::abs(next[static_cast<std::size_t>(i)]);
    const bool rate = i >= degrees_;
    const int k = rate ? i - degrees_ : i;
    const bool angle = k == 2 || k >= 3 + static_cast<int>(plant_.groups.size());
    if (k == 0) return rate ? 1.0 + std::abs(next[static_cast<std::size_t>(i)]) : 3.0;
    if (angle) return rate ? 0.3 : 0.05;
    return rate ? 1.0 : 0.1;
  };
  double sum = 0.0;
  for (int i = 0; i < states_; ++i) {
    const double e = error[static_cast<std::size_t>(i)] / (rtol_ * kind(i));
    sum += e * e;
  }
  return std::sqrt(sum / states_);
}

/// (E I − J) with x′ = v: k_x = (r_x + k_v)/E leaves (E − B − A/E) k_v − C k_ω = r_v + A r_x/E, and each spin depends
/// on itself alone, so k_ω goes too.
void Rosenbrock::factor(double h) {
  e_ = 1.0 / (h * gamma);
  const double per_e = 1.0 / e_;
  const int n = degrees_, s = states_;
  const auto j = [&](int row, int column) { return jacobian_[static_cast<std::size_t>(row * s + column)]; };
  const auto m = [&](int row, int column) -> double& { return m_[static_cast<std::size_t>(row * n + column)]; };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) m(i, k) = (i == k ? e_ : 0.0) - j(n + i, n + k) - j(n + i, k) * per_e;
  for (int w = 0; w < spins_; ++w) {
    const int row = 2 * n + w;
    const double inverse = 1.0 / (e_ - j(row, row));
    spin_inverse_[static_cast<std::size_t>(w)] = inverse;
    for (int k = 0; k < n; ++k) {
      spin_by_rate_[static_cast<std::size_t>(w * n + k)] = (j(row, n + k) + j(row, k) * per_e) * inverse;
      rate_by_spin_[static_cast<std::size_t>(w * n + k)] = j(n + k, row);
    }
    for (int i = 0; i < n; ++i) {
      const double c = rate_by_spin_[static_cast<std::size_t>(w * n + i)];
      if (c == 0.0) continue;
      for (int k = 0; k < n; ++k) m(i, k) -= c * spin_by_rate_[static_cast<std::size_t>(w * n + k)];
    }
  }
  for (int c = 0; c < n; ++c) {
    int best = c;
    for (int i = c + 1; i < n; ++i)
      if (std::abs(m(i, c)) > std::abs(m(best, c))) best = i;
    pivot_[static_cast<std::size_t>(c)] = best;
    if (best != c)
      for (int k = 0; k < n; ++k) std::swap(m(c, k), m(best, k));
    const double inverse = 1.0 / m(c, c);
    m(c, c) = inverse;
    for (int i = c + 1; i < n; ++i) {
      const double l = m(i, c) *= inverse;
      for (int k = c + 1; k < n; ++k) m(i, k) -= l * m(c, k);
    }
  }
}

void Rosenbrock::solve(const State& right, State& solution) const {
  const int n = degrees_, s = states_;
  const double per_e = 1.0 / e_;
  double v[most_degrees];
  for (int i = 0; i < n; ++i) {
    double sum = right[static_cast<std::size_t>(n + i)];
    const double* a = &jacobian_[static_cast<std::size_t>((n + i) * s)];
    for (int k = 0; k < n; ++k) sum += a[k] * per_e * right[static_cast<std::size_t>(k)];
    v[i] = sum;
  }
  double w[most_rows];
  for (int r = 0; r < spins_; ++r) {
    double sum = right[static_cast<std::size_t>(2 * n + r)];
    const double* d = &jacobian_[static_cast<std::size_t>((2 * n + r) * s)];
    for (int k = 0; k < n; ++k) sum += d[k] * per_e * right[static_cast<std::size_t>(k)];
    w[r] = sum * spin_inverse_[static_cast<std::size_t>(r)];
    for (int i = 0; i < n; ++i) v[i] += rate_by_spin_[static_cast<std::size_t>(r * n + i)] * w[r];
  }
  for (int c = 0; c < n; ++c) std::swap(v[c], v[pivot_[static_cast<std::size_t>(c)]]);
  for (int c = 0; c < n; ++c) {
    for (int i = c + 1; i < n; ++i) v[i] -= m_[static_cast<std::size_t>(i * n + c)] * v[c];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) v[i] -= m_[static_cast<std::size_t>(i * n + k)] * v[k];
    v[i] *= m_[static_cast<std::size_t>(i * n + i)];
  }
  for (int i = 0; i < n; ++i) {
    solution[static_cast<std::size_t>(n + i)] = v[i];
    solution[static_cast<std::size_t>(i)] = (right[static_cast<std::size_t>(i)] + v[i]) * per_e;
  }
  for (int r = 0; r < spins_; ++r) {
    double sum = w[r];
    for (int k = 0; k < n; ++k) sum += spin_by_rate_[static_cast<std::size_t>(r * n + k)] * v[k];
    solution[static_cast<std::size_t>(2 * n + r)] = sum;
  }
}

bool Rosenbrock::attempt(double h, State& next, double& error) {
  factor(h);
  const double per_h = 1.0 / h;
  State f, right, at;
  const auto combine = [&](std::initializer_list<std::pair<int, double>> terms, State& result, const State& base,
                           double factor) {
    for (int i = 0; i < states_; ++i) {
      double sum = 0.0;
      for (const auto& [k, c] : terms) sum += c * u_[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
      result[static_cast<std::size_t>(i)] = base[static_cast<std::size_t>(i)] + factor * sum;
    }
  };
  const auto evaluate = [&](double t, const State& y) {
    derivatives(plant_, around_, t, y.data(), f.data());
    ++statistics_.rhs_calls;
  };
  const auto add_time = [&](double d) {
    if (!plant_.timed_thrust) return;
    for (int i = 0; i < states_; ++i) right[static_cast<std::size_t>(i)] += h * d * dfdt_[static_cast<std::size_t>(i)];
  };
  right = f0_;
  add_time(d1);
  solve(right, u_[0]);
  combine({{0, a21}}, at, y_, 1.0);
  evaluate(time_ + t2 * h, at);
  combine({{0, c21}}, right, f, per_h);
  add_time(d2);
  solve(right, u_[1]);
  combine({{0, a31}, {1, a32}}, at, y_, 1.0);
  evaluate(time_ + t3 * h, at);
  combine({{0, c31}, {1, c32}}, right, f, per_h);
  add_time(d3);
  solve(right, u_[2]);
  combine({{0, a41}, {1, a42}, {2, a43}}, at, y_, 1.0);
  evaluate(time_ + t4 * h, at);
  combine({{0, c41}, {1, c42}, {2, c43}}, right, f, per_h);
  add_time(d4);
  solve(right, u_[3]);
  combine({{0, a51}, {1, a52}, {2, a53}, {3, a54}}, next, y_, 1.0);
  evaluate(time_ + h, next);
  combine({{0, c51}, {1, c52}, {2, c53}, {3, c54}}, right, f, per_h);
  solve(right, u_[4]);
  for (int i = 0; i < states_; ++i) next[static_cast<std::size_t>(i)] += u_[4][static_cast<std::size_t>(i)];
  evaluate(time_ + h, next);
  combine({{0, c61}, {1, c62}, {2, c63}, {3, c64}, {4, c65}}, right, f, per_h);
  solve(right, u_[5]);
  for (int i = 0; i < states_; ++i) next[static_cast<std::size_t>(i)] += u_[5][static_cast<std::size_t>(i)];
  error = norm(u_[5], next);
  return std::isfinite(error);
}

double Rosenbrock::step() {
  jacobian(plant_, around_, time_, y_.data(), f0_.data(), jacobian_.data());
  ++statistics_.jacobians;
  ++statistics_.rhs_calls;
  if (plant_.timed_thrust) {
    State later;
    const double dt = 1e-5;
    derivatives(plant_, around_, time_ + dt, y_.data(), later.data());
    for (int i = 0; i < states_; ++i)
      dfdt_[static_cast<std::size_t>(i)] = (later[static_cast<std::size_t>(i)] - f0_[static_cast<std::size_t>(i)]) / dt;
  }
  State next;
  bool rejected = false;
  h_ = std::min(h_, longest_way_ / std::max(1.0, std::abs(y_[static_cast<std::size_t>(degrees_)])));
  for (;;) {
    double error = 0.0;
    const double h = h_;
    const bool finite = attempt(h, next, error);
    if (finite && error <= 1.0) {
      double factor = std::pow(std::max(error, 1e-8), 0.25) / 0.9;
      if (last_h_ > 0.0)  // predictive controller of Gustafsson
        factor = std::max(
            factor, last_h_ / h * std::pow(std::max(error, 1e-8) * std::max(error, 1e-8) / last_error_, 0.25) / 0.9);
      factor = std::clamp(factor, 1.0 / 6.0, 5.0);
      if (rejected) factor = std::max(1.0, factor);
      last_h_ = h;
      last_error_ = std::max(1e-2, error);
      for (int i = 0; i < states_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        dense_[0][k] = y_[k];
        dense_[1][k] = next[k];
        dense_[2][k] = h21 * u_[0][k] + h22 * u_[1][k] + h23 * u_[2][k] + h24 * u_[3][k] + h25 * u_[4][k];
        dense_[3][k] = h31 * u_[0][k] + h32 * u_[1][k] + h33 * u_[2][k] + h34 * u_[3][k] + h35 * u_[4][k];
      }
      y_ = next;
      previous_ = time_;
      time_ += h;
      h_ = h / factor;
      ++statistics_.steps;
      return time_;
    }
    rejected = true;
    ++statistics_.error_test_failures;
    h_ = finite ? h / std::clamp(std::pow(error, 0.25) / 0.9, 1.2, 5.0) : 0.2 * h;
    if (h_ < 1e-9)
      throw SolveError(concat("RODAS4 gave up at t = ", time_, " s (step size below 1e-9 s), speed ",
                              y_[static_cast<std::size_t>(degrees_)], " m/s, pitch ", y_[2], " rad, nose stroke ",
                              y_[3], " m. Try the reference method, or a looser tolerance"),
                       time_);
  }
}

void Rosenbrock::state(double t, double* y) const {
  const double theta = (t - previous_) / (time_ - previous_), other = 1.0 - theta;
  for (int i = 0; i < states_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    y[i] = dense_[0][k] * other + theta * (dense_[1][k] + other * (dense_[2][k] + theta * dense_[3][k]));
  }
}

}  // namespace apc::simulation
