/// Throughput of the solver on this processor, beside what the processor can do: `apc sph bench`.
///
/// The case is the published tire (H44.5x16.5-21, 16 in deep at 70 kt, 2 in particles) in a bed of the published size,
/// 36 in of half-width, 36 in deep, made 280 in long so that it has the 45,000 particles that ACRP Report 29 calls
/// nominal:
///   rest     intact foam, the whole bed
///   whole    the tire rolled through it, all particles awake, everything in: tire, contact, lists, account
///   window   the same tire as campaigns run it: nothing below the rigid plane 24 in down, foam only around the wheel
///   nominal  rate of the window's run with the particles of the whole bed counted, asleep or not
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sph_backend/foam_bed.h"

namespace apc::sph {

/// What all threads together reach in plain loops.
struct Limits {
  double operations = 0.0;  ///< multiply-adds in single precision, two operations each, 1/s
  double near_bytes = 0.0;  ///< reading 256 KiB a thread again and again (second-level cache), B/s
  double far_bytes = 0.0;   ///< reading 64 MiB a thread, B/s
};
Limits measure_limits(unsigned threads);

struct ThreadRates {
  unsigned threads = 1;
  double rest = 0.0, whole = 0.0, window = 0.0, nominal = 0.0;  ///< particle-steps/s
  double whole_fastest = 0.0;  ///< of the whole bed's run, its fastest 200 steps: what other work did not slow down
  double window_wall_s = 0.0;  ///< of the window's whole run
  double drag = 0.0, vertical = 0.0;  ///< of the window's run, N: same bits on any threads
  Limits limits;
};

struct Throughput {
  std::string instruction_set;
  double particles = 0.0, window_particles = 0.0, window_steps = 0.0;
  std::vector<ThreadRates> rows;  ///< one thread, then all
  StepCount count;                ///< foam at rest
  double bytes_per_particle = 0.0;
  double crushed_cost = 0.0;  ///< a particle-step of foam crushed to 75–85 % over one at 5–15 %, platen, one thread
};

struct BenchOptions {
  unsigned threads = 1;
  bool quick = false;  ///< a ninth of the particles, 3 in apart: to see that it works, not to quote
  std::function<void(double share, const std::string& remark)> progress;
  std::function<bool()> stop;
};
Throughput measure_throughput(const BenchOptions&);

}  // namespace apc::sph
