#include "apc/design/pareto.h"

#include <algorithm>
#include <numeric>

namespace apc::design {
namespace {

bool beats(const FrontPoint& a, const FrontPoint& b) {
  const bool no_worse = a.margin >= b.margin && a.length <= b.length && a.volume <= b.volume;
  return no_worse && (a.margin > b.margin || a.length < b.length || a.volume < b.volume);
}

}  // namespace

std::vector<FrontPoint> pareto_front(const Problem& problem, study::Store& store, const Design& start,
                                     const std::vector<double>& margins, const OptimiserOptions& options) {
  Evaluator evaluator(problem, store);
  std::vector<FrontPoint> all;
  for (const auto objective : {Objective::length, Objective::volume}) {
    Aim aim{objective, start.profile.reference, 0.0, {}, {}, 0.0, false};
    aim.cases.resize(problem.fleet.cases.size());
    std::iota(aim.cases.begin(), aim.cases.end(), std::size_t{0});
    auto z = point_of(problem.fleet.bed, start.profile, start.length / start.profile.reference);
    for (const double margin : margins) {
      aim.reserve = 1.0 - 1.0 / (1.0 + margin);
      const auto best = optimise(make_program(evaluator, aim), Method::slsqp, z, options);
      if (!best.feasible) continue;
      z = best.z;
      FrontPoint point{margin, best.z[best.z.size() - 1] * aim.reference, 0.0, objective,
                       profile_of(problem.fleet.bed, best.z, aim.reference)};
      point.volume = point.profile.section(point.length) * problem.fleet.bed.width;
      all.push_back(point);
    }
  }
  std::vector<FrontPoint> front;
  for (const auto& point : all)
    if (std::none_of(all.begin(), all.end(), [&](const FrontPoint& other) { return beats(other, point); }))
      front.push_back(point);
  return front;
}

}  // namespace apc::design
