#include "sph_backend/crushable_foam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "apc/base/units.h"
#include "sph_backend/kernel.h"
#include "sph_backend/pair_kernels.h"

namespace apc::sph {
namespace {

using units::psi;

CrushLaw published_law() {
  Foam foam = ideal_foam_50psi();
  foam.damping = 0.0;
  return crush_law(foam, 1.0);
}

Tensor diagonal(double xx, double yy, double zz) { return {xx, 0, 0, 0, yy, 0, 0, 0, zz}; }

TEST(CrushableFoam, UniaxialCrushFollowsTheLoadCurve) {
  const CrushLaw law = published_law();
  const Foam foam = ideal_foam_50psi();
  Stress s{};
  double height = 1.0;
  for (int k = 0; k < 8600; ++k) {
    const double step = 1e-4, middle = height - 0.5 * step;
    height -= step;
    s = crush(law, s, diagonal(0.0, 0.0, -step / middle), 1.0 - height);
    const double elastic = -foam.youngs_modulus * std::log(height);
    EXPECT_NEAR(-s[2], std::min(elastic, foam.yield_stress(1.0 - height)), 0.02 * psi) << height;
    EXPECT_EQ(s[0], 0.0);
  }
  EXPECT_GT(-s[2], 140.0 * psi);  // 1 % into the lock
}

TEST(CrushableFoam, UnloadsWithTheModulusAndTearsAtTheCutoff) {
  const CrushLaw law = published_law();
  const Foam foam = ideal_foam_50psi();
  Stress s = crush(law, {}, diagonal(-0.2, 0.0, 0.0), 0.2);
  EXPECT_NEAR(s[0], -50.0 * psi, 1e-3 * psi);
  s = crush(law, s, diagonal(0.01, 0.0, 0.0), 0.2);
  EXPECT_NEAR(s[0], -50.0 * psi + 0.01 * foam.youngs_modulus, 1e-3 * psi);
  s = crush(law, s, diagonal(0.5, 0.0, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(s[0], foam.tension_cutoff);
}

TEST(CrushableFoam, TurnsItsStressWithTheBody) {
  // 100 steps to a quarter turn about z, at mid-step L = 2 tan(θ/2) k×: σ_xx ends as σ_yy.
  const CrushLaw law = published_law();
  const double step = 2.0 * std::tan(0.25 * std::numbers::pi / 100.0);
  Stress s{-20.0 * psi, 0.0, -7.0 * psi, 0.0, 0.0, 0.0};
  for (int k = 0; k < 100; ++k) s = crush(law, s, {0, -step, 0, step, 0, 0, 0, 0, 0}, 0.0);
  EXPECT_NEAR(s[1] / psi, -20.0, 1e-9);
  EXPECT_NEAR(s[0] / psi, 0.0, 1e-9);
  EXPECT_NEAR(s[2] / psi, -7.0, 1e-9);
}

TEST(CrushableFoam, RateDampingSplitsIntoVolumeAndShape) {
  Foam foam = ideal_foam_50psi();
  foam.poisson_ratio = 0.25;
  const CrushLaw law = crush_law(foam, 0.05);
  const double a = foam.sound_speed() * foam.density * foam.damping * 0.05 / 1.5;
  const Stress swelling = damping_stress(law, {2.0, 2.0, 2.0, 0, 0, 0}, 0.5);
  EXPECT_NEAR(swelling[0], a * 6.0 / (3.0 * 0.5), 1e-9 * a);
  const Stress shear = damping_stress(law, {0, 0, 0, 3.0, 0, 0}, 0.5);
  EXPECT_NEAR(shear[3], a * 3.0 / 1.25, 1e-9 * a);
}

/// The particles' kernel on one particle whose three neighbours give any velocity gradient.
TEST(CrushableFoam, IsTheLawOfTheParticles) {
  Foam foam = ideal_foam_50psi();
  foam.poisson_ratio = 0.2, foam.damping = 0.0, foam.tension_cutoff = 10.0 * psi;
  const CrushLaw law = crush_law(foam, 1.0);
  const YieldTable yield = tabulate(foam);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> part(-1.0f, 1.0f);
  const float dt = 1e-4f, distance = 0.02f, quarter_inverse_h = 7.5f, volume0 = 1.6e-5f, mass = 6.4e-3f;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<float> records((whole_vector + 4) * record::size, 0.0f);  // the last is nothing
    const float s0 = 1.0f + 0.4f * (1.0f + part(random));                 // compacted up to 83 %
    Tensor rate;
    for (double& r : rate) r = 150.0 * part(random);
    for (int l = 0; l < whole_vector; ++l) records[l * record::size + record::quarter_inverse_h] = quarter_inverse_h;
    const double volume = volume0 / std::pow(s0, 3);
    const double weight = -kernel_slope(distance, 4.0 * quarter_inverse_h) * distance * volume;
    for (int j = 0; j < 3; ++j) {  // neighbour at −distance on axis j: L_ij = V w (v_i − v_j) d
      float* q = &records[(whole_vector + j) * record::size];
      q[record::x + j] = -distance, q[record::quarter_inverse_h] = quarter_inverse_h;
      for (int i = 0; i < 3; ++i) q[record::vx + i] = static_cast<float>(-rate[3 * i + j] / weight);
    }
    records[(whole_vector + 3) * record::size] = 1e4f;
    constexpr std::uint32_t j0 = whole_vector;
    const std::uint32_t list[8] = {j0, j0 + 1, j0 + 2, j0 + 3, j0, j0 + 1, j0 + 2, j0 + 3}, first[3] = {0, 4, 8};
    std::vector<float> stretch(whole_vector, s0), work(whole_vector, 0.0f);
    std::vector<std::vector<float>> stress(6, std::vector<float>(whole_vector));
    Stress old;
    for (int c = 0; c < 6; ++c) {
      old[c] = 25.0 * psi * part(random);
      std::fill(stress[c].begin(), stress[c].end(), static_cast<float>(old[c]));
    }
    double internal[2], viscous[2], damped[2];
    PairWork w{};
    w.records = records.data(), w.neighbour = list, w.first = first;
    w.stretch = stretch.data(), w.work = work.data();
    for (int c = 0; c < 6; ++c) w.stress[c] = stress[c].data();
    w.internal = internal, w.viscous = viscous, w.damped = damped;
    w.yield = yield.stress.data(), w.yield_intervals = YieldTable::intervals, w.yield_lowest = yield.lowest;
    w.tension_cutoff = static_cast<float>(foam.tension_cutoff), w.dt = dt;
    w.lame_lambda = static_cast<float>(foam.lame_lambda());
    w.shear_modulus = static_cast<float>(foam.shear_modulus());
    w.poisson_ratio = static_cast<float>(foam.poisson_ratio), w.volume0 = volume0, w.mass = mass;
    const PairKernels* kernels = pair_kernels_of_width(4 << trial % 3);
    (kernels != nullptr ? *kernels : pair_kernels()).strain(w, 0, 2);

    Tensor increment;
    for (int k = 0; k < 9; ++k) increment[k] = dt * rate[k];
    const double compaction = 1.0 - 1.0 / std::pow(stretch[0], 3);
    const Stress now = crush(law, old, increment, compaction);
    // Mid-step and end-of-step rules differ by the square of the step's strain, 0.015² E.
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(stress[c][5] / psi, now[c] / psi, 1.0) << trial << " " << c;
  }
}

}  // namespace
}  // namespace apc::sph
