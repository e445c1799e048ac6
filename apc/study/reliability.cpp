#include "apc/study/reliability.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/study/result_text.h"

namespace apc::study {

double ExitSpeeds::below(double speed) const { return speed > 0 ? 1 - std::exp(-std::pow(speed / scale, shape)) : 0.0; }

namespace {

constexpr std::size_t cubes = 10;

struct Sample {
  std::array<double, scattered_inputs> u{};
  double arrest = 0.0, intact = 0.0;
  bool good = false;
};

std::vector<double> list(const std::array<double, scattered_inputs>& u) { return {u.begin(), u.end()}; }

/// Mean over samples and its 95 % interval from the means of the cubes.
template <class Value>
Estimate estimate(const std::vector<Sample>& samples, const Value& value) {
  std::vector<double> means;
  const std::size_t per = samples.size() / cubes;
  for (std::size_t c = 0; c < cubes; ++c) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = c * per; i < (c + 1) * per; ++i)
      if (samples[i].good) sum += value(samples[i]), ++count;
    if (count > 0) means.push_back(sum / static_cast<double>(count));
  }
  Estimate out;
  for (const double mean : means) out.value += mean / static_cast<double>(means.size());
  double square = 0.0;
  for (const double mean : means) square += std::pow(mean - out.value, 2);
  const double n = static_cast<double>(means.size());
  const double half = n > 1 ? 2.262 * std::sqrt(square / (n - 1) / n) : 1.0;
  out.low = std::max(0.0, out.value - half), out.high = std::min(1.0, out.value + half);
  return out;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return std::nan("");
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= sorted.size()) return sorted.back();
  return sorted[i] + (at - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}

}  // namespace

Reliability reliability(const ReliabilityInput& input, const Solve& solve, Store& store,
                        const ReliabilityOptions& options) {
  const std::size_t per = std::max<std::size_t>(10, (options.samples + cubes - 1) / cubes);
  std::vector<Sample> samples;
  for (std::size_t c = 0; c < cubes; ++c)
    for (const auto& u : latin_hypercube(per, options.seed * 7919 + c)) samples.push_back({u, 0.0, 0.0, false});

  std::atomic<std::size_t> finished{0};
  std::atomic<long> runs{0};
  SpeedRange range;
  range.tolerance = 0.1, range.value_tolerance = 2e-3;
  const auto work = [&](std::size_t i, const CriticalSpeed& guess) {
    if (stop_requested()) throw Interrupted();
    auto& sample = samples[i];
    auto key_numbers = list(sample.u);
    key_numbers.insert(key_numbers.begin(),
                       {static_cast<double>(options.seed), static_cast<double>(per), static_cast<double>(i)});
    const auto key = to_text(key_numbers);
    if (const auto known = store.find(key)) {
      const auto numbers = numbers_from(*known);
      sample.arrest = numbers.at(0), sample.intact = numbers.at(1), sample.good = numbers.at(2) > 0;
    } else {
      try {
        const auto run = drawn(input.model, input.centre, input.scatter, sample.u, options.seed * 100003 + i);
        const auto found =
            critical_speed(input.model, run, input.model.bed.length(), input.use, solve, options.solver, guess, range);
        sample.arrest = found.arrest, sample.intact = found.intact, sample.good = true, runs += found.runs;
      } catch (const SolveError&) {
        sample.good = false;
      }
      store.put(key, to_text({sample.arrest, sample.intact, sample.good ? 1.0 : 0.0}));
    }
    ++finished;
    if (options.finished) options.finished(finished);
  };
  // The first hundred find their speeds from scratch; a chaos expansion of them guesses the rest.
  const std::size_t first = std::min<std::size_t>(samples.size(), 100);
  CriticalSpeed start;
  start.arrest = start.intact = input.asked_speed;
  parallel_for(first, options.threads, [&](std::size_t i) { work(i, start); });
  std::vector<std::vector<double>> u;
  std::vector<double> arrest, intact;
  const auto collect = [&](std::size_t count) {
    u.clear(), arrest.clear(), intact.clear();
    for (std::size_t i = 0; i < count; ++i)
      if (samples[i].good)
        u.push_back(list(samples[i].u)), arrest.push_back(samples[i].arrest), intact.push_back(samples[i].intact);
  };
  collect(first);
  constexpr std::size_t terms = 1 + 2 * scattered_inputs + scattered_inputs * (scattered_inputs - 1) / 2;
  require(u.size() > terms + 10,
          "the solver gave up on most samples: the scatter leaves the range in which this aircraft can be simulated");
  const Chaos guess_arrest(u, arrest), guess_intact(u, intact);
  parallel_for(samples.size() - first, options.threads, [&](std::size_t i) {
    const auto at = list(samples[first + i].u);
    CriticalSpeed guess;
    guess.arrest = std::max(range.low, guess_arrest(at)), guess.intact = std::max(range.low, guess_intact(at));
    work(first + i, guess);
  });

  collect(samples.size());
  const Chaos chaos_arrest(u, arrest), chaos_intact(u, intact);
  Reliability out;
  out.samples = u.size(), out.gave_up = samples.size() - u.size(), out.runs = runs;
  out.arrest = estimate(samples, [&](const Sample& s) { return input.exit_speeds.below(s.arrest); });
  out.intact = estimate(samples, [&](const Sample& s) { return input.exit_speeds.below(s.intact); });
  out.arrest_at_asked = estimate(samples, [&](const Sample& s) { return s.arrest >= input.asked_speed ? 1.0 : 0.0; });
  out.intact_at_asked = estimate(samples, [&](const Sample& s) { return s.intact >= input.asked_speed ? 1.0 : 0.0; });
  out.arrest_indices = chaos_arrest.indices(), out.intact_indices = chaos_intact.indices();
  out.arrest_unexplained = chaos_arrest.unexplained(), out.intact_unexplained = chaos_intact.unexplained();
  std::sort(arrest.begin(), arrest.end()), std::sort(intact.begin(), intact.end());
  out.arrest_speed_975 = quantile(arrest, 0.025), out.intact_speed_975 = quantile(intact, 0.025);
  out.arrest_speeds = std::move(arrest), out.intact_speeds = std::move(intact);
  return out;
}

}  // namespace apc::study
