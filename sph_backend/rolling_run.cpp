#include "sph_backend/rolling_run.h"

#include <algorithm>
#include <cmath>

namespace apc::sph {
namespace {

struct Columns {
  int first, end;
};

/// Columns that exist when the axle is at `axle_x`; behind it the block made for pressing stays until it is left
/// behind.
Columns window(const RollingRun& run, double axle_x) {
  const RollingCase& c = run.setup;
  const int held = BedSpec{}.held_columns;
  const double press_behind = -c.ahead, roll_behind = axle_x - c.behind;
  return {
      static_cast<int>(std::floor((axle_x <= 0.0 ? press_behind : std::max(press_behind, roll_behind)) / c.spacing)) -
          held,
      static_cast<int>(std::ceil((axle_x + c.ahead) / c.spacing)) + held};
}

/// Tread: leapfrog like the foam. Returns the damping work.
double kick_tire(Tire& tire, double dt, std::vector<double>& mean_rate) {
  mean_rate.assign(tire.u.size(), 0.0);
  if (tire.rigid) return 0.0;
  static thread_local std::vector<double> elastic;
  elastic_force(tire, elastic);
  double damped = 0.0;
  const double half = 0.5 * dt * tire.damping;
  for (int i = 0; i < tire.grid.around; ++i)
    for (int j = 0; j < tire.grid.across; ++j) {
      const std::size_t n = tire.node(i, j);
      const double push = (tire.force[n] + elastic[n]) / tire.mass[j];
      const double next = ((1.0 - half) * tire.rate[n] + dt * push) / (1.0 + half);
      mean_rate[n] = 0.5 * (tire.rate[n] + next);
      damped += dt * tire.damping * tire.mass[j] * mean_rate[n] * mean_rate[n];
      tire.rate[n] = next;
    }
  return damped;
}

void sample(RollingRun& run, const AxleState& axle) {
  RollingSums& s = run.sums;
  s.drag -= 2.0 * run.contact.force_x, s.vertical += 2.0 * run.contact.force_z;
  s.spin += run.tire.spin * run.radius() / std::max(axle.vx, 1e-9);
  double deepest = 0.0;
  for (int i = 0; i < run.tire.grid.around; ++i) deepest = std::max(deepest, run.tire.u[run.tire.node(i, 0)]);
  s.deflection += deepest;
  s.steps += 1.0, s.distance += axle.vx * run.bed.dt;
  if (s.distance < run.bin()) return;
  RollingHistory& h = run.history;
  h.time.push_back(run.bed.time), h.distance.push_back(axle.x);
  h.drag.push_back(s.drag / s.steps), h.vertical.push_back(s.vertical / s.steps);
  h.spin_ratio.push_back(s.spin / s.steps), h.deflection.push_back(s.deflection / s.steps);
  run.internal.push_back(run.bed.energy.internal);
  s = {};
}

}  // namespace

RollingRun start_run(const RollingCase& setup, unsigned threads) {
  RollingRun run;
  run.setup = setup;
  run.tire = setup.rigid_roller ? make_roller(setup.tire, setup.bed_half_width) : make_tire(setup.tire);
  const double radius = 0.5 * setup.tire.diameter;
  run.path.start_height = setup.bed_depth + radius;
  run.path.end_height = setup.bed_depth - setup.penetration + radius;
  run.path.press_time = 1.875 * setup.penetration / setup.press_speed;
  run.path.accelerate_time = 2.0 * setup.accelerate_distance / setup.speed;
  run.path.speed = setup.speed;
  run.path.fall = setup.fall, run.path.fall_from = setup.accelerate_distance + 2.0 * setup.window;
  run.path.release_spin = setup.release_spin_ratio * setup.speed / radius;
  run.law.friction = setup.friction;
  run.law.slip_speed = 0.02 * setup.speed;

  BedSpec bed;
  bed.foam = setup.foam;
  bed.spacing = setup.spacing, bed.depth = setup.bed_depth, bed.half_width = setup.bed_half_width;
  bed.outer_wall = setup.outer_wall;
  bed.alpha = setup.alpha, bed.beta = setup.beta, bed.cfl = setup.cfl;
  bed.speed = std::max(setup.speed, setup.press_speed), bed.threads = threads;
  const Columns columns = window(run, 0.0);
  bed.first_column = columns.first;
  bed.columns = columns.end - columns.first;
  run.bed = make_bed(bed);
  return run;
}

void step(RollingRun& run) {
  Bed& bed = run.bed;
  Tire& tire = run.tire;
  const double dt = bed.dt;
  static thread_local std::vector<float> stretch_before;
  static thread_local std::vector<double> before, mean_rate;

  // Positions.
  const AxleState axle = run.path.at(bed.time + dt);
  if (const Columns c = window(run, axle.x);
      c.end > bed.spec.first_column + bed.spec.columns || c.first > bed.spec.first_column)
    move_window(bed, c.first, c.end);
  drift(bed);
  tire.angle += dt * tire.spin;
  for (std::size_t n = 0; n < tire.u.size(); ++n) tire.u[n] += dt * tire.rate[n];

  // Forces.
  stretch_before = bed.particles.stretch;
  strain(bed);
  accelerate(bed);
  apply_contact(bed, tire, axle, run.law, run.contact);
  before.clear();
  for (const Touch& t : run.contact.touches)
    for (const auto* v : {&bed.particles.vx, &bed.particles.vy, &bed.particles.vz}) before.push_back((*v)[t.particle]);

  // Velocities.
  kick(bed);
  EnergyAccount& e = run.energy;
  e.tire_damping += kick_tire(tire, dt, mean_rate);
  const double old_spin = tire.spin, inertia = tire.wheel_inertia;
  if (bed.time < run.path.release_time()) {
    tire.spin = run.path.spin(bed.time + 0.5 * dt);
    e.spin_work += (inertia * (tire.spin - old_spin) - dt * run.contact.torque) * 0.5 * (old_spin + tire.spin);
  } else {
    tire.spin += dt * run.contact.torque / inertia;
  }

  // Account.
  const ContactWork w = book_contact(bed, tire, axle, run.law, run.contact, before, stretch_before,
                                     0.5 * (old_spin + tire.spin), mean_rate);
  e.axle_work += w.on_axle;
  e.friction += w.friction, e.contact_damping += w.damping, e.contact_radius += w.radius;
  e.contact_penalty = w.penalty + bed.energy.floor;
  e.foam_internal = bed.energy.internal, e.foam_kinetic = bed.energy.kinetic, e.viscosity = bed.energy.viscous;
  e.foam_damping = bed.energy.damping, e.removed = bed.energy.removed;
  e.wheel_kinetic = 0.5 * inertia * tire.spin * tire.spin;
  if (axle.vx > 0.0) sample(run, axle);
}

double surface_behind(const RollingRun& run) {
  // Highest crushed particle on the centreline in a slice that the tire has left; loose fragments lie above it.
  const Particles& p = run.bed.particles;
  const double dx = run.setup.spacing, at = run.path.at(run.bed.time).x - 0.55 * run.radius();
  double top = -1.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0 || std::abs(p.x[i] - at) > dx || p.y[i] > 0.25 * run.setup.tire.width) continue;
    const double s = p.stretch[i], ratio = 1.0 / (s * s * s);
    if (ratio < 0.7) top = std::max(top, p.z[i] + 0.5 * run.bed.layer * ratio);
  }
  return top < 0.0 ? run.setup.bed_depth : top;
}

}  // namespace apc::sph
