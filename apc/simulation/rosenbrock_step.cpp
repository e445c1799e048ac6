#include "apc/simulation/rosenbrock_step.h"

#include <cmath>
#include <utility>

#include "apc/simulation/every_processor.h"

namespace apc::simulation {
namespace {

/// W: width of a column; degrees and spins fit into it. Stages are kept as three such columns: positions, rates, spins.
/// N, S: degrees and spins of the usual gears, known to the compiler; 0 = any.
template <int W, int N, int S>
inline bool eliminate_of(StepWork& work, double h) {
  const int n = N > 0 ? N : work.degrees, s = N > 0 ? S : work.spins, states = 2 * n + s;
  const double e = work.e = 1.0 / (h * stage_gamma), per_e = work.per_e = 1.0 / e;
  const double* accelerations = &work.jacobian[static_cast<std::size_t>(n * states)];
  const double* spin_rates = &work.jacobian[static_cast<std::size_t>(2 * n * states)];
  // [M | I], column by column.
  double m[W][2 * W] = {};
  double by_spin[most_rows][W] = {};
  for (int w = 0; w < s; ++w) {
    const double* row = spin_rates + w * states;
    const double inverse = 1.0 / (e - row[2 * n + w]);
    work.spin_inverse[static_cast<std::size_t>(w)] = inverse;
    for (int k = 0; k < n; ++k) {
      const double by_position = row[k] * per_e;
      work.spin_by_position[static_cast<std::size_t>(k * W + w)] = inverse * by_position;
      work.spin_by_rate[static_cast<std::size_t>(k * W + w)] = inverse * (row[n + k] + by_position);
    }
    for (int i = 0; i < n; ++i) by_spin[w][i] = accelerations[i * states + 2 * n + w];
  }
  for (int k = 0; k < n; ++k) {
    double column[W] = {};
    for (int w = 0; w < s; ++w) {
      const double g = work.spin_by_rate[static_cast<std::size_t>(k * W + w)];
      for (int i = 0; i < W; ++i) column[i] += by_spin[w][i] * g;
    }
    for (int i = 0; i < n; ++i)
      m[i][k] =
          ((i == k ? e : 0.0) - accelerations[i * states + n + k]) - accelerations[i * states + k] * per_e - column[i];
    m[k][W + k] = 1.0;
  }
  // Gauss–Jordan with row pivots.
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(m[i][k]) > std::abs(m[best][k])) best = i;
    if (best != k)
      for (int j = 0; j < 2 * W; ++j) std::swap(m[k][j], m[best][j]);
    const double inverse = 1.0 / m[k][k];
    for (int j = 0; j < 2 * W; ++j) m[k][j] *= inverse;
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const double l = m[i][k];
      for (int j = 0; j < 2 * W; ++j) m[i][j] -= l * m[k][j];
    }
  }
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < W; ++i) work.inverse[static_cast<std::size_t>(k * W + i)] = m[i][W + k];
  const double* inverse = work.inverse.data();
  for (int w = 0; w < s; ++w) {
    double column[W] = {};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < W; ++j) column[j] += inverse[i * W + j] * by_spin[w][i];
    const double scale = work.spin_inverse[static_cast<std::size_t>(w)];
    for (int j = 0; j < W; ++j) work.by_spin[static_cast<std::size_t>(w * W + j)] = scale * column[j];
  }
  for (int k = 0; k < n; ++k) {
    double column[W] = {};
    for (int i = 0; i < n; ++i) {
      const double by_position = accelerations[i * states + k] * per_e;
      for (int j = 0; j < W; ++j) column[j] += inverse[i * W + j] * by_position;
    }
    for (int w = 0; w < s; ++w) {
      const double d = spin_rates[w * states + k] * per_e;
      for (int j = 0; j < W; ++j) column[j] += work.by_spin[static_cast<std::size_t>(w * W + j)] * d;
    }
    for (int j = 0; j < W; ++j) work.by_position[static_cast<std::size_t>(k * W + j)] = column[j];
  }
  return std::isfinite(inverse[0]);
}

/// Sum of weighted stages; in registers.
template <int L>
inline void add_stages(const StepWork& work, int count, const double* weights, double scale, double (&sum)[L]) {
  for (int k = 0; k < count; ++k) {
    const double weight = weights[k] * scale;
    const double* u = work.u[static_cast<std::size_t>(k)].data();
    for (int i = 0; i < L; ++i) sum[i] += weight * u[i];
  }
}

