/// The press: a block of foam between mirror planes, crushed from above by a rigid tool at a smoothly started speed.
///
/// Under a platen every particle moves vertically only in the mean, so force and work have a closed form:
///   F(ε) = A min(E ε…, σ_y(ε)),  W(ε) = A H ∫ σ dε, the elastic part with the logarithmic strain of the law.
/// Under a punch narrower than the block (plane strain) the work beyond that of its own column is what the sheared wall
/// of the rut takes.
#pragma once

#include <vector>

#include "sph_backend/foam.h"
#include "sph_backend/pair_kernels.h"

namespace apc::sph {

struct PressCase {
  Foam foam;
  double width = 0.0, length = 0.0, depth = 0.0;  ///< m
  double spacing = 0.0;                           ///< of particles, or size of elements
  double punch_half_width = 0.0;                  ///< m; 0 = a platen as wide as the block
  double speed = 2.5;                             ///< m/s, after a ramp over the first 5 % of strain
  double strain_end = 0.85;                       ///< nominal strain at the end
  double unload_to = -1.0;                        ///< strain to go back to afterwards; negative: no unloading
  double alpha = 0.1, beta = 2.0, cfl = 0.25;     ///< of particles
  PairForm form = PairForm::mass;                 ///< of particles
  unsigned threads = 1;
};

struct PressResult {
  bool inverted = false;                    ///< elements turned inside out: the run ended there
  std::vector<double> strain, force, work;  ///< of the tool; N, J
  std::vector<double> work_exact;           ///< closed form under a platen, at the same strains
  std::vector<double> clock;                ///< s since the start, by the wall, at the same strains
  double energy_rmse =
      0.0;  ///< root mean square of (work − exact) over ε in 0.05 … end, over the exact work at the end
  double residual = 0.0;                                                                ///< of the energy account
  double internal = 0.0, viscous = 0.0, damping = 0.0, kinetic = 0.0, hourglass = 0.0;  ///< J, at the end
  double contact = 0.0, radius = 0.0;  ///< stored and damped; work of the shrinking contact radius
  double compaction = 0.0;
  double partition = 1.0;           ///< Σ V W of particles, mean over those compacted beyond one half
  double bytes_per_particle = 0.0;  ///< of the arrays that grow with the particles
  double particles = 0.0, steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
};

PressResult press(const PressCase&);

/// ∫ σ dε of slow uniaxial crush to nominal strain ε, J/m³.
double crush_work(const Foam&, double strain);

}  // namespace apc::sph
