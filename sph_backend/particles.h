/// Particles of the foam, one array per field. They are stored in clusters of 16 neighbours (one vector of lanes); a
/// cluster that is not full carries empty lanes (`id` < 0, at a far place, without volume).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sph_backend/pair_kernels.h"

namespace apc::sph {

/// Motion a particle may not make, as bits. A held particle still strains and carries stress: its reaction does no
/// work.
enum Hold : std::uint8_t { free_to_move = 0, hold_x = 1, hold_y = 2, hold_z = 4, hold_all = 7 };

struct Particles {
  std::vector<double> x, y, z;               ///< position at tⁿ, m
  std::vector<double> vx, vy, vz;            ///< velocity at tⁿ⁺½, m/s
  std::vector<float> stretch;                ///< (ρ/ρ0)^⅓
  std::array<std::vector<float>, 6> stress;  ///< Cauchy: xx yy zz xy xz yz, Pa
  std::vector<float> work;                   ///< internal work taken up so far, J
  std::vector<std::int32_t> id;              ///< order of creation; −1 marks an empty lane
  std::vector<std::int32_t> column;          ///< lattice column along x in which the particle was created
  std::vector<std::uint8_t> hold;            ///< bits of Hold in force now
  std::vector<std::uint8_t> layer_hold;      ///< bits of Hold that never end (bottom layer)

  std::size_t size() const { return x.size(); }
};

/// Calls `visit(field)` for every array of `particles`; keeps copies, files and permutations complete.
template <class P, class Visit>
void for_each_field(P& particles, Visit&& visit) {
  visit(particles.x), visit(particles.y), visit(particles.z);
  visit(particles.vx), visit(particles.vy), visit(particles.vz);
  visit(particles.stretch);
  for (auto& component : particles.stress) visit(component);
  visit(particles.work);
  visit(particles.id), visit(particles.column), visit(particles.hold), visit(particles.layer_hold);
}

}  // namespace apc::sph
