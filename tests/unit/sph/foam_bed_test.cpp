#include "sph_backend/foam_bed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "cases.h"

namespace apc::sph {
namespace {

using testing::free_block;

void advance(Bed& bed) {
  drift(bed);
  strain(bed);
  accelerate(bed);
  kick(bed);
}

template <class Field>
void set_velocity(Bed& bed, const Field& field) {
  Particles& p = bed.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.id[i] >= 0) field(p.x[i], p.y[i], p.z[i], p.vx[i], p.vy[i], p.vz[i]);
}

std::uint64_t digest(const Bed& bed) {
  std::uint64_t hash = 1469598103934665603ull;
  for (const auto* v : {&bed.particles.x, &bed.particles.vz})
    for (const double d : *v) {
      std::uint64_t bits;
      std::memcpy(&bits, &d, sizeof bits);
      hash = (hash ^ bits) * 1099511628211ull;
    }
  return hash;
}

TEST(FoamBed, LinearVelocityFieldStrainsTheInteriorUniformly) {
  // Patch test: v = G x, with G of pure compression and shear; one step of density and stress.
  Bed bed = make_bed(free_block(12, 12, 12));
  const double rate = 1.0, shear = 0.7, middle = 6.0 * units::in;
  set_velocity(bed, [&](double x, double, double z, double& vx, double&, double& vz) {
    vx = -rate * (x - middle) + shear * (z - middle), vz = 0.0;
  });
  drift(bed);
  strain(bed);
  const Particles& p = bed.particles;
  const double e = bed.spec.foam.youngs_modulus;
  int inside = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double reach = 3.0 * units::in;
    if (p.id[i] < 0 || std::abs(p.x[i] - middle) > reach || std::abs(p.y[i] - middle) > reach ||
        std::abs(p.z[i] - middle) > reach)
      continue;
    ++inside;
    EXPECT_NEAR(3.0 * std::log(p.stretch[i]) / (rate * bed.dt), 1.0, 0.03);
    EXPECT_NEAR(p.stress[0][i] / (-e * rate * bed.dt), 1.0, 0.03);
    EXPECT_NEAR(p.stress[4][i] / (0.5 * e * shear * bed.dt), 1.0, 0.03);
    EXPECT_NEAR(p.stress[1][i] / (e * rate * bed.dt), 0.0, 0.005);
  }
  EXPECT_GT(inside, 100);
}

TEST(FoamBed, RigidRotationLeavesStressAndDensityAlone) {
  Bed bed = make_bed(free_block(8, 8, 8));
  const double omega = 20.0, middle = 4.0 * units::in, prestress = -1e5, turn = omega * bed.dt;
  const auto on_a_circle = [&](double x, double y, double, double& vx, double& vy, double&) {  // to the next position
    const double dx = x - middle, dy = y - middle;
    vx = ((std::cos(turn) - 1.0) * dx - std::sin(turn) * dy) / bed.dt;
    vy = ((std::cos(turn) - 1.0) * dy + std::sin(turn) * dx) / bed.dt;
  };
  for (auto& s : bed.particles.stress[0]) s = static_cast<float>(prestress);
  Particles& p = bed.particles;
  for (int k = 0; k < static_cast<int>(0.5 * 3.14159265 / turn); ++k) {  // a quarter turn
    set_velocity(bed, on_a_circle);
    drift(bed);
    strain(bed);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0) continue;
    const double r = std::hypot(p.x[i] - middle, p.y[i] - middle);
    if (r > 1.5 * units::in || std::abs(p.z[i] - middle) > 1.5 * units::in) continue;
    EXPECT_NEAR(p.stretch[i], 1.0, 2e-3);
    EXPECT_NEAR(p.stress[1][i] / prestress, 1.0, 0.02);  // the principal axis has turned from x to y
    EXPECT_NEAR(p.stress[0][i] / prestress, 0.0, 0.02);
  }
}

/// Mass form and volume form of the pair sums.
class FoamBedForm : public ::testing::TestWithParam<PairForm> {};
INSTANTIATE_TEST_SUITE_P(Forms, FoamBedForm, ::testing::Values(PairForm::mass, PairForm::volume),
                         [](const auto& form) { return form.param == PairForm::mass ? "Mass" : "Volume"; });

