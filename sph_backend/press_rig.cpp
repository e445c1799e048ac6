#include "sph_backend/press_rig.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sph_backend/foam_bed.h"
#include "sph_backend/particle_block.h"
#include "sph_backend/press_loop.h"

namespace apc::sph {
double crush_work(const Foam& foam, double strain) {
  const int pieces = 4000;
  double work = 0.0, before = 0.0;
  for (int k = 1; k <= pieces; ++k) {
    const double e = strain * k / pieces;
    const double now = std::min(-foam.youngs_modulus * std::log1p(-e), foam.yield_stress(e));
    work += 0.5 * (before + now) * strain / pieces;
    before = now;
  }
  return work;
}

PressResult press(const PressCase& given) {
  const auto begin = std::chrono::steady_clock::now();
  BedSpec spec;
  spec.foam = given.foam, spec.spacing = given.spacing, spec.depth = given.depth, spec.half_width = given.width;
  spec.hold_bottom = false, spec.mirror_ends = true;
  spec.columns = std::max(1, static_cast<int>(std::lround(given.length / given.spacing)));
  spec.alpha = given.alpha, spec.beta = given.beta, spec.cfl = given.cfl, spec.speed = given.speed;
  spec.form = given.form, spec.threads = given.threads;
  Bed bed = make_bed(spec);

  PressResult result;
  press_block(given, bed, bed.half_width * spec.columns * spec.spacing, result);
  const BedState state = inspect(bed);
  result.compaction = state.compaction, result.partition = state.partition_mean,
  result.bytes_per_particle = state.bytes_per_particle;
  result.particles = bed.alive, result.steps = static_cast<double>(bed.steps);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.particle_steps_per_s = static_cast<double>(bed.particle_steps) / result.wall_s;
  return result;
}

}  // namespace apc::sph
