#include "apc/study/critical_speed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "apc/base/units.h"

namespace apc::study {

bed::Bed continued(bed::Bed bed) {
  bed.distance.push_back(bed.length() + 2000.0);
  bed.depth.push_back(bed.depth.back());
  return bed;
}

double largest_speed(const std::function<double(double)>& excess, double guess, const SpeedRange& range) {
  double low = range.low, high = range.high, at_low = 0.0, at_high = 0.0;
  bool have_low = false, have_high = false;
  double next = guess > 0 ? std::clamp(guess, low, high) : 0.5 * (low + high);
  double width = guess > 0 ? 1.0 : high - low;  // first steps from a good guess stay small
  int last_side = 0;
  for (int round = 0; round < 60; ++round) {
    const double value = excess(next);
    if (std::abs(value) <= range.value_tolerance) return next;
    if (value <= 0) {
      if (next >= range.high - 1e-12) return range.high;
      low = next, at_low = value;
      if (have_high && last_side < 0) at_high *= 0.5;
      have_low = true, last_side = -1;
    } else {
      if (next <= range.low + 1e-12) return 0.0;
      high = next, at_high = value;
      if (have_low && last_side > 0) at_low *= 0.5;
      have_high = true, last_side = +1;
    }
    if (have_low && have_high) {
      if (high - low < range.tolerance) break;
      const double from = low * low, to = high * high;
      next = std::sqrt(from + (to - from) * at_low / (at_low - at_high));
      // Half the tolerance inside the bracket: the root is then closed in from both sides.
      next = std::clamp(next, low + 0.4 * range.tolerance, high - 0.4 * range.tolerance);
    } else {
      next = std::clamp(have_low ? low + width : high - width, range.low, range.high);
      width *= 3.0;
    }
  }
  return low;
}

CriticalSpeed critical_speed(const simulation::Model& model, const simulation::Overrun& overrun, double bed_end,
                             const Use& use, const Solve& solve, const simulation::Options& options,
                             const CriticalSpeed& guess, const SpeedRange& range) {
  auto endless = model;
  endless.bed = continued(model.bed);
  CriticalSpeed out;
  // Both questions are asked of the same overruns: each speed is simulated once.
  std::map<double, std::array<double, 2>> known;  // speed → {distance over the length, largest use}
  const auto at = [&](double speed) -> const std::array<double, 2>& {
    if (const auto entry = known.find(speed); entry != known.end()) return entry->second;
    auto run = overrun;
    run.entry_speed = speed;
    ++out.runs;
    const auto result = solve(endless, run, options);
    const double left_over = result.exit_speed * result.exit_speed / (2 * 0.05 * units::g0);
    const double stop = std::isfinite(result.stop_distance) ? result.stop_distance : endless.bed.length() + left_over;
    return known[speed] = {stop / bed_end, use(result)};
  };
  out.arrest = largest_speed([&](double v) { return at(v)[0] - 1.0; }, guess.arrest, range);
  if (out.arrest <= 0) return out;
  if (at(out.arrest)[1] <= 1.0) {
    out.intact = out.arrest;
  } else {
    auto below = range;
    below.high = out.arrest;
    out.intact = largest_speed([&](double v) { return at(v)[1] - 1.0; }, std::min(guess.intact, out.arrest), below);
  }
  return out;
}

}  // namespace apc::study
