#include "sph_backend/tire_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sph_backend/team.h"

namespace apc::sph {
namespace {

/// Deflection and its slopes at material angle φ and lateral place y (bilinear), with the weights of the four nodes.
struct Deflection {
  double u, du_dphi, du_dy;
  std::size_t nodes[4];
  double weights[4];
};

Deflection deflection_at(const Tire& tire, double phi, double y) {
  const double dphi = 2.0 * std::numbers::pi / tire.grid.around, dy = tire.outline.lateral / tire.grid.across;
  double turn = phi / dphi;
  turn -= std::floor(turn / tire.grid.around) * tire.grid.around;
  const int i = std::min(static_cast<int>(turn), tire.grid.around - 1), next = i + 1 == tire.grid.around ? 0 : i + 1;
  const double place = std::min(y / dy, static_cast<double>(tire.grid.across));
  const int j = std::min(static_cast<int>(place), tire.grid.across - 1);
  const double f = turn - i, g = place - j;
  Deflection d;
  d.nodes[0] = tire.node(i, j), d.nodes[1] = tire.node(next, j);
  d.nodes[2] = tire.node(i, j + 1), d.nodes[3] = tire.node(next, j + 1);
  d.weights[0] = (1 - f) * (1 - g), d.weights[1] = f * (1 - g), d.weights[2] = (1 - f) * g, d.weights[3] = f * g;
  const double u0 = tire.u[d.nodes[0]], u1 = tire.u[d.nodes[1]], u2 = tire.u[d.nodes[2]], u3 = tire.u[d.nodes[3]];
  d.u = d.weights[0] * u0 + d.weights[1] * u1 + d.weights[2] * u2 + d.weights[3] * u3;
  d.du_dphi = ((u1 - u0) * (1 - g) + (u3 - u2) * g) / dphi;
  d.du_dy = place >= tire.grid.across ? 0.0 : ((u2 - u0) * (1 - f) + (u3 - u1) * f) / dy;
  return d;
}

/// Inverse mass of the tread where it is touched, 1/kg: velocity that a unit impulse gives to the place itself.
double mobility(const Tire& tire, const Deflection& d) {
  double sum = 0.0;
  if (tire.rigid) return sum;
  const std::size_t lines = tire.grid.across + 1;
  for (int m = 0; m < 4; ++m) {
    const std::size_t line = d.nodes[m] % lines;
    if (line + 1 < lines) sum += d.weights[m] * d.weights[m] / tire.mass[line];
  }
  return sum;
}

/// Appends to `touches` what the points [first, last) do in contact.
void touch(const ContactPoints& p, const Tire& tire, const AxleState& axle, const ContactLaw& law, std::size_t first,
           std::size_t last, std::vector<Touch>& touches) {
  const double outer = 0.5 * tire.shape.diameter + p.reach, side = tire.outline.lateral + p.reach;
  const double k = p.stiffness;
  for (std::size_t n = first; n < last; ++n) {
    const std::size_t i = p.which != nullptr ? p.which[n] : n;
    const double dx = p.x[i] - axle.x, dz = p.z[i] - axle.z, r2 = dx * dx + dz * dz;
    if (r2 > outer * outer || p.y[i] > side || (p.id != nullptr && p.id[i] < 0)) continue;
    const double reach = p.radius(p.stretch, i), y = std::abs(p.y[i]);
    const double r = std::max(std::sqrt(r2), 1e-9);
    const double er_x = dx / r, er_z = dz / r, ea_x = -er_z, ea_z = er_x;  // α from downwards towards +x
    const Deflection d = deflection_at(tire, std::atan2(dx, -dz) + tire.angle, y);
    const SectionPoint s = tire.outline.at(r - tire.outline.centre + d.u, y);
    const double overlap = reach - s.distance;
    if (overlap <= 0.0) continue;

    Touch t;
    t.particle = static_cast<std::uint32_t>(i);
    t.overlap = overlap, t.radius = r, t.normal_radial = s.normal_radial;
    t.e_radial[0] = er_x, t.e_radial[1] = er_z;
    std::copy(d.nodes, d.nodes + 4, t.nodes), std::copy(d.weights, d.weights + 4, t.weights);
    const double along = s.normal_radial * d.du_dphi / r;
    t.gradient[0] = s.normal_radial * er_x + along * ea_x;
    t.gradient[1] = s.normal_lateral + s.normal_radial * d.du_dy;
    t.gradient[2] = s.normal_radial * er_z + along * ea_z;

    // Velocity relative to the rigidly turning wheel, and to its deflecting surface.
    const double rel[3] = {p.vx[i] - axle.vx + tire.spin * r * ea_x, p.vy[i], p.vz[i] - axle.vz + tire.spin * r * ea_z};
    double sinking = 0.0;
    for (int m = 0; m < 4; ++m) sinking += d.weights[m] * tire.rate[d.nodes[m]];
    const double gap_rate =
        t.gradient[0] * rel[0] + t.gradient[1] * rel[1] + t.gradient[2] * rel[2] + s.normal_radial * sinking;
    // What moves when the gap opens, and when the two slip: the point, and the tread as far as that is radial.
    const double size2 = t.gradient[0] * t.gradient[0] + t.gradient[1] * t.gradient[1] + t.gradient[2] * t.gradient[2];
    const double radial2 = s.normal_radial * s.normal_radial, tread = mobility(tire, d);
    const double normal_mass = 1.0 / (size2 / p.mass + radial2 * tread);
    const double tangent_mass = 1.0 / (1.0 / p.mass + std::max(1.0 - radial2 / size2, 0.0) * tread);
    t.elastic = k * overlap, t.gap_rate = gap_rate;
    t.damping = std::max(-2.0 * law.damping_ratio * std::sqrt(k * normal_mass) * gap_rate, -t.elastic);
    const double normal = t.elastic + t.damping;

    const double size = std::sqrt(size2);
    const double slip[3] = {rel[0] + sinking * er_x, rel[1], rel[2] + sinking * er_z};
    double through = 0.0;
    for (int a = 0; a < 3; ++a) through += slip[a] * t.gradient[a] / size;
    double tangent[3], speed2 = 0.0;
    for (int a = 0; a < 3; ++a) {
      tangent[a] = slip[a] - through * t.gradient[a] / size;
      speed2 += tangent[a] * tangent[a];
    }
    // Never more than would stop a third of the slip within the step: keeps light partners from being shaken.
    const double drag =
        std::min(law.friction * normal * size / std::max(std::sqrt(speed2), law.slip_speed), 0.3 * tangent_mass / p.dt);
    for (int a = 0; a < 3; ++a) {
      t.friction[a] = -drag * tangent[a];
      t.force[a] = normal * t.gradient[a] + t.friction[a];
    }
    touches.push_back(t);
  }
}

/// What one touch does to the tire.
void react(const Touch& t, Tire& tire, ContactResult& result) {
  const double ea_x = -t.e_radial[1], ea_z = t.e_radial[0], normal = t.elastic + t.damping;
  const double friction_radial = t.friction[0] * t.e_radial[0] + t.friction[2] * t.e_radial[1];
  for (int m = 0; m < 4; ++m) tire.force[t.nodes[m]] += t.weights[m] * (normal * t.normal_radial + friction_radial);
  result.force_x -= t.force[0], result.force_z -= t.force[2];
  result.torque += t.radius * (t.force[0] * ea_x + t.force[2] * ea_z);
}

}  // namespace

void find_contact(const ContactPoints& p, Tire& tire, const AxleState& axle, const ContactLaw& law,
                  ContactResult& result) {
  result.force_x = result.force_z = result.torque = 0.0;
  result.touches.clear();
  std::fill(tire.force.begin(), tire.force.end(), 0.0);
  if (p.team == nullptr) {
    touch(p, tire, axle, law, 0, p.count, result.touches);
  } else {
    constexpr std::size_t piece = 256;
    result.parts.resize((p.count + piece - 1) / piece);
    p.team->run(static_cast<int>(result.parts.size()), 4, [&](int first, int last) {
      for (int k = first; k < last; ++k) {
        result.parts[k].clear();
        touch(p, tire, axle, law, k * piece, std::min((k + 1) * piece, p.count), result.parts[k]);
      }
    });
    for (const auto& part : result.parts) result.touches.insert(result.touches.end(), part.begin(), part.end());
  }
  for (const Touch& t : result.touches) react(t, tire, result);
}

double longest_step(const ContactPoints& points, const Tire& tire, const ContactLaw& law) {
  if (tire.rigid) return std::numeric_limits<double>::infinity();
  double lightest = 2.0 * tire.mass[0];  // the other half of the first line is the mirror's
  for (int j = 1; j < tire.grid.across; ++j) lightest = std::min(lightest, tire.mass[j]);
  const double zeta = law.damping_ratio;
  return (std::hypot(1.0, zeta) - zeta) / std::sqrt(points.stiffness * (1.0 / points.mass + 1.0 / lightest));
}

ContactWork book_contact(const ContactPoints& p, const AxleState& axle, const ContactResult& result,
                         const std::vector<double>& before, const float* stretch_before, double mean_spin,
                         const std::vector<double>& mean_rate) {
  ContactWork work;
  for (std::size_t n = 0; n < result.touches.size(); ++n) {
    const Touch& t = result.touches[n];
    const std::size_t i = t.particle;
    const double ea[2] = {-t.e_radial[1], t.e_radial[0]};
    const double rel[3] = {0.5 * (p.vx[i] + before[3 * n]) - axle.vx + mean_spin * t.radius * ea[0],
                           0.5 * (p.vy[i] + before[3 * n + 1]),
                           0.5 * (p.vz[i] + before[3 * n + 2]) - axle.vz + mean_spin * t.radius * ea[1]};
    double sinking = 0.0;
    for (int m = 0; m < 4; ++m) sinking += t.weights[m] * mean_rate[t.nodes[m]];
    const double gap_rate =
        t.gradient[0] * rel[0] + t.gradient[1] * rel[1] + t.gradient[2] * rel[2] + t.normal_radial * sinking;
    work.on_axle += p.dt * (t.force[0] * axle.vx + t.force[2] * axle.vz);
    work.penalty += 0.5 * p.stiffness * t.overlap * t.overlap;
    work.damping -= p.dt * t.damping * gap_rate;
    work.friction -= p.dt * (t.friction[0] * (rel[0] + sinking * t.e_radial[0]) + t.friction[1] * rel[1] +
                             t.friction[2] * (rel[2] + sinking * t.e_radial[1]));
    // At the mean of the overlaps before and after the radius changed.
    const double shrunk = p.radius(stretch_before, i) - p.radius(p.stretch, i);
    const double overlap_before = std::max(t.overlap + p.dt * t.gap_rate + shrunk, 0.0);
    work.radius += 0.5 * p.stiffness * (t.overlap + overlap_before) * shrunk;
  }
  return work;
}

void touched_velocities(const ContactPoints& p, const ContactResult& result, std::vector<double>& out) {
  out.clear();
  for (const Touch& t : result.touches)
    for (const double* v : {p.vx, p.vy, p.vz}) out.push_back(v[t.particle]);
}

}  // namespace apc::sph
