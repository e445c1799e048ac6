#include "sph_backend/fem/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "apc/base/units.h"

namespace apc::sph::fem {
namespace {

using units::in;

MeshSpec free_block(int columns, int rows, int layers, Integration integration = Integration::one_point) {
  MeshSpec s;
  s.foam = ideal_foam_50psi();
  s.foam.damping = 0.0;
  s.size = 1.0 * in, s.columns = columns, s.half_width = rows * in, s.depth = layers * in;
  s.free_body = true, s.integration = integration;
  s.linear_viscosity = s.quadratic_viscosity = 0.0;
  return s;
}

void advance(Mesh& m) {
  drift(m);
  internal_forces(m);
  kick(m);
}

template <class Field>
void set_velocity(Mesh& m, const Field& field) {
  for (std::size_t n = 0; n < m.mass.size(); ++n)
    field(m.x[0][n], m.x[1][n], m.x[2][n], m.v[0][n], m.v[1][n], m.v[2][n]);
}

/// Moves the nodes inside the block at random, so that no element is a box any more.
void distort(Mesh& m, double by) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-by, by);
  for (int ix = 1; ix < m.nx; ++ix)
    for (int iy = 1; iy < m.ny; ++iy)
      for (int iz = 1; iz < m.nz; ++iz)
        for (auto& x : m.x) x[m.node(ix, iy, iz)] += part(random);
}

class FemMesh : public testing::TestWithParam<Integration> {};

TEST_P(FemMesh, PatchOfDistortedElementsStrainsUniformly) {
  Mesh m = make_mesh(free_block(4, 4, 4, GetParam()));
  distort(m, 0.2 * in);
  const double rate = 2.0, shear = 1.5, e = m.spec.foam.youngs_modulus;
  set_velocity(m, [&](double x, double, double z, double& vx, double&, double& vz) {
    vx = -rate * x + shear * z, vz = 0.5 * rate * z;
  });
  drift(m);
  internal_forces(m);
  for (const Stress& s : m.stress) {
    EXPECT_NEAR(s[0] / (-e * rate * m.dt), 1.0, 2e-3);
    EXPECT_NEAR(s[2] / (0.5 * e * rate * m.dt), 1.0, 2e-3);
    EXPECT_NEAR(s[4] / (0.5 * e * shear * m.dt), 1.0, 2e-3);
    EXPECT_NEAR(s[1] / (e * rate * m.dt), 0.0, 1e-12);
  }
  // Uniform stress is in balance at every inner node, whatever the elements' shapes.
  double largest = 0.0, inner = 0.0;
  for (int ix = 0; ix <= m.nx; ++ix)
    for (int iy = 0; iy <= m.ny; ++iy)
      for (int iz = 0; iz <= m.nz; ++iz) {
        const std::size_t n = m.node(ix, iy, iz);
        const double f = std::hypot(m.force[0][n], m.force[1][n], m.force[2][n]);
        largest = std::max(largest, f);
        if (ix > 0 && ix < m.nx && iy > 0 && iy < m.ny && iz > 0 && iz < m.nz) inner = std::max(inner, f);
      }
  EXPECT_LT(inner, 2e-3 * largest);
}

TEST_P(FemMesh, RigidRotationLeavesStressAndVolumeAlone) {
  Mesh m = make_mesh(free_block(3, 3, 3, GetParam()));
  for (Stress& s : m.stress) s[0] = -1e5;
  const double middle = 1.5 * in;
  const int steps = 200;
  const double turn = 0.5 * std::numbers::pi / steps, dt = m.next_dt;
  for (int k = 0; k < steps; ++k) {
    m.next_dt = dt;
    set_velocity(m, [&](double x, double y, double, double& vx, double& vy, double& vz) {  // to the next place
      const double dx = x - middle, dy = y - middle;
      vx = ((std::cos(turn) - 1.0) * dx - std::sin(turn) * dy) / dt;
      vy = ((std::cos(turn) - 1.0) * dy + std::sin(turn) * dx) / dt;
      vz = 0.0;
    });
    drift(m);
    internal_forces(m);
  }
  for (std::size_t p = 0; p < m.stress.size(); ++p) {
    EXPECT_NEAR(m.stress[p][1], -1e5, 1e-3);  // the principal axis has turned from x to y
    EXPECT_NEAR(m.stress[p][0], 0.0, 1e-3);
    EXPECT_NEAR(m.volume[p] / m.volume0[p], 1.0, 1e-10);
  }
  EXPECT_NEAR(m.energy.internal, 0.0, 1e-9);
}

