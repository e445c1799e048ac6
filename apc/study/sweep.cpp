#include "apc/study/sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/study/result_text.h"

namespace apc::study {

const char* text(Criterion criterion) { return criterion == Criterion::limit ? "limit" : "ultimate"; }

std::vector<Case> combinations(const std::vector<simulation::Model>& models, const Axes& axes) {
  std::vector<Case> cases;
  for (std::size_t model = 0; model < models.size(); ++model) {
    auto masses = axes.masses;
    if (masses.empty())
      for (const double factor : axes.mass_factors) masses.push_back(factor * models[model].aircraft.mass);
    for (const double strength : axes.strengths)
      for (const double braking : axes.brakings)
        for (const double mass : masses)
          for (const double speed : axes.speeds) {
            Case each{model, {}};
            each.overrun.alterations.bed_strength = strength;
            each.overrun.entry_speed = speed;
            each.overrun.mass = mass;
            each.overrun.braking = braking;
            each.overrun.braking_in_bed = axes.braking_in_bed;
            cases.push_back(each);
          }
  }
  return cases;
}

namespace {

/// Everything that decides a case's result, apart from the model, which the store's identity covers.
std::string key_of(const Case& each, const simulation::Options& options) {
  constexpr double form = 2.0;  // of the stored results; cases of another form are run again
  const auto& run = each.overrun;
  return to_text({form, static_cast<double>(each.model), run.entry_speed, run.mass, run.cg_behind_nose_gear,
                  run.pitch_inertia, run.braking, run.braking_in_bed, run.thrust, run.headwind, run.bed_depth,
                  run.alterations.bed_strength, run.alterations.conditions.years,
                  run.alterations.conditions.temperature, options.method == simulation::Method::fast ? 1.0 : 0.0,
                  options.rtol});
}

constexpr auto failed = "failed ";

CaseResult solved(const simulation::Model& model, const Case& input, const Solve& solve,
                  const simulation::Options& options) {
  CaseResult out{input, {}, {}};
  try {
    out.result = solve(model, input.overrun, options);
    out.result.history = {};
  } catch (const SolveError& error) {
    out.failure = error.what();
    std::replace(out.failure.begin(), out.failure.end(), '\n', ' ');
  }
  return out;
}

}  // namespace

std::vector<CaseResult> run(const std::vector<simulation::Model>& models, const std::vector<Case>& cases,
                            const Solve& solve, Store& store, const SweepOptions& options) {
  std::vector<CaseResult> results(cases.size());
  std::atomic<std::size_t> finished{0};
  parallel_for(cases.size(), options.threads, [&](std::size_t i) {
    if (stop_requested()) throw Interrupted();
    const auto key = key_of(cases[i], options.solver);
    if (const auto known = store.find(key)) {
      results[i].input = cases[i];
      if (known->starts_with(failed))
        results[i].failure = known->substr(std::string(failed).size());
      else
        results[i].result = result_from(*known);
    } else {
      results[i] = solved(models[cases[i].model], cases[i], solve, options.solver);
      store.put(key, results[i].failure.empty() ? to_text(results[i].result) : failed + results[i].failure);
    }
    ++finished;
    if (options.finished) options.finished(finished);
  });
  return results;
}

double worst_margin(const simulation::Result& result, Criterion criterion) {
  double worst = std::numeric_limits<double>::infinity();
  for (const auto& gear : result.gears) {
    const bool ultimate = criterion == Criterion::ultimate;
    const double drag = ultimate ? gear.drag_ultimate : gear.drag_limit;
    const double vertical = gear.vertical_limit * (ultimate ? 1.5 : 1.0);
    if (drag > 0 && gear.peak_drag > 0) worst = std::min(worst, drag / gear.peak_drag - 1.0);
    if (vertical > 0 && gear.peak_vertical > 0) worst = std::min(worst, vertical / gear.peak_vertical - 1.0);
  }
  return std::isfinite(worst) ? worst : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace apc::study
