/// rosenbrock_step.cpp for runs side by side: the same operations in the same order, lane by lane, on numbers in
/// vectors instead of columns in vectors. Rows are exchanged only in the lanes whose pivots ask for it.
#pragma once

#include "apc/simulation/lanes.h"
#include "apc/simulation/rosenbrock_step.h"

namespace apc::simulation {

template <int W>
struct LaneWork {
  using V = Lanes<W>;
  int degrees = 0, spins = 0, states = 0;
  V y[most_states], next[most_states], f0[most_states], f[most_states], at[most_states];
  V u[6][most_states];
  V jacobian[(most_degrees + most_rows) * most_states];  ///< rows of the accelerations, then of the spin rates
  double weight[most_states], weight_by_size[most_states];
  V e, per_e, per_h;
  V inverse[most_degrees][most_degrees];      ///< M⁻¹ by column
  V by_position[most_degrees][most_degrees];  ///< K by column
  V spin_by_rate[most_degrees][most_rows], spin_by_position[most_degrees][most_rows];
  V by_spin[most_rows][most_degrees], spin_inverse[most_rows];
};

/// M⁻¹ in place of M by Gauss–Jordan with row pivots; `m` by row, `inverse` by column.
template <int W>
void invert(Lanes<W> (&m)[most_degrees][most_degrees], int n, Lanes<W> (&inverse)[most_degrees][most_degrees]) {
  using V = Lanes<W>;
  V pivot_row[most_degrees];
  bool exchanged[most_degrees];
  for (int k = 0; k < n; ++k) {
    V best = static_cast<double>(k), size = abs(m[k][k]);
    for (int i = k + 1; i < n; ++i) {
      const V other = abs(m[i][k]);
      const auto larger = other > size;
      best = select(larger, V(static_cast<double>(i)), best);
      size = select(larger, other, size);
    }
    pivot_row[k] = best;
    exchanged[k] = any(best != V(static_cast<double>(k)));
    if (exchanged[k])
      for (int i = k + 1; i < n; ++i) {
        const auto here = best == V(static_cast<double>(i));
        if (!any(here)) continue;
        for (int j = 0; j < n; ++j) {
          const V a = m[k][j], b = m[i][j];
          m[k][j] = select(here, b, a);
          m[i][j] = select(here, a, b);
        }
      }
    const V pivot = 1.0 / m[k][k];
    for (int j = 0; j < n; ++j)
      if (j != k) m[k][j] *= pivot;
    m[k][k] = pivot;
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const V l = m[i][k];
      for (int j = 0; j < n; ++j)
        if (j != k) m[i][j] -= l * m[k][j];
      m[i][k] = V(0.0) - l * pivot;
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    if (!exchanged[k]) continue;
    for (int i = k + 1; i < n; ++i) {
      const auto here = pivot_row[k] == V(static_cast<double>(i));
      if (!any(here)) continue;
      for (int j = 0; j < n; ++j) {
        const V a = m[j][k], b = m[j][i];
        m[j][k] = select(here, b, a);
        m[j][i] = select(here, a, b);
      }
    }
  }
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) inverse[k][i] = m[i][k];
}

