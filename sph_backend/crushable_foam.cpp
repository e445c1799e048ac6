#include "sph_backend/crushable_foam.h"

#include <algorithm>
#include <cmath>

namespace apc::sph {
namespace {

struct Principal {
  double value[3];
  double axis[3][3];  ///< axis[i][k]: component i of direction k
};

/// Cyclic Jacobi rotations; a sixth of a double's digits are reached in at most five sweeps of a 3 × 3 matrix.
Principal decompose(const Stress& s) {
  double a[3][3] = {{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
  Principal p{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double scale = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  for (int sweep = 0; sweep < 12; ++sweep) {
    if (a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2] <= 1e-24 * scale) break;
    for (int i = 0; i < 2; ++i)
      for (int j = i + 1; j < 3; ++j) {
        if (a[i][j] == 0.0) continue;
        const double theta = 0.5 * (a[j][j] - a[i][i]) / a[i][j];
        const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), sine = t * c;
        for (int k = 0; k < 3; ++k) {
          const double u = a[k][i], v = a[k][j];
          a[k][i] = c * u - sine * v, a[k][j] = sine * u + c * v;
        }
        for (int k = 0; k < 3; ++k) {
          const double u = a[i][k], v = a[j][k];
          a[i][k] = c * u - sine * v, a[j][k] = sine * u + c * v;
        }
        for (int k = 0; k < 3; ++k) {
          const double u = p.axis[k][i], v = p.axis[k][j];
          p.axis[k][i] = c * u - sine * v, p.axis[k][j] = sine * u + c * v;
        }
      }
  }
  for (int k = 0; k < 3; ++k) p.value[k] = a[k][k];
  return p;
}

double yield_at(const YieldTable& table, double strain) {
  const double place = std::clamp(strain * YieldTable::intervals, 0.0, YieldTable::intervals - 1.0);
  const int i = static_cast<int>(place);
  const double f = place - i;
  return (1.0 - f) * table.stress[i] + f * table.stress[i + 1];
}

/// R σ Rᵀ for the turn Ω of the step, Ω_ij = ½ (L_ij − L_ji) Δt.
Stress turned(const Stress& s, const Tensor& g) {
  const double wz = 0.5 * (g[3] - g[1]), wy = 0.5 * (g[2] - g[6]), wx = 0.5 * (g[7] - g[5]);  // axial vector
  const double size = wx * wx + wy * wy + wz * wz;
  if (size == 0.0) return s;
  const double c = 1.0 / (1.0 + 0.25 * size);
  const double w[3][3] = {{0.0, -wz, wy}, {wz, 0.0, -wx}, {-wy, wx, 0.0}};
  const double a[3] = {wx, wy, wz};
  double r[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = (i == j ? 1.0 - 0.5 * c * size : 0.0) + c * (w[i][j] + 0.5 * a[i] * a[j]);
  const double m[3][3] = {{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
  double rm[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rm[i][j] = r[i][0] * m[0][j] + r[i][1] * m[1][j] + r[i][2] * m[2][j];
  const auto entry = [&](int i, int j) { return rm[i][0] * r[j][0] + rm[i][1] * r[j][1] + rm[i][2] * r[j][2]; };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

}  // namespace

CrushLaw crush_law(const Foam& foam, double length) {
  CrushLaw law;
  law.lame_lambda = foam.lame_lambda(), law.shear_modulus = foam.shear_modulus();
  law.tension_cutoff = foam.tension_cutoff, law.poisson_ratio = foam.poisson_ratio;
  law.damping = foam.sound_speed() * foam.density * foam.damping * length;
  law.yield = tabulate(foam);
  return law;
}

Stretching symmetric_part(const Tensor& g) {
  return {g[0], g[4], g[8], 0.5 * (g[1] + g[3]), 0.5 * (g[2] + g[6]), 0.5 * (g[5] + g[7])};
}

double inner(const Stress& s, const Stretching& d) {
  return s[0] * d[0] + s[1] * d[1] + s[2] * d[2] + 2.0 * (s[3] * d[3] + s[4] * d[4] + s[5] * d[5]);
}

Stress crush(const CrushLaw& law, const Stress& old, const Tensor& increment, double compaction) {
  Stress s = turned(old, increment);
  const Stretching e = symmetric_part(increment);
  const double p = law.lame_lambda * (e[0] + e[1] + e[2]);
  for (int k = 0; k < 6; ++k) s[k] += 2.0 * law.shear_modulus * e[k] + (k < 3 ? p : 0.0);

  // Circles around the diagonal (Gershgorin) bound the principal values: most points need no decomposition.
  const double yield = yield_at(law.yield, compaction);
  const double ox = std::abs(s[3]) + std::abs(s[4]), oy = std::abs(s[3]) + std::abs(s[5]),
               oz = std::abs(s[4]) + std::abs(s[5]);
  const double high = std::max({s[0] + ox, s[1] + oy, s[2] + oz}), low = std::min({s[0] - ox, s[1] - oy, s[2] - oz});
  if (high <= law.tension_cutoff && low >= -yield) return s;
  Principal principal = decompose(s);
  for (double& value : principal.value) value = std::clamp(value, -yield, law.tension_cutoff);
  const auto entry = [&](int i, int j) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += principal.axis[i][k] * principal.value[k] * principal.axis[j][k];
    return sum;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

Stress damping_stress(const CrushLaw& law, const Stretching& d, double compaction) {
  const double a = law.damping / (1.0 + std::max(compaction, -0.5)), trace = d[0] + d[1] + d[2];
  const double dev = a / (1.0 + law.poisson_ratio), vol = a * trace / (3.0 * (1.0 - 2.0 * law.poisson_ratio));
  Stress s;
  for (int k = 0; k < 6; ++k) s[k] = dev * (k < 3 ? d[k] - trace / 3.0 : d[k]) + (k < 3 ? vol : 0.0);
  return s;
}

}  // namespace apc::sph
