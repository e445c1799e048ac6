#include "sph_backend/throughput.h"

#include <chrono>

#include "apc/base/units.h"
#include "sph_backend/foam_bed.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {
namespace {

using units::in;
using Clock = std::chrono::steady_clock;

// Counted in pair_kernels.inl: operations per pair in `strain` and `accelerate`, and per particle in between.
constexpr double flops_per_pair = 47.0 + 76.0, flops_per_particle = 400.0;

Bed rest_block(unsigned threads) {
  BedSpec s;
  s.foam = ideal_foam_50psi();
  s.spacing = 2.0 * in, s.depth = 24.0 * in, s.half_width = 36.0 * in, s.columns = 112;
  s.speed = 36.0, s.threads = threads;
  return make_bed(s);
}

double run_steps(Bed& bed, int steps) {
  const auto begin = Clock::now();
  const auto before = bed.particle_steps;
  for (int k = 0; k < steps; ++k) {
    drift(bed);
    strain(bed);
    accelerate(bed);
    kick(bed);
  }
  return static_cast<double>(bed.particle_steps - before) / std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

double foam_at_rest(unsigned threads, int steps) {
  Bed bed = rest_block(threads);
  return run_steps(bed, steps);
}

Throughput measure_throughput(unsigned threads) {
  Throughput t;
  t.instruction_set = pair_kernels().name;
  Bed bed = rest_block(threads);
  run_steps(bed, 10);
  t.rest = run_steps(bed, 100);
  const Neighbours& n = bed.neighbours;
  const double lanes_listed = static_cast<double>(n.list.size()) * lanes / bed.alive;
  t.flops = lanes_listed * flops_per_pair + flops_per_particle;
  t.useful_flops = 57.0 * flops_per_pair + flops_per_particle;
  // Each list entry brings one record of 64 bytes for 16 particles, twice a step; state is some 250 bytes.
  t.bytes = 2.0 * static_cast<double>(n.list.size()) / bed.alive * (64.0 + 4.0) + 250.0;
  t.bytes_per_particle = inspect(bed).bytes_per_particle;
  const auto begin = Clock::now();
  const double done = pair_kernels().multiply_add(40000000);
  t.peak = done / std::chrono::duration<double>(Clock::now() - begin).count();

  RollingCase c;
  c.foam = ideal_foam_50psi();
  c.tire = {"H44.5x16.5-21",      44.5 * in, 16.5 * in,          21.0 * in, 214.0 * units::psi,
            44700.0 * units::lbf, 3.5 * in,  121e3 * units::lbf, 8.5 * in};
  c.bed_depth = 24.0 * in, c.penetration = 16.0 * in, c.speed = 1418.0 * in, c.spacing = 2.0 * in;
  t.rolling =
      roll(c, {.threads = threads, .progress = {}, .stop = {}, .checkpoint = {}, .snapshots = {}}).particle_steps_per_s;
  return t;
}

}  // namespace apc::sph
