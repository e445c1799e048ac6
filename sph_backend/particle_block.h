/// What the rigs (press_loop.h, rolling_step.h) ask of a block of foam, answered by particles.
#pragma once

#include "sph_backend/contact_points.h"
#include "sph_backend/energy.h"
#include "sph_backend/foam_bed.h"
#include "sph_backend/press_rig.h"

namespace apc::sph {

/// Length of the coming step, s.
inline double next_step(const Bed& bed) { return bed.dt; }

/// Stresses and accelerations at the new positions.
inline void find_forces(Bed& bed) {
  strain(bed);
  accelerate(bed);
}

/// Stretches of this step, on which contact radii depend.
inline const std::vector<float>* stretches(const Bed& bed) { return &bed.particles.stretch; }

/// Force of a tool on particle i, N.
inline void push(Bed& bed, std::size_t i, double fx, double fy, double fz) {
  bed.acceleration[0][i] += static_cast<float>(fx / bed.mass);
  bed.acceleration[1][i] += static_cast<float>(fy / bed.mass);
  bed.acceleration[2][i] += static_cast<float>(fz / bed.mass);
}

/// Particles cannot turn inside out.
inline bool is_broken(const Bed&) { return false; }

/// Foam's terms of a run's account.
inline void book_energy(const Bed& bed, PressResult& result) {
  result.internal = bed.energy.internal, result.viscous = bed.energy.viscous, result.damping = bed.energy.damping;
  result.kinetic = bed.energy.kinetic;
  result.contact += bed.energy.floor;
}

inline void book_energy(const Bed& bed, EnergyAccount& e) {
  e.contact_penalty += bed.energy.floor;
  e.foam_internal = bed.energy.internal, e.foam_kinetic = bed.energy.kinetic, e.viscosity = bed.energy.viscous;
  e.foam_damping = bed.energy.damping, e.removed = bed.energy.removed;
}

}  // namespace apc::sph
