#include "sph_backend/throughput.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/press_rig.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {
namespace {

using units::in;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

constexpr double half_width = 36.0 * in, depth = 36.0 * in, plane = 24.0 * in;
constexpr int held = BedSpec{}.held_columns;

double spacing(const BenchOptions& options) { return (options.quick ? 3.0 : 2.0) * in; }
int columns(const BenchOptions& options) { return options.quick ? 40 : 140; }

Bed rest_block(const BenchOptions& options, unsigned threads) {
  BedSpec s;
  s.foam = ideal_foam_50psi();
  s.spacing = spacing(options), s.depth = depth, s.half_width = half_width, s.columns = columns(options);
  s.speed = 36.0, s.threads = threads;
  return make_bed(s);
}

/// The fastest of some batches: what else runs on the machine only slows one down.
double rate_at_rest(Bed& bed, int steps) {
  double best = 0.0;
  for (int batch = 0; batch < 5; ++batch) {
    const auto begin = Clock::now();
    for (int k = 0; k < steps; ++k) {
      drift(bed);
      strain(bed);
      accelerate(bed);
      kick(bed);
    }
    best = std::max(best, static_cast<double>(steps) * bed.alive / seconds_since(begin));
  }
  return best;
}

RollingCase tire_case(const BenchOptions& options) {
  RollingCase c;
  c.foam = ideal_foam_50psi();
  c.tire = {"H44.5x16.5-21",      44.5 * in, 16.5 * in,          21.0 * in, 214.0 * units::psi,
            44700.0 * units::lbf, 3.5 * in,  121e3 * units::lbf, 8.5 * in};
  c.bed_depth = plane, c.penetration = 16.0 * in, c.speed = 1418.0 * in, c.spacing = spacing(options);
  c.bed_half_width = half_width;
  return c;
}

/// The whole bed awake: as many columns as at rest, the axle in their middle.
RollingCase whole_case(const BenchOptions& options) {
  RollingCase c = tire_case(options);
  const double length = (columns(options) - 2 * held) * spacing(options);
  c.bed_depth = depth;
  c.ahead = 0.5 * length, c.behind = 0.5 * length;
  c.longest = 0.5 * c.tire.diameter;  // the rate does not wait for the loads
  if (options.quick) c.longest *= 0.2;
  return c;
}

/// Wall time over 20 steps of the press, between two strains: the mean.
double press_time(const PressResult& r, double from, double to) {
  double first = -1.0, last = 0.0;
  int notes = 0;
  for (std::size_t k = 0; k < r.strain.size(); ++k) {
    if (r.strain[k] < from || r.strain[k] > to) continue;
    if (first < 0.0) first = r.clock[k];
    last = r.clock[k], ++notes;
  }
  return (last - first) / std::max(1, notes - 1);
}

double crushed_cost(const BenchOptions& options) {
  PressCase c;
  c.foam = ideal_foam_50psi();
  c.width = c.length = 12.0 * in, c.depth = 24.0 * in, c.spacing = (options.quick ? 2.0 : 1.0) * in;
  double intact = std::numeric_limits<double>::max(), crushed = intact;
  for (int again = 0; again < 2; ++again) {
    const PressResult r = press(c);
    intact = std::min(intact, press_time(r, 0.05, 0.15)), crushed = std::min(crushed, press_time(r, 0.75, 0.85));
  }
  return crushed / intact;
}

}  // namespace

Limits measure_limits(unsigned threads) {
  const PairKernels& kernels = pair_kernels();
  Team team(threads);
  const int count = static_cast<int>(threads);
  std::vector<std::vector<float>> data(threads);
  std::vector<float> sums(threads, 0.0f);
  // Work of all threads over the time until the last is done; the best of ten.
  const auto best = [&](double work, const std::function<void(int)>& one) {
    double rate = 0.0;
    for (int again = 0; again < 10; ++again) {
      const auto begin = Clock::now();
      team.run(count, 1, [&](int first, int last) {
        for (int t = first; t < last; ++t) one(t);
      });
      rate = std::max(rate, work * count / seconds_since(begin));
    }
    return rate;
  };
  Limits limits;
  const long rounds = 10000000;
  const double done = kernels.multiply_add(rounds);
  limits.operations = best(done, [&](int) { kernels.multiply_add(rounds); });
  const auto reading = [&](long floats, int times) {
    for (auto& one : data) one.assign(static_cast<std::size_t>(floats), 1.0f);
    return best(4.0 * static_cast<double>(floats) * times, [&](int t) {
      for (int k = 0; k < times; ++k) sums[t] += kernels.read(data[t].data(), floats);
    });
  };
  limits.near_bytes = reading(64 * 1024, 8000);
  limits.far_bytes = reading(16 * 1024 * 1024, 4);
  volatile float keep = sums.front();  // so that the reading is not left out
  (void)keep;
  return limits;
}

Throughput measure_throughput(const BenchOptions& options) {
  Throughput t;
  t.instruction_set = pair_kernels().name;
  std::vector<unsigned> counts{1};
  if (options.threads > 1) counts.push_back(options.threads);
  const double parts = 3.0 * static_cast<double>(counts.size()) + 1.0;
  double done = 0.0;
  const auto note = [&](const std::string& remark) {
    if (options.stop && options.stop()) throw Interrupted();
    if (options.progress) options.progress(done / parts, remark);
  };
  for (const unsigned threads : counts) {
    const std::string on = concat(" on ", threads, threads == 1 ? " thread" : " threads");
    ThreadRates row;
    row.threads = threads;
    note("at rest" + on);
    row.limits = measure_limits(threads);
    {
      Bed bed = rest_block(options, threads);
      if (threads == 1) t.particles = bed.alive, t.count = count_step(bed);
      row.rest = rate_at_rest(bed, options.quick ? 10 : 50);
    }
    ++done;
    RollOptions roll_options;
    roll_options.threads = threads, roll_options.stop = options.stop;
    std::vector<Clock::time_point> ticks;
    const auto rolled = [&](const RollingCase& c, const std::string& remark) {
      note(remark + on);
      ticks.clear();
      roll_options.progress = [&](double share, const std::string&) {  // every 50 steps
        ticks.push_back(Clock::now());
        if (options.progress) options.progress((done + share) / parts, remark + on);
      };
      const RollingResult result = roll(c, roll_options);
      ++done;
      return result;
    };
    const RollingResult whole = rolled(whole_case(options), "whole bed");
    row.whole = row.whole_fastest = whole.particle_steps_per_s;
    for (std::size_t k = 4; k < ticks.size(); ++k) {
      const double wall = std::chrono::duration<double>(ticks[k] - ticks[k - 4]).count();
      row.whole_fastest = std::max(row.whole_fastest, 200.0 * whole.particle_steps / whole.steps / wall);
    }
    if (threads == 1) t.bytes_per_particle = whole.bytes_per_particle;
    const RollingResult window = rolled(tire_case(options), "window");
    row.window = window.particle_steps_per_s, row.window_wall_s = window.wall_s;
    row.nominal = t.particles * window.steps / window.wall_s;
    row.drag = window.drag, row.vertical = window.vertical;
    t.window_particles = window.particle_steps / window.steps, t.window_steps = window.steps;
    t.rows.push_back(row);
  }
  note("crushed foam");
  t.crushed_cost = crushed_cost(options);
  return t;
}

}  // namespace apc::sph
