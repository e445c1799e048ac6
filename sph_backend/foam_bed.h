/// A block of foam on a lattice, cut from a bed, and one explicit step of it.
///
///   leapfrog, constant Δt:  xⁿ⁺¹ = xⁿ + Δt vⁿ⁺½;  σⁿ⁺¹ from L(xⁿ⁺¹, vⁿ⁺½);  vⁿ⁺³ᐟ² = vⁿ⁺½ + Δt a(xⁿ⁺¹, σⁿ⁺¹)
/// x forward, y ≥ 0 from the symmetry plane outwards, z up from the rigid plane under the bed. Nothing exists below
/// that plane: it sets the effective depth. The lattice is cubic in x and y; in z it is stretched a little so that a
/// whole number of layers fills the depth exactly.
#pragma once

#include <memory>
#include <vector>

#include "sph_backend/foam.h"
#include "sph_backend/mirror.h"
#include "sph_backend/neighbours.h"
#include "sph_backend/particles.h"
#include "sph_backend/team.h"

namespace apc::sph {

struct BedSpec {
  Foam foam;
  double spacing = 0.0;      ///< lattice spacing in x and y, m
  double depth = 0.0;        ///< m
  double half_width = 0.0;   ///< rounded to whole spacings
  bool outer_wall = true;    ///< mirror plane at half_width; otherwise a free face
  bool hold_bottom = true;   ///< lowest layer may not slide on the rigid plane
  bool mirror_ends = false;  ///< mirror planes at both ends in x instead of held columns
  bool free_body = false;    ///< no plane at all, nothing held: a block in empty space
  int first_column = 0, columns = 0;
  int held_columns = 4;            ///< at either end of the block: strain, but do not move
  double alpha = 0.1, beta = 2.0;  ///< artificial viscosity
  PairForm form = PairForm::mass;
  double cfl = 0.25;   ///< Δt = cfl · h0/(c + speed)
  double speed = 0.0;  ///< fastest tool, m/s
  unsigned threads = 1;
};

/// Foam's part of the energy account, J, summed over all steps.
struct FoamEnergy {
  double internal = 0.0;  ///< ∫ V σ : D dt, elastic and crushed
  double viscous = 0.0;   ///< artificial viscosity
  double damping = 0.0;   ///< material damping
  double floor = 0.0;     ///< stored in the last resort against passing the rigid plane, now
  double kinetic = 0.0;   ///< now
  double removed = 0.0;   ///< kinetic energy of columns that were held or left behind
};

struct Bed {
  BedSpec spec;
  double dt = 0.0, time = 0.0;
  double layer = 0.0;  ///< lattice spacing in z
  double half_width = 0.0;
  double mass = 0.0, volume0 = 0.0;  ///< of one particle
  YieldTable yield;
  Particles particles;
  Neighbours neighbours;
  std::vector<float> acceleration[3];
  FoamEnergy energy;
  std::int64_t steps = 0, particle_steps = 0, rebuilds = 0;
  std::int32_t next_id = 0;
  int alive = 0;
  std::shared_ptr<Team> team;
};

Bed make_bed(const BedSpec&);

/// For a tool that bears no longer steps than `longest`.
void shorten_step(Bed&, double longest);

/// Moves the block along the bed to columns [first, end): fresh ones ahead, those behind dropped, the ends held.
void move_window(Bed&, int first_column, int end_column);

/// xⁿ⁺¹; renews the neighbour lists when a particle has outrun them.
void drift(Bed&);
/// Stress at the new positions.
void strain(Bed&);
/// a(xⁿ⁺¹); tools may add to `acceleration` afterwards.
void accelerate(Bed&);
/// vⁿ⁺³ᐟ².
void kick(Bed&);

/// Position of a column of the lattice, m.
inline double column_position(const BedSpec& spec, int column) { return (column + 0.5) * spec.spacing; }

/// Largest 1 − ρ0/ρ; NaN when a particle's density is.
double largest_compaction(const Bed& bed);

struct BedState {
  double compaction = 0.0;      ///< largest 1 − ρ0/ρ
  double partition_min = 0.0;   ///< Σ_j V_j W over the particles compacted beyond one half: smallest …
  double partition_mean = 0.0;  ///< … and mean; 1 is exact
  double bytes_per_particle = 0.0;
};
BedState inspect(const Bed&);

/// What one step of this block takes, per particle: counted by making the step in counting arithmetic (on a copy).
struct StepCount {
  double operations = 0.0;  ///< of both pair sums and the material law, single precision; a multiply-add is two
  double pairs = 0.0, pairs_within = 0.0;  ///< computed, and of those within the kernel's support
  double neighbour_bytes = 0.0;            ///< records of neighbours, a cache line each, and their numbers
  double own_bytes = 0.0;                  ///< state and record of the particle itself, read and written
};
StepCount count_step(const Bed&);

}  // namespace apc::sph
