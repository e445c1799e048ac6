#include "sph_backend/fem/mesh.h"

#include <algorithm>
#include <cmath>

#include "sph_backend/particles.h"

namespace apc::sph::fem {
namespace {

constexpr double flattest = 1e-3;  ///< share of its volume at which an element counts as turned inside out

/// What the elements of one step share, and what they find.
struct Pass {
  Mesh& mesh;
  double fastest = 0.0;  ///< largest 1/Δt² seen
};

struct Local {
  std::array<std::size_t, corners> nodes;
  Corners end, middle, velocity;
};

Local gather(const Mesh& m, int ix, int iy, int iz) {
  Local l;
  l.nodes = corner_nodes(m, ix, iy, iz);
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < corners; ++n) {
      l.end[i][n] = m.x[i][l.nodes[n]], l.velocity[i][n] = m.v[i][l.nodes[n]];
      l.middle[i][n] = l.end[i][n] - 0.5 * m.dt * l.velocity[i][n];
    }
  return l;
}

Tensor velocity_gradient(const Corners& v, const Gradient& g) {
  Tensor t{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int n = 0; n < corners; ++n) t[3 * i + j] += v[i][n] * g.b[j][n];
  return t;
}

double square(const Gradient& g) {
  double sum = 0.0;
  for (const auto& row : g.b)
    for (const double b : row) sum += b * b;
  return sum;
}

/// One integration point: law, work, and its share of the corner forces.
void integrate(Pass& pass, const Local& local, const Gradient& middle, const Gradient& end, std::size_t point,
               Corners& force) {
  Mesh& m = pass.mesh;
  if (!(end.volume > flattest * m.volume0[point]) || !(middle.volume > flattest * m.volume0[point])) {
    ++m.inverted;
    return;
  }
  const Tensor rate = velocity_gradient(local.velocity, middle);
  Tensor increment;
  for (int k = 0; k < 9; ++k) increment[k] = m.dt * rate[k];
  const double ratio = end.volume / m.volume0[point];
  const Stress old = m.stress[point], now = crush(m.law, old, increment, 1.0 - ratio);
  const Stretching d = symmetric_part(rate);
  m.energy.internal += 0.5 * m.dt * (m.volume[point] * inner(old, d) + end.volume * inner(now, d));
  m.stress[point] = now, m.volume[point] = end.volume;

  Stress total = now;
  const double density = m.spec.foam.density / ratio, trace = d[0] + d[1] + d[2];
  const double sound = m.spec.foam.sound_speed() * std::sqrt(ratio), b2 = square(end), length = std::sqrt(0.5 / b2);
  double damped = 0.0;
  if (trace < 0.0) {
    const double q = density * length *
                     (m.spec.quadratic_viscosity * length * trace * trace - m.spec.linear_viscosity * sound * trace);
    for (int k = 0; k < 3; ++k) total[k] -= q;
    m.energy.viscous -= m.dt * end.volume * q * trace;
    damped = m.spec.linear_viscosity - m.spec.quadratic_viscosity * length * trace / sound;
  }
  if (m.law.damping > 0.0) {
    const Stress extra = damping_stress(m.law, d, 1.0 - ratio);
    for (int k = 0; k < 6; ++k) total[k] += extra[k];
    m.energy.damping += m.dt * end.volume * inner(extra, d);
  }
  // Viscosity shortens the step of the undamped bound by √(1 + ζ²) + ζ.
  const double shorter = std::sqrt(1.0 + damped * damped) + damped;
  pass.fastest = std::max(pass.fastest, 2.0 * sound * sound * b2 * shorter * shorter);

  for (int n = 0; n < corners; ++n) {
    const double bx = end.volume * end.b[0][n], by = end.volume * end.b[1][n], bz = end.volume * end.b[2][n];
    force[0][n] -= total[0] * bx + total[3] * by + total[4] * bz;
    force[1][n] -= total[3] * bx + total[1] * by + total[5] * bz;
    force[2][n] -= total[4] * bx + total[5] * by + total[2] * bz;
  }
}

void resist_hourglass(Mesh& m, const Local& local, const Gradient& middle, const Gradient& end, std::size_t e,
                      Corners& force) {
  const MeshSpec& s = m.spec;
  // Rates by the shapes at mid-step, forces by those at the end, as for the stress: else a turning element loses work.
  const HourglassShapes shapes = hourglass_shapes(local.end, end), mid = hourglass_shapes(local.middle, middle);
  auto& q = m.hourglass[e];
  const bool elastic = s.hourglass == Hourglass::stiffness;
  const Foam& foam = s.foam;
  const double modulus = foam.lame_lambda() + 2.0 * foam.shear_modulus();
  const double stiffness = s.hourglass_factor * modulus * end.volume * square(end);
  const double ratio = end.volume / m.volume0[e];
  const double viscosity = s.hourglass_factor * 2.0 * foam.density / std::sqrt(ratio) * foam.sound_speed() *
                           std::cbrt(end.volume * end.volume);
  const Tensor rate = velocity_gradient(local.velocity, middle);
  const double wz = 0.5 * m.dt * (rate[3] - rate[1]), wy = 0.5 * m.dt * (rate[2] - rate[6]),
               wx = 0.5 * m.dt * (rate[7] - rate[5]);
  for (int a = 0; a < modes; ++a) {
    double speed[3] = {};
    for (int i = 0; i < 3; ++i)
      for (int n = 0; n < corners; ++n) speed[i] += local.velocity[i][n] * mid[a][n];
    double* f = &q[3 * a];
    if (elastic) {
      const double turned[3] = {f[0] + wy * f[2] - wz * f[1], f[1] + wz * f[0] - wx * f[2],
                                f[2] + wx * f[1] - wy * f[0]};
      for (int i = 0; i < 3; ++i) {
        const double now = turned[i] + stiffness * m.dt * speed[i];
        m.energy.hourglass += 0.5 * m.dt * (f[i] + now) * speed[i];
        f[i] = now;
      }
    } else {
      for (int i = 0; i < 3; ++i) {
        const double now = viscosity * speed[i];
        m.energy.hourglass += 0.5 * m.dt * (f[i] + now) * speed[i];
        f[i] = now;
      }
    }
    for (int i = 0; i < 3; ++i)
      for (int n = 0; n < corners; ++n) force[i][n] -= f[i] * shapes[a][n];
  }
}

void add_element(Pass& pass, int ix, int iy, int iz) {
  Mesh& m = pass.mesh;
  const Local local = gather(m, ix, iy, iz);
  const std::size_t e = m.element(ix, iy, iz);
  Corners force{};
  if (m.spec.integration == Integration::one_point) {
    const Gradient middle = mean_gradient(local.middle), end = mean_gradient(local.end);
    integrate(pass, local, middle, end, e, force);
    if (m.spec.hourglass_factor > 0.0 && end.volume > flattest * m.volume0[e])
      resist_hourglass(m, local, middle, end, e, force);
  } else {
    for (int p = 0; p < corners; ++p)
      integrate(pass, local, gauss_gradient(local.middle, p), gauss_gradient(local.end, p), corners * e + p, force);
  }
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < corners; ++n) m.force[i][local.nodes[n]] += force[i][n];
}