TEST_P(FoamBedForm, MomentumIsConservedByThePairForces) {
  BedSpec spec = free_block(9, 7, 8);
  spec.form = GetParam();
  Bed bed = make_bed(spec);
  bed.spec.alpha = 0.5, bed.spec.beta = 2.0;
  set_velocity(bed, [](double x, double y, double z, double& vx, double& vy, double& vz) {
    vx = 3.0 * std::sin(40.0 * y), vy = 2.0 * std::cos(35.0 * z), vz = 4.0 * std::sin(50.0 * x);
  });
  const auto momentum = [&](int axis) {
    const auto& v = axis == 0 ? bed.particles.vx : axis == 1 ? bed.particles.vy : bed.particles.vz;
    double sum = 0.0;
    for (const double one : v) sum += one;
    return bed.mass * sum;
  };
  const double before[3] = {momentum(0), momentum(1), momentum(2)};
  for (int k = 0; k < 200; ++k) advance(bed);
  const double scale = bed.mass * bed.alive * 3.0;
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(momentum(a), before[a], 1e-6 * scale);
}

TEST_P(FoamBedForm, EnergyAccountClosesWhileABlockRings) {
  BedSpec spec = free_block(10, 6, 6);
  spec.form = GetParam();
  Bed bed = make_bed(spec);
  const double middle = 5.0 * units::in;
  set_velocity(bed, [&](double x, double, double, double& vx, double&, double&) { vx = -2.0 * (x - middle) / middle; });
  kick(bed);
  const double start = bed.energy.kinetic;
  for (int k = 0; k < 400; ++k) advance(bed);
  const double now = bed.energy.kinetic + bed.energy.internal + bed.energy.viscous;
  EXPECT_NEAR(now / start, 1.0, 0.01);
  EXPECT_LT(bed.energy.kinetic, start);
}

TEST(FoamBed, ElasticWaveTravelsAtTheSoundSpeed) {
  // Lowest mode of a column on the rigid plane, top free: v = sin(π z/(2 H)) comes to rest after H/c.
  BedSpec s;
  s.foam = ideal_foam_50psi();
  s.spacing = 1.0 * units::in, s.columns = 4, s.half_width = 4.0 * units::in, s.depth = 48.0 * units::in;
  s.hold_bottom = false, s.mirror_ends = true, s.alpha = s.beta = 0.0, s.cfl = 0.1;
  Bed bed = make_bed(s);
  const double wave = 0.5 * 3.14159265 / s.depth;
  set_velocity(bed, [&](double, double, double z, double&, double&, double& vz) { vz = 0.1 * std::sin(wave * z); });
  const auto amplitude = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < bed.particles.size(); ++i)
      if (bed.particles.id[i] >= 0) sum += bed.particles.vz[i] * std::sin(wave * bed.particles.z[i]);
    return sum;
  };
  double before = amplitude(), now = before;
  while (now > 0.0) {
    before = now;
    advance(bed);
    now = amplitude();
  }
  const double rest = bed.time + bed.dt * (0.5 - now / (now - before));
  EXPECT_NEAR(s.depth / rest / s.foam.sound_speed(), 0.985,
              0.015);  // the kernel's first moment on the lattice is 0.985
  EXPECT_NEAR(s.foam.sound_speed() / units::in, 7303.0, 5.0);
}

TEST(FoamBed, TensionStaysBelowTheCutoff) {
  Bed bed = make_bed(free_block(8, 8, 8));
  const double middle = 4.0 * units::in;
  set_velocity(bed, [&](double x, double, double, double& vx, double&, double&) { vx = 60.0 * (x - middle); });
  const Particles& p = bed.particles;
  double highest = 0.0;
  for (int k = 0; k < 150; ++k) {
    advance(bed);
    for (const auto& normal : {&p.stress[0], &p.stress[1], &p.stress[2]})
      for (const float stress : *normal) highest = std::max(highest, static_cast<double>(stress));
  }
  EXPECT_LE(highest, 1.001 * bed.spec.foam.tension_cutoff);
  EXPECT_GT(highest, 0.9 * bed.spec.foam.tension_cutoff);
}

TEST_P(FoamBedForm, SameBitsForAnyNumberOfThreads) {
  const auto run = [](unsigned threads) {
    BedSpec s = free_block(14, 8, 8);
    s.free_body = false, s.form = GetParam(), s.threads = threads;
    Bed bed = make_bed(s);
    set_velocity(bed, [](double x, double, double z, double& vx, double&, double& vz) {
      vx = 20.0 * std::sin(20.0 * z), vz = -30.0 * x;
    });
    for (int k = 0; k < 120; ++k) advance(bed);
    return digest(bed);
  };
  const auto one = run(1);
  EXPECT_EQ(run(2), one);
  EXPECT_EQ(run(3), one);
}

}  // namespace
}  // namespace apc::sph
