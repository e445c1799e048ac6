// Particle-steps per second of the SPH solver: foam at rest, one step, one renewal of the neighbour lists.
#include <benchmark/benchmark.h>

#include "apc/base/units.h"
#include "sph_backend/foam_bed.h"

namespace {

using namespace apc::sph;

Bed block(unsigned threads) {
  BedSpec s;
  s.foam = ideal_foam_50psi();
  s.spacing = 2.0 * apc::units::in, s.depth = 24.0 * apc::units::in, s.half_width = 36.0 * apc::units::in;
  s.columns = 60, s.speed = 36.0, s.threads = threads;
  return make_bed(s);
}

void foam_at_rest(benchmark::State& state) {
  Bed bed = block(static_cast<unsigned>(state.range(0)));
  for (auto _ : state) {
    drift(bed);
    strain(bed);
    accelerate(bed);
    kick(bed);
  }
  state.counters["particle-steps/s"] =
      benchmark::Counter(static_cast<double>(bed.particle_steps), benchmark::Counter::kIsRate);
}
BENCHMARK(foam_at_rest)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void renew_lists(benchmark::State& state) {
  Bed bed = block(1);
  for (auto _ : state) move_window(bed, bed.spec.first_column, bed.spec.first_column + bed.spec.columns);
}
BENCHMARK(renew_lists)->Unit(benchmark::kMillisecond);

}  // namespace
