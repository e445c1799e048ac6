#include "loadtables/infill.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apc/base/require.h"
#include "loadtables/metamodel.h"

namespace apc::loadtables {
namespace {

using Point = std::array<double, 3>;

Point scaled(const PlanOptions& box, const PlannedRun& run) {
  const auto share = [](double x, const std::array<double, 2>& range) {
    return (x - range[0]) / (range[1] - range[0]);
  };
  return {share(run.contact.speed, box.speed),
          share(std::log(run.contact.bed_depth), {std::log(box.bed_depth[0]), std::log(box.bed_depth[1])}),
          share(run.relative_penetration, box.relative_penetration)};
}

double distance(const Point& a, const Point& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

struct Known {
  Point at;
  bool usable;   ///< steady, or only planned
  double error;  ///< relative, of leaving it out; 0 where unknown
};

std::vector<Known> known_runs(const Plan& plan, const std::vector<RunStatus>& list) {
  std::vector<Sample> samples;
  for (const auto& each : list)
    if (each.outcome && each.outcome->steady()) samples.push_back({each.planned.contact, each.outcome->load});
  require(samples.size() >= 12, "only ", samples.size(),
          " runs are finished and steady; further runs are chosen from the errors of 12 or more. Make the planned ones "
          "first");
  const auto model = learn(samples, plan.tire, 0.0, 0.014);
  std::vector<Known> known;
  Eigen::Index next = 0;
  for (const auto& each : list) {
    const bool steady = each.outcome && each.outcome->steady();
    double error = 0.0;
    if (steady) {
      error = std::abs(model.ratio[drag].leave_one_out()(next)) + std::abs(model.ratio[vertical].leave_one_out()(next));
      ++next;
    }
    known.push_back({scaled(plan.options, each.planned), !each.outcome || steady, error});
  }
  return known;
}

/// Distance to the nearest run times the neighbourhood's error; 0 next to a refused run.
double gain(const Point& at, const std::vector<Known>& known) {
  double nearest = 10.0, errors = 0.0, weights = 0.0;
  bool usable = true;
  for (const auto& run : known) {
    const double away = distance(at, run.at);
    if (away < nearest) nearest = away, usable = run.usable;
    if (run.error <= 0.0) continue;
    const double weight = 1.0 / std::pow(away * away + 0.02, 2);
    errors += weight * run.error;
    weights += weight;
  }
  return usable && weights > 0.0 ? nearest * errors / weights : 0.0;
}

}  // namespace

std::vector<PlannedRun> further_runs(const Plan& plan, const std::vector<RunStatus>& list, int count) {
  require(count >= 1 && count <= 1000, count, " further runs. Between 1 and 1000 are possible");
  auto known = known_runs(plan, list);
  auto box = plan.options;
  box.runs = 600;
  box.seed = plan.options.seed + static_cast<unsigned>(list.size());
  const auto candidates = make_plan(plan.tire, plan.material, box).runs;
  std::vector<PlannedRun> chosen;
  for (int i = 0; i < count; ++i) {
    const auto best = std::max_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
      return gain(scaled(plan.options, a), known) < gain(scaled(plan.options, b), known);
    });
    chosen.push_back(*best);
    chosen.back().id = static_cast<int>(list.size()) + i + 1;
    known.push_back({scaled(plan.options, *best), true, 0.0});
  }
  return chosen;
}

}  // namespace apc::loadtables