TEST_P(FemMesh, MomentumAndEnergyAreKept) {
  Mesh m = make_mesh(free_block(6, 5, 4, GetParam()));
  m.spec.cfl = 0.2;
  set_velocity(m, [&](double x, double y, double z, double& vx, double& vy, double& vz) {
    vx = 3.0 * std::sin(40.0 * y), vy = 2.0 * std::cos(35.0 * z), vz = 4.0 * std::sin(50.0 * x);
  });
  double before[3] = {}, start = 0.0;
  for (std::size_t n = 0; n < m.mass.size(); ++n)
    for (int a = 0; a < 3; ++a) before[a] += m.mass[n] * m.v[a][n], start += 0.5 * m.mass[n] * m.v[a][n] * m.v[a][n];
  for (int k = 0; k < 400; ++k) advance(m);
  double after[3] = {}, mass = 0.0;
  for (std::size_t n = 0; n < m.mass.size(); ++n) {
    mass += m.mass[n];
    for (int a = 0; a < 3; ++a) after[a] += m.mass[n] * m.v[a][n];
  }
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(after[a], before[a], 1e-12 * mass * 3.0);
  EXPECT_NEAR(mass, 120 * std::pow(in, 3) * m.spec.foam.density, 1e-12);
  EXPECT_NEAR((m.energy.kinetic + m.energy.internal + m.energy.hourglass) / start, 1.0, 0.01);
  EXPECT_LT(m.energy.kinetic, 0.9 * start);
}

TEST_P(FemMesh, ElasticWaveTravelsAtTheSoundSpeed) {
  // Lowest mode of a column on the rigid plane, top free: v = sin(π z/(2 H)) comes to rest after H/c.
  MeshSpec s = free_block(1, 1, 48, GetParam());
  s.free_body = false, s.mirror_ends = true, s.hold_bottom = false, s.cfl = 0.2;
  Mesh m = make_mesh(s);
  const double wave = 0.5 * std::numbers::pi / s.depth;
  set_velocity(m, [&](double, double, double z, double&, double&, double& vz) { vz = 0.1 * std::sin(wave * z); });
  const auto amplitude = [&] {
    double sum = 0.0;
    for (std::size_t n = 0; n < m.mass.size(); ++n) sum += m.mass[n] * m.v[2][n] * std::sin(wave * m.x[2][n]);
    return sum;
  };
  double before = amplitude(), now = before;
  while (now > 0.0) {
    before = now;
    advance(m);
    now = amplitude();
  }
  const double rest = m.time + m.dt * (0.5 - now / (now - before));
  EXPECT_NEAR(s.depth / rest / s.foam.sound_speed(), 1.0, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Integrations, FemMesh, testing::Values(Integration::one_point, Integration::full),
                         [](const auto& each) { return each.param == Integration::full ? "Full" : "OnePoint"; });

/// Energy after a tenth of a millisecond in a single element that starts in one of its hourglass modes.
MeshEnergy bent(Integration integration, Hourglass control, double factor) {
  MeshSpec s = free_block(1, 1, 1, integration);
  s.hourglass = control, s.hourglass_factor = factor, s.cfl = 0.01;  // kinetic energy is half a step ahead
  Mesh m = make_mesh(s);
  const auto nodes = corner_nodes(m, 0, 0, 0);
  for (int n = 0; n < corners; ++n) m.v[0][nodes[n]] = 0.05 * sign[1][n] * sign[2][n];
  while (m.time < 1e-4) advance(m);
  return m.energy;
}

TEST(FemHourglass, IsUnseenByOnePointAndResistedByEachControl) {
  const MeshEnergy none = bent(Integration::one_point, Hourglass::stiffness, 0.0);
  EXPECT_LT(none.internal, 1e-30);
  const double start = none.kinetic;
  EXPECT_GT(start, 0.0);
  for (const Hourglass control : {Hourglass::stiffness, Hourglass::viscosity}) {
    const MeshEnergy held = bent(Integration::one_point, control, 0.1);
    EXPECT_LT(held.kinetic, 0.8 * start);
    EXPECT_NEAR((held.kinetic + held.hourglass) / start, 1.0, 0.02);
    EXPECT_LT(held.internal, 1e-6 * start);
  }
  const MeshEnergy full = bent(Integration::full, Hourglass::stiffness, 0.0);
  EXPECT_GT(full.internal, 0.2 * start);
  EXPECT_EQ(full.hourglass, 0.0);
}

TEST(FemMesh, CrushedColumnsOutsideTheWindowRest) {
  Mesh m = make_mesh(free_block(8, 2, 2));
  set_velocity(m, [](double, double, double, double& vx, double&, double&) { vx = 1.0; });
  set_active(m, 2, 6);
  const double mass = 32 * std::pow(in, 3) * m.spec.foam.density;
  EXPECT_NEAR(m.energy.removed, 0.5 * mass * (8.0 - 3.0) / 8.0, 1e-9 * mass);
  advance(m);
  EXPECT_EQ(m.x[0][m.node(1, 0, 0)], 1.0 * in);
  EXPECT_GT(m.x[0][m.node(4, 0, 0)], 4.0 * in);
}

}  // namespace
}  // namespace apc::sph::fem