double step_limit(const Mesh& m, double fastest) { return m.spec.cfl / std::sqrt(fastest); }

}  // namespace

std::array<std::size_t, corners> corner_nodes(const Mesh& m, int ix, int iy, int iz) {
  std::array<std::size_t, corners> nodes;
  for (int n = 0; n < corners; ++n)
    nodes[n] = m.node(ix + (sign[0][n] > 0), iy + (sign[1][n] > 0), iz + (sign[2][n] > 0));
  return nodes;
}

Mesh make_mesh(const MeshSpec& spec) {
  Mesh m;
  m.spec = spec;
  m.law = crush_law(spec.foam, spec.size);
  m.nx = spec.columns;
  m.ny = std::max(1, static_cast<int>(std::lround(spec.half_width / spec.size)));
  m.nz = std::max(1, static_cast<int>(std::lround(spec.depth / spec.size)));
  m.layer = spec.depth / m.nz, m.half_width = m.ny * spec.size;
  const std::size_t nodes = static_cast<std::size_t>(m.nx + 1) * (m.ny + 1) * (m.nz + 1);
  const std::size_t elements = static_cast<std::size_t>(m.nx) * m.ny * m.nz;
  for (int a = 0; a < 3; ++a) m.x[a].resize(nodes), m.v[a].assign(nodes, 0.0), m.force[a].assign(nodes, 0.0);
  m.mass.assign(nodes, 0.0), m.boundary_hold.assign(nodes, free_to_move);
  for (int ix = 0; ix <= m.nx; ++ix)
    for (int iy = 0; iy <= m.ny; ++iy)
      for (int iz = 0; iz <= m.nz; ++iz) {
        const std::size_t n = m.node(ix, iy, iz);
        m.x[0][n] = (spec.first_column + ix) * spec.size, m.x[1][n] = iy * spec.size, m.x[2][n] = iz * m.layer;
        if (iz == m.nz) m.surface.push_back(static_cast<std::uint32_t>(n));
        if (spec.free_body) continue;
        std::uint8_t& hold = m.boundary_hold[n];
        if (iy == 0 || (iy == m.ny && spec.outer_wall)) hold |= hold_y;
        if (iz == 0) hold |= spec.hold_bottom ? hold_all : hold_z;
        if (spec.mirror_ends && (ix == 0 || ix == m.nx)) hold |= hold_x;
      }
  m.hold = m.boundary_hold;
  const int points = m.points();
  m.stress.assign(points * elements, Stress{});
  m.volume.assign(points * elements, spec.size * spec.size * m.layer / points);
  m.volume0 = m.volume;
  m.hourglass.assign(elements, {});
  const double share = spec.foam.density * spec.size * spec.size * m.layer / corners;
  for (int ix = 0; ix < m.nx; ++ix)
    for (int iy = 0; iy < m.ny; ++iy)
      for (int iz = 0; iz < m.nz; ++iz)
        for (const std::size_t n : corner_nodes(m, ix, iy, iz)) m.mass[n] += share;
  m.active_end = m.nx;
  // A full element sees its Gauss points: the first step is measured on the undeformed one.
  Corners first;
  const auto nodes0 = corner_nodes(m, 0, 0, 0);
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < corners; ++n) first[i][n] = m.x[i][nodes0[n]];
  const double b2 = square(points == 1 ? mean_gradient(first) : gauss_gradient(first, 0));
  const double c = spec.foam.sound_speed(), zeta = spec.linear_viscosity, shorter = std::sqrt(1.0 + zeta * zeta) + zeta;
  m.next_dt = step_limit(m, 2.0 * c * c * b2 * shorter * shorter);
  return m;
}

