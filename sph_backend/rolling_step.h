/// One step of a tire and the foam under it, for any block of foam: particles or elements. `Run` has the members of
/// RollingRun; its `bed` answers, found by the namespace of its type: next_step, drift, find_forces, contact_points,
/// stretches (null without radius), push, kick, and its window follows by follow(run, axle).
#pragma once

#include "sph_backend/rolling_history.h"

namespace apc::sph {

template <class Run>
void step_tire_and_foam(Run& run) {
  auto& bed = run.bed;
  Tire& tire = run.tire;
  static thread_local std::vector<float> stretch_before;
  static thread_local std::vector<double> before, mean_rate;

  // Positions.
  const double travel_dt = next_step(bed);
  const AxleState axle = run.path.at(bed.time + travel_dt);
  follow(run, axle);
  drift(bed);
  tire.angle += travel_dt * tire.spin;
  for (std::size_t n = 0; n < tire.u.size(); ++n) tire.u[n] += travel_dt * tire.rate[n];

  // Forces.
  const auto* stretch = stretches(bed);
  if (stretch != nullptr) stretch_before = *stretch;
  find_forces(bed);
  const ContactPoints points = contact_points(bed);
  find_contact(points, tire, axle, run.law, run.contact);
  for (const Touch& t : run.contact.touches) push(bed, t.particle, t.force[0], t.force[1], t.force[2]);
  touched_velocities(points, run.contact, before);

  // Velocities.
  const double dt = points.dt;
  kick(bed);
  EnergyAccount& e = run.energy;
  e.tire_damping += kick_tire(tire, dt, mean_rate);
  const double old_spin = tire.spin, inertia = tire.wheel_inertia;
  if (run.path.spin_is_prescribed(bed.time)) {
    tire.spin = run.path.spin(bed.time + 0.5 * dt);
    e.spin_work += (inertia * (tire.spin - old_spin) - dt * run.contact.torque) * 0.5 * (old_spin + tire.spin);
  } else {
    tire.spin += dt * run.contact.torque / inertia;
  }

  // Account.
  const ContactWork w =
      book_contact(points, axle, run.contact, before, stretch != nullptr ? stretch_before.data() : nullptr,
                   0.5 * (old_spin + tire.spin), mean_rate);
  e.axle_work += w.on_axle;
  e.friction += w.friction, e.contact_damping += w.damping, e.contact_radius += w.radius;
  e.contact_penalty = w.penalty;
  book_energy(bed, e);
  e.wheel_kinetic = 0.5 * inertia * tire.spin * tire.spin;
  if (axle.vx > 0.0)
    sample(run.sums, run.history, run.internal, run.bin(), dt, bed.time, axle, tire, run.contact, bed.energy.internal);
}

/// Tire, path and contact of a case; the block of foam is the caller's.
template <class Run>
void start_tire(Run& run, const RollingCase& setup, unsigned threads = 1) {
  run.setup = setup;
  run.tire =
      setup.rigid_roller ? make_roller(setup.tire, setup.bed_half_width) : make_tire(setup.tire, {}, {}, threads);
  run.path = path_of(setup);
  if (setup.entry > 0.0) {  // it arrives turning
    run.tire.spin = run.path.first_spin;
    run.energy.spin_work = 0.5 * run.tire.wheel_inertia * run.tire.spin * run.tire.spin;
  }
  run.law.friction = setup.friction;
  run.law.slip_speed = 0.02 * setup.speed;
}

/// Columns of the lattice within the window when the axle is at `axle_x`; behind it the block made for pressing stays
/// until it is left behind.
struct Columns {
  int first, end;
};
Columns window_columns(const RollingCase&, double axle_x);

/// What the history and the account of a run say, whatever the block of foam.
template <class Run>
void sum_up(const Run& run, RollingResult& result) {
  measure(run.history, run.internal, result);
  result.energy = run.energy;
  result.energy.tire_stored = stored_energy(run.tire);
  result.energy.tire_kinetic = tread_kinetic_energy(run.tire);
  result.residual = result.energy.residual();
  result.rut_depth = run.setup.penetration - result.tire_deflection;
}

}  // namespace apc::sph
