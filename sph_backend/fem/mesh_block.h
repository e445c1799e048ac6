/// What the rigs (press_loop.h, rolling_step.h) ask of a block of foam, answered by a mesh.
#pragma once

#include "sph_backend/energy.h"
#include "sph_backend/fem/mesh.h"
#include "sph_backend/press_rig.h"

namespace apc::sph::fem {

inline double next_step(const Mesh& mesh) { return mesh.next_dt; }
inline void find_forces(Mesh& mesh) { internal_forces(mesh); }
inline const std::vector<float>* stretches(const Mesh&) { return nullptr; }
inline void push(Mesh& mesh, std::size_t node, double fx, double fy, double fz) {
  mesh.force[0][node] += fx, mesh.force[1][node] += fy, mesh.force[2][node] += fz;
}

inline bool is_broken(const Mesh& mesh) { return mesh.inverted > 0; }

/// Foam's terms of a run's account.
inline void book_energy(const Mesh& mesh, PressResult& result) {
  result.internal = mesh.energy.internal, result.viscous = mesh.energy.viscous, result.damping = mesh.energy.damping;
  result.kinetic = mesh.energy.kinetic, result.hourglass = mesh.energy.hourglass;
}

inline void book_energy(const Mesh& mesh, EnergyAccount& e) {
  e.foam_internal = mesh.energy.internal, e.foam_kinetic = mesh.energy.kinetic, e.viscosity = mesh.energy.viscous;
  e.foam_damping = mesh.energy.damping, e.hourglass = mesh.energy.hourglass, e.removed = mesh.energy.removed;
}

}  // namespace apc::sph::fem