void set_active(Mesh& m, int first_column, int end_column) {
  m.active_first = std::clamp(first_column - m.spec.first_column, 0, m.nx);
  m.active_end = std::clamp(end_column - m.spec.first_column, m.active_first, m.nx);
  for (int ix = 0; ix <= m.nx; ++ix) {
    const bool moves = ix > m.active_first && ix < m.active_end;
    for (std::size_t n = m.node(ix, 0, 0); n < m.node(ix + 1, 0, 0); ++n) {
      if (!moves && m.hold[n] != hold_all) {
        m.energy.removed += 0.5 * m.mass[n] * (m.v[0][n] * m.v[0][n] + m.v[1][n] * m.v[1][n] + m.v[2][n] * m.v[2][n]);
        for (auto& v : m.v) v[n] = 0.0;
      }
      m.hold[n] = moves ? m.boundary_hold[n] : std::uint8_t{hold_all};
    }
  }
}

void drift(Mesh& m) {
  m.dt = m.next_dt;
  m.time += m.dt;
  const std::size_t first = m.node(m.active_first, 0, 0), end = m.node(m.active_end + 1, 0, 0);
  for (int a = 0; a < 3; ++a)
    for (std::size_t n = first; n < end; ++n) m.x[a][n] += m.dt * m.v[a][n];
}

void internal_forces(Mesh& m) {
  const std::size_t first = m.node(m.active_first, 0, 0), end = m.node(m.active_end + 1, 0, 0);
  for (auto& f : m.force) std::fill(f.begin() + first, f.begin() + end, 0.0);
  m.inverted = 0;
  Pass pass{m};
  for (int ix = m.active_first; ix < m.active_end; ++ix)
    for (int iy = 0; iy < m.ny; ++iy)
      for (int iz = 0; iz < m.nz; ++iz) add_element(pass, ix, iy, iz);
  ++m.steps, m.element_steps += static_cast<std::int64_t>(m.active_end - m.active_first) * m.ny * m.nz;
  // The step may shrink at once but grows slowly, so that two neighbouring steps hardly differ.
  m.next_dt = std::min(step_limit(m, pass.fastest), 1.02 * m.dt);
  m.kick_dt = 0.5 * (m.dt + m.next_dt);
}

void kick(Mesh& m) {
  double twice = 0.0;
  const std::size_t first = m.node(m.active_first, 0, 0), end = m.node(m.active_end + 1, 0, 0);
  for (std::size_t n = first; n < end; ++n) {
    const std::uint8_t hold = m.hold[n];
    if (hold == hold_all) continue;
    const double f = m.kick_dt / m.mass[n];
    if (!(hold & hold_x)) m.v[0][n] += f * m.force[0][n];
    if (!(hold & hold_y)) m.v[1][n] += f * m.force[1][n];
    if (!(hold & hold_z)) m.v[2][n] += f * m.force[2][n];
    twice += m.mass[n] * (m.v[0][n] * m.v[0][n] + m.v[1][n] * m.v[1][n] + m.v[2][n] * m.v[2][n]);
  }
  m.energy.kinetic = 0.5 * twice;
}

ContactPoints contact_points(const Mesh& m) {
  ContactPoints points;
  const std::size_t column = static_cast<std::size_t>(m.ny) + 1;
  points.which = m.surface.data() + m.active_first * column;
  points.count = (m.active_end - m.active_first + 1) * column;
  points.x = m.x[0].data(), points.y = m.x[1].data(), points.z = m.x[2].data();
  points.vx = m.v[0].data(), points.vy = m.v[1].data(), points.vz = m.v[2].data();
  points.stiffness = 2.0 * m.spec.foam.youngs_modulus * m.spec.size;
  points.mass = 0.25 * m.spec.foam.density * m.spec.size * m.spec.size * m.layer;  // a node on the symmetry plane
  points.dt = m.kick_dt;
  return points;
}

double largest_compaction(const Mesh& m) {
  double most = 0.0;
  for (std::size_t p = 0; p < m.volume.size(); ++p) most = std::max(most, 1.0 - m.volume[p] / m.volume0[p]);
  return most;
}

}  // namespace apc::sph::fem