template <int W, int N, int S>
inline void solve_of(StepWork& work, int stage, double h, double time_share) {
  const int n = N > 0 ? N : work.degrees, s = N > 0 ? S : work.spins;
  alignas(64) double r[3 * W] = {};
  if (stage > 0) add_stages(work, stage, stage_c[stage - 1], 1.0 / h, r);
  const double* f = stage == 0 ? work.f0.data() : work.f.data();
  double g[3 * W] = {};
  for (int i = 0; i < n; ++i) g[i] = f[i], g[W + i] = f[n + i];
  for (int i = 0; i < s; ++i) g[2 * W + i] = f[2 * n + i];
  if (time_share != 0.0) {
    for (int i = 0; i < n; ++i)
      g[i] += time_share * work.dfdt.data()[i], g[W + i] += time_share * work.dfdt.data()[n + i];
    for (int i = 0; i < s; ++i) g[2 * W + i] += time_share * work.dfdt.data()[2 * n + i];
  }
  for (int i = 0; i < 3 * W; ++i) r[i] += g[i];

  double v1[W] = {}, v2[W] = {}, v3[W] = {}, w[W];
  for (int k = 0; k < n; ++k) {
    const double rv = r[W + k], rx = r[k];
    for (int i = 0; i < W; ++i) v1[i] += work.inverse[static_cast<std::size_t>(k * W + i)] * rv;
    for (int i = 0; i < W; ++i) v2[i] += work.by_position[static_cast<std::size_t>(k * W + i)] * rx;
  }
  for (int k = 0; k < s; ++k) {
    const double rw = r[2 * W + k];
    for (int i = 0; i < W; ++i) v3[i] += work.by_spin[static_cast<std::size_t>(k * W + i)] * rw;
  }
  for (int i = 0; i < W; ++i) v1[i] += v2[i] + v3[i];
  for (int i = 0; i < W; ++i) w[i] = work.spin_inverse[static_cast<std::size_t>(i)] * r[2 * W + i];
  for (int k = 0; k < n; ++k) {
    const double rx = r[k], v = v1[k];
    for (int i = 0; i < W; ++i)
      w[i] += work.spin_by_position[static_cast<std::size_t>(k * W + i)] * rx +
              work.spin_by_rate[static_cast<std::size_t>(k * W + i)] * v;
  }
  double* u = work.u[static_cast<std::size_t>(stage)].data();
  const double per_e = work.per_e;
  for (int i = 0; i < W; ++i) u[i] = (r[i] + v1[i]) * per_e;
  for (int i = 0; i < W; ++i) u[W + i] = v1[i];
  for (int i = 0; i < W; ++i) u[2 * W + i] = w[i];
  if (stage >= 4) {
    for (int i = 0; i < n; ++i) work.next.data()[i] += u[i], work.next.data()[n + i] += u[W + i];
    for (int i = 0; i < s; ++i) work.next.data()[2 * n + i] += u[2 * W + i];
  }
}

template <int W, int N, int S>
inline void place_of(StepWork& work, int stage) {
  if (stage == 5) return;  // next is in place
  const int n = N > 0 ? N : work.degrees, s = N > 0 ? S : work.spins;
  double* at = stage == 4 ? work.next.data() : work.at.data();
  double sum[3 * W] = {};
  add_stages(work, stage, stage_a[stage - 1], 1.0, sum);
  for (int i = 0; i < n; ++i) at[i] = work.y.data()[i] + sum[i], at[n + i] = work.y.data()[n + i] + sum[W + i];
  for (int i = 0; i < s; ++i) at[2 * n + i] = work.y.data()[2 * n + i] + sum[2 * W + i];
}

template <int W, int N, int S>
inline void dense_of(const StepWork& work, double* second, double* third) {
  const int n = N > 0 ? N : work.degrees, s = N > 0 ? S : work.spins;
  double sum2[3 * W] = {}, sum3[3 * W] = {};
  add_stages(work, 5, dense_second, 1.0, sum2);
  add_stages(work, 5, dense_third, 1.0, sum3);
  for (int i = 0; i < n; ++i) {
    second[i] = sum2[i], second[n + i] = sum2[W + i];
    third[i] = sum3[i], third[n + i] = sum3[W + i];
  }
  for (int i = 0; i < s; ++i) second[2 * n + i] = sum2[2 * W + i], third[2 * n + i] = sum3[2 * W + i];
}

template <int W, int N, int S>
inline double norm_of(const StepWork& work) {
  const int n = N > 0 ? N : work.degrees, s = N > 0 ? S : work.spins;
  const double* u = work.u[5].data();
  double sum = 0.0;
  const auto add = [&](int i, double error) {
    const double e = error / (work.weight.data()[i] + work.weight_by_size.data()[i] * std::abs(work.next.data()[i]));
    sum += e * e;
  };
  for (int i = 0; i < n; ++i) add(i, u[i]), add(n + i, u[W + i]);
  for (int i = 0; i < s; ++i) add(2 * n + i, u[2 * W + i]);
  return std::sqrt(sum / (2 * n + s));
}

#define APC_STEP_KERNEL(name, W, N, S)                                                                               \
  APC_FOR_EVERY_PROCESSOR bool eliminate_##name(StepWork& work, double h) { return eliminate_of<W, N, S>(work, h); } \
  APC_FOR_EVERY_PROCESSOR void place_##name(StepWork& work, int stage) { place_of<W, N, S>(work, stage); }           \
  APC_FOR_EVERY_PROCESSOR void solve_##name(StepWork& work, int stage, double h, double share) {                     \
    solve_of<W, N, S>(work, stage, h, share);                                                                        \
  }                                                                                                                  \
  APC_FOR_EVERY_PROCESSOR void dense_##name(const StepWork& work, double* second, double* third) {                   \
    dense_of<W, N, S>(work, second, third);                                                                          \
  }                                                                                                                  \
  APC_FOR_EVERY_PROCESSOR double norm_##name(const StepWork& work) { return norm_of<W, N, S>(work); }                \
  constexpr StepKernel name{eliminate_##name, place_##name, solve_##name, dense_##name, norm_##name};

APC_STEP_KERNEL(two_gears, 8, 5, 2)
APC_STEP_KERNEL(three_gears_two_bogies, 8, 8, 5)
APC_STEP_KERNEL(small, 8, 0, 0)
APC_STEP_KERNEL(large, 16, 0, 0)

}  // namespace

const StepKernel& step_kernel(const StepWork& work) {
  if (work.degrees == 5 && work.spins == 2) return two_gears;
  if (work.degrees == 8 && work.spins == 5) return three_gears_two_bogies;
  return work.degrees > 8 || work.spins > 8 ? large : small;
}

}  // namespace apc::simulation
