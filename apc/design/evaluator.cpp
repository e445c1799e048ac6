#include "apc/design/evaluator.h"

#include <algorithm>

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

std::string packed(const Figures& figures) {
  std::vector<double> numbers{figures.distance, static_cast<double>(figures.use.size())};
  numbers.insert(numbers.end(), figures.use.begin(), figures.use.end());
  numbers.insert(numbers.end(), figures.nose_use.begin(), figures.nose_use.end());
  return study::to_text(numbers);
}

Figures unpacked(const std::string& text) {
  const auto numbers = study::numbers_from(text);
  expect(numbers.size() >= 2, "stored figures hold a distance and a count");
  const auto middle = numbers.begin() + 2 + static_cast<std::ptrdiff_t>(numbers[1]);
  return {numbers[0], {numbers.begin() + 2, middle}, {middle, numbers.end()}};
}

}  // namespace

Evaluator::Evaluator(const Problem& problem, study::Store& store) : problem_(problem), store_(store) {
  expect(problem.models.size() == problem.fleet.cases.size(), "one model per case of the fleet");
}

double Evaluator::reach() const { return std::min(2000.0, std::max(1000.0, 3 * problem_.fleet.bed.maximum_length)); }

Figures Evaluator::one(const Trial& trial, std::size_t fleet_case) {
  const auto key = key_of(trial, fleet_case, problem_.fleet.limits.criterion);
  if (const auto known = store_.find(key)) return unpacked(*known);
  auto model = problem_.models[fleet_case];
  model.bed = bed_of(problem_.fleet.bed, trial.profile, reach());
  auto overrun = problem_.fleet.cases[fleet_case].overrun;
  overrun.entry_speed *= trial.speed_factor;
  const auto places = watched(trial.profile);
  Figures out;
  try {
    out = figures(problem_.solve(model, overrun, problem_.solver), model, problem_.fleet.limits, reach(), places);
  } catch (const SolveError&) {
    const auto constraints = load_constraints(problem_.fleet, fleet_case, model).size();
    out = {2 * reach(), std::vector<double>(constraints, 10.0), std::vector<double>(places.size(), 10.0)};
    ++gave_up_;
  }
  store_.put(key, packed(out));
  const long done = ++runs_;
  if (problem_.progress) problem_.progress(done);
  return out;
}

std::vector<std::vector<Figures>> Evaluator::run(const std::vector<Trial>& trials,
                                                 const std::vector<std::size_t>& cases) {
  std::vector<std::vector<Figures>> out(trials.size(), std::vector<Figures>(cases.size()));
  parallel_for(trials.size() * cases.size(), problem_.threads, [&](std::size_t i) {
    if (stop_requested()) throw Interrupted();
    const auto trial = i / cases.size(), at = i % cases.size();
    out[trial][at] = one(trials[trial], cases[at]);
  });
  return out;
}

}  // namespace apc::design
