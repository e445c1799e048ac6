#include "apc/reliability/reliability.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/reliability/samples.h"
#include "apc/simulation/simulate_each.h"
#include "apc/study/result_text.h"

namespace apc::reliability {

double ExitSpeeds::below(double speed) const { return speed > 0 ? 1 - std::exp(-std::pow(speed / scale, shape)) : 0.0; }

SolveMany one_by_one(study::Solve solve) {
  return [solve = std::move(solve)](const simulation::Model& model, const std::vector<simulation::Overrun>& overruns,
                                    const simulation::Options& options) {
    std::vector<std::optional<simulation::Result>> out;
    for (const auto& each : overruns) {
      try {
        out.emplace_back(solve(model, each, options));
      } catch (const SolveError&) {
        out.emplace_back();
      }
    }
    return out;
  };
}

SolveMany side_by_side() {
  return [](const simulation::Model& model, const std::vector<simulation::Overrun>& overruns,
            const simulation::Options& options) {
    std::vector<simulation::Errand> errands;
    for (const auto& each : overruns) errands.push_back({&model, &each, &options});
    std::vector<std::optional<simulation::Result>> out;
    for (auto& each : simulation::simulate_each(errands)) {
      out.emplace_back();
      try {
        if (each.failure) std::rethrow_exception(each.failure);
        out.back() = std::move(each.result);
      } catch (const SolveError&) {
      }
    }
    return out;
  };
}

namespace {

constexpr std::size_t cubes = 10, pilots = 200, batch = 32;

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

/// Samples of all cubes, cube after cube.
std::vector<Sample> draw_samples(std::size_t per, std::uint64_t seed) {
  std::vector<Sample> out;
  for (std::size_t c = 0; c < cubes; ++c)
    for (const auto& u : latin_hypercube(per, seed * 7919 + c)) {
      out.emplace_back();
      out.back().u = u, out.back().blocks = seed * 100003 + out.size() - 1;
    }
  return out;
}

/// A sample as a line of the store, and back.
std::vector<double> numbers_of(const Sample& s) {
  return {s.arrest,        s.intact,       s.good ? 1.0 : 0.0, static_cast<double>(s.runs),
          s.stop_exponent, s.use_exponent, s.use_at_arrest};
}

void recall(Sample& s, const std::vector<double>& numbers) {
  s.arrest = numbers.at(0), s.intact = numbers.at(1), s.good = numbers.at(2) > 0;
  s.runs = static_cast<int>(numbers.at(3));
  s.stop_exponent = numbers.at(4), s.use_exponent = numbers.at(5), s.use_at_arrest = numbers.at(6);
  s.finished = true;
}

std::vector<double> list(const Sample& s) { return {s.u.begin(), s.u.end()}; }

double median(std::vector<double> values, double otherwise) {
  if (values.empty()) return otherwise;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// What the pilots teach: chaos expansions of both speeds. That of the intact speed also knows how far the use was
/// beyond its limit at the arrested speed, and so the blocks.
Expectation learned(const std::vector<Sample>& samples, std::size_t count, const Expectation& before) {
  std::vector<std::vector<double>> u, more;
  std::vector<double> arrest, intact, stop_exponents, use_exponents, uses;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& each = samples[i];
    if (!each.good) continue;
    u.push_back(list(each)), arrest.push_back(each.arrest);
    if (each.stop_exponent != before.stop_exponent) stop_exponents.push_back(each.stop_exponent);
    if (each.use_at_arrest <= 0 || each.intact <= 0) continue;
    more.push_back(u.back()), intact.push_back(each.intact), uses.push_back(each.use_at_arrest);
    if (each.use_exponent != before.use_exponent) use_exponents.push_back(each.use_exponent);
  }
  auto out = before;
  const Chaos arrest_of(u, arrest);
  out.arrest = [arrest_of](const Sample& s) { return arrest_of(list(s)); };
  out.stop_exponent = median(stop_exponents, before.stop_exponent);
  out.use_exponent = median(use_exponents, before.use_exponent);
  if (more.size() <= Chaos::terms(scattered_inputs + 1) + 10) return out;
  const auto [least, most] = std::minmax_element(uses.begin(), uses.end());
  const auto place = [low = *least, span = std::max(1e-6, *most - *least)](double use) {
    return std::clamp((use - low) / span, -0.2, 1.2);
  };
  for (std::size_t i = 0; i < more.size(); ++i) more[i].push_back(place(uses[i]));
  const Chaos intact_of(more, intact);
  out.intact = [intact_of, place](const Sample& s) {
    auto at = list(s);
    at.push_back(place(s.use_at_arrest));
    return intact_of(at);
  };
  return out;
}

}  // namespace

Reliability assess(const ReliabilityInput& input, const SolveMany& solve, study::Store& store,
                   const ReliabilityOptions& options) {
  const std::size_t per = std::max<std::size_t>(pilots / cubes, (options.samples + cubes - 1) / cubes);
  auto samples = draw_samples(per, options.seed);
  auto endless = input.model;
  endless.bed = study::continued(input.model.bed);
  const auto key_of = [&](std::size_t i) {
    std::vector<double> numbers{static_cast<double>(options.seed), static_cast<double>(per), static_cast<double>(i)};
    return study::to_text(numbers);
  };
  std::atomic<std::size_t> finished{0};
  const auto work = [&](std::size_t from, std::size_t to, const Expectation& expected) {
    if (stop_requested()) throw Interrupted();
    std::vector<std::size_t> open;
    for (std::size_t i = from; i < to; ++i) {
      if (const auto known = store.find(key_of(i)))
        recall(samples[i], study::numbers_from(*known));
      else
        open.push_back(i);
    }
    find_critical_speeds(input, endless, solve, options, expected, samples, open);
    for (const auto i : open) store.put(key_of(i), study::to_text(numbers_of(samples[i])));
    finished += to - from;
    if (options.finished) options.finished(finished);
  };
  const auto in_batches = [&](std::size_t from, std::size_t to, std::size_t size, const Expectation& expected) {
    const std::size_t count = (to - from + size - 1) / size;
    parallel_for(count, options.threads,
                 [&](std::size_t b) { work(from + b * size, std::min(to, from + (b + 1) * size), expected); });
  };
  // The pilots find their speeds from scratch; what they teach guesses the rest.
  Expectation expected;
  expected.arrest = [&](const Sample&) { return input.asked_speed; };
  expected.intact = [&](const Sample& s) { return s.arrest * std::exp(-s.use_at_arrest / expected.use_exponent); };
  in_batches(0, pilots, 10, expected);
  const auto good = static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.begin() + pilots, [](const Sample& s) { return s.good; }));
  require(good > Chaos::terms(scattered_inputs) + 10,
          "the solver gave up on most samples: the scatter leaves the range in which this aircraft can be simulated");
  in_batches(pilots, samples.size(), batch, learned(samples, pilots, expected));

  std::vector<std::vector<double>> u;
  std::vector<double> arrest, intact;
  Reliability out;
  for (const auto& each : samples) {
    out.runs += each.runs;
    if (each.good) u.push_back(list(each)), arrest.push_back(each.arrest), intact.push_back(each.intact);
  }
  const Chaos chaos_arrest(u, arrest), chaos_intact(u, intact);
  out.samples = u.size(), out.gave_up = samples.size() - u.size();
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

}  // namespace apc::reliability