template <int W>
void eliminate(LaneWork<W>& work, const Lanes<W>& h) {
  using V = Lanes<W>;
  const int n = work.degrees, s = work.spins, states = work.states;
  const V e = work.e = 1.0 / (h * stage_gamma), per_e = work.per_e = 1.0 / e;
  work.per_h = 1.0 / h;
  const V* accelerations = work.jacobian;
  const V* spin_rates = work.jacobian + n * states;
  V m[most_degrees][most_degrees], by_spin[most_rows][most_degrees];
  for (int w = 0; w < s; ++w) {
    const V* row = spin_rates + w * states;
    const V inverse = work.spin_inverse[w] = 1.0 / (e - row[2 * n + w]);
    for (int k = 0; k < n; ++k) {
      const V by_position = row[k] * per_e;
      work.spin_by_position[k][w] = inverse * by_position;
      work.spin_by_rate[k][w] = inverse * (row[n + k] + by_position);
    }
    for (int i = 0; i < n; ++i) by_spin[w][i] = accelerations[i * states + 2 * n + w];
  }
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) {
      V column(0.0);
      for (int w = 0; w < s; ++w) column += by_spin[w][i] * work.spin_by_rate[k][w];
      m[i][k] =
          ((i == k ? e : V(0.0)) - accelerations[i * states + n + k]) - accelerations[i * states + k] * per_e - column;
    }
  invert<W>(m, n, work.inverse);
  for (int w = 0; w < s; ++w)
    for (int j = 0; j < n; ++j) {
      V column(0.0);
      for (int i = 0; i < n; ++i) column += work.inverse[i][j] * by_spin[w][i];
      work.by_spin[w][j] = work.spin_inverse[w] * column;
    }
  for (int k = 0; k < n; ++k) {
    V column[most_degrees];
    for (int j = 0; j < n; ++j) column[j] = 0.0;
    for (int i = 0; i < n; ++i) {
      const V by_position = accelerations[i * states + k] * per_e;
      for (int j = 0; j < n; ++j) column[j] += work.inverse[i][j] * by_position;
    }
    for (int w = 0; w < s; ++w) {
      const V d = spin_rates[w * states + k] * per_e;
      for (int j = 0; j < n; ++j) column[j] += work.by_spin[w][j] * d;
    }
    for (int j = 0; j < n; ++j) work.by_position[k][j] = column[j];
  }
}

template <int W>
void place(LaneWork<W>& work, int stage) {
  if (stage == 5) return;  // next is in place
  Lanes<W>* at = stage == 4 ? work.next : work.at;
  for (int i = 0; i < work.states; ++i) {
    Lanes<W> sum(0.0);
    for (int k = 0; k < stage; ++k) sum += stage_a[stage - 1][k] * work.u[k][i];
    at[i] = work.y[i] + sum;
  }
}

template <int W>
void solve(LaneWork<W>& work, int stage) {
  using V = Lanes<W>;
  const int n = work.degrees, s = work.spins;
  V r[most_states], weight[5];
  for (int k = 0; k < stage; ++k) weight[k] = stage_c[stage - 1][k] * work.per_h;
  const V* f = stage == 0 ? work.f0 : work.f;
  for (int i = 0; i < work.states; ++i) {
    V sum(0.0);
    for (int k = 0; k < stage; ++k) sum += weight[k] * work.u[k][i];
    r[i] = sum + f[i];
  }
  V v1[most_degrees], v2[most_degrees], v3[most_degrees];
  for (int i = 0; i < n; ++i) v1[i] = v2[i] = v3[i] = 0.0;
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) {
      v1[i] += work.inverse[k][i] * r[n + k];
      v2[i] += work.by_position[k][i] * r[k];
    }
  for (int k = 0; k < s; ++k)
    for (int i = 0; i < n; ++i) v3[i] += work.by_spin[k][i] * r[2 * n + k];
  V* u = work.u[stage];
  for (int i = 0; i < n; ++i) {
    v1[i] += v2[i] + v3[i];
    u[i] = (r[i] + v1[i]) * work.per_e;
    u[n + i] = v1[i];
  }
  for (int i = 0; i < s; ++i) {
    V w = work.spin_inverse[i] * r[2 * n + i];
    for (int k = 0; k < n; ++k) w += work.spin_by_position[k][i] * r[k] + work.spin_by_rate[k][i] * v1[k];
    u[2 * n + i] = w;
  }
  if (stage >= 4)
    for (int i = 0; i < work.states; ++i) work.next[i] += u[i];
}

template <int W>
Lanes<W> norm(const LaneWork<W>& work) {
  using V = Lanes<W>;
  const int n = work.degrees, s = work.spins;
  V sum(0.0);
  const auto add = [&](int i) {
    const V e = work.u[5][i] / (work.weight[i] + work.weight_by_size[i] * abs(work.next[i]));
    sum += e * e;
  };
  for (int i = 0; i < n; ++i) add(i), add(n + i);
  for (int i = 0; i < s; ++i) add(2 * n + i);
  return sqrt(sum / static_cast<double>(2 * n + s));
}

}  // namespace apc::simulation
