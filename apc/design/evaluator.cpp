#include "apc/design/evaluator.h"

#include <algorithm>
#include <numeric>

#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/study/result_text.h"

namespace apc::design {
namespace {

std::string key_of(const Trial& trial, std::size_t fleet_case, Criterion criterion) {
  std::vector<double> numbers{static_cast<double>(fleet_case), criterion == Criterion::limit ? 0.0 : 1.0,
                              trial.speed_factor, trial.profile.ramp, trial.profile.reference};
  numbers.insert(numbers.end(), trial.profile.depth.begin(), trial.profile.depth.end());
  return study::to_text(numbers);
}

std::vector<double> packed(const Figures& figures) {
  std::vector<double> numbers{figures.distance, static_cast<double>(figures.use.size())};
  numbers.insert(numbers.end(), figures.use.begin(), figures.use.end());
  for (const auto& windows : figures.windows) {
    numbers.push_back(static_cast<double>(windows.size()));
    numbers.insert(numbers.end(), windows.begin(), windows.end());
  }
  return numbers;
}

Figures unpacked(const std::vector<double>& numbers) {
  expect(numbers.size() >= 2, "stored figures hold a distance and a count");
  auto next = numbers.begin() + 2 + static_cast<std::ptrdiff_t>(numbers[1]);
  Figures out{numbers[0], {numbers.begin() + 2, next}, {}};
  while (next < numbers.end()) {
    const auto last = next + 1 + static_cast<std::ptrdiff_t>(*next);
    out.windows.emplace_back(next + 1, last), next = last;
  }
  return out;
}

}  // namespace

Watch watch_of(const Profile& profile) { return {window_edges(profile, 6.0), window_edges(profile, 1e9)}; }

Evaluator::Evaluator(const Problem& problem, study::Store& store) : problem_(problem), store_(store) {
  expect(problem.models.size() == problem.fleet.cases.size(), "one model per case of the fleet");
}

double Evaluator::reach() const { return std::min(2000.0, std::max(1000.0, 3 * problem_.fleet.bed.maximum_length)); }

std::vector<double> Evaluator::remembered(const std::string& key, const std::function<std::vector<double>()>& work) {
  if (const auto known = store_.find(key)) return study::numbers_from(*known);
  const auto numbers = work();
  store_.put(key, study::to_text(numbers));
  return numbers;
}

Figures Evaluator::solve(const Run& run, const bed::Bed& bed, double bed_length, const Watch& watch,
                         const simulation::Options& options) {
  if (stop_requested()) throw Interrupted();
  auto model = problem_.models[run.fleet_case];
  model.bed = bed;
  auto overrun = problem_.fleet.cases[run.fleet_case].overrun;
  overrun.entry_speed *= run.speed_factor;
  Figures out;
  try {
    out = figures(problem_.solve(model, overrun, options), model, problem_.fleet.limits, bed_length, watch);
  } catch (const SolveError&) {
    out.distance = 2 * bed_length;
    for (const auto& each : load_constraints(problem_.fleet, run.fleet_case, model))
      out.use.push_back(10.0), out.windows.emplace_back(windows_of(each, watch), 10.0);
    ++gave_up_;
  }
  const long done = ++runs_;
  if (problem_.progress) problem_.progress(done);
  return out;
}

Figures Evaluator::one(const Trial& trial, std::size_t fleet_case) {
  const auto key = key_of(trial, fleet_case, problem_.fleet.limits.criterion);
  return unpacked(remembered(key, [&] {
    return packed(solve({fleet_case, trial.speed_factor}, bed_of(problem_.fleet.bed, trial.profile, reach()), reach(),
                        watch_of(trial.profile), problem_.solver));
  }));
}

std::vector<Figures> Evaluator::in_bed(const bed::Bed& bed, double speed_factor) {
  constexpr double beyond = 2000.0;  // m
  auto used = bed;
  used.distance.push_back(bed.length() + beyond), used.depth.push_back(bed.depth.back());
  auto options = problem_.solver;
  if (!problem_.fleet.limits.table_range) options.sampling = 0.0;  // only that limit is read from the history
  std::vector<Figures> out(problem_.fleet.cases.size());
  parallel_for(out.size(), problem_.threads, [&](std::size_t i) {
    const auto k = out.size() - 1 - i;
    std::vector<double> numbers{static_cast<double>(k), speed_factor, static_cast<double>(bed.depth.size())};
    if (problem_.fleet.limits.criterion == Criterion::ultimate) numbers.front() += 0.5;
    numbers.insert(numbers.end(), bed.distance.begin(), bed.distance.end());
    numbers.insert(numbers.end(), bed.depth.begin(), bed.depth.end());
    const auto work = [&] { return packed(solve({k, speed_factor}, used, used.length(), {}, options)); };
    out[k] = unpacked(remembered("bed " + study::to_text(numbers), work));
  });
  return out;
}

std::vector<std::vector<Figures>> Evaluator::run(const std::vector<Trial>& trials,
                                                 const std::vector<std::size_t>& cases) {
  std::vector<std::vector<Figures>> out(trials.size(), std::vector<Figures>(cases.size()));
  // Aircraft with many gears take longest: they come first, so that no core waits for the last of them.
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto gears = [&](std::size_t at) { return problem_.models[cases[at]].aircraft.gears.size(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return gears(a) > gears(b); });
  parallel_for(trials.size() * cases.size(), problem_.threads, [&](std::size_t i) {
    const auto trial = i % trials.size(), at = order[i / trials.size()];
    out[trial][at] = one(trials[trial], cases[at]);
  });
  return out;
}

}  // namespace apc::design
