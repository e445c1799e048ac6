#include "apc/study/envelope.h"

#include <cmath>
#include <limits>

namespace apc::study {

bed::Bed uniform_bed(const bed::Bed& site, double depth, double ramp, double length) {
  auto bed = site;
  bed.distance = {0.0, ramp, length};
  bed.depth = {0.0, depth, depth};
  return bed;
}

namespace {

constexpr double longest = 2000.0;  // m; every stop that matters ends well before

/// Where a line through (depth, margin) points crosses zero downwards first.
double crossing(const std::vector<double>& depths, const std::vector<double>& margins) {
  for (std::size_t i = 0; i + 1 < depths.size(); ++i)
    if (margins[i] >= 0 && margins[i + 1] < 0)
      return depths[i] + (depths[i + 1] - depths[i]) * margins[i] / (margins[i] - margins[i + 1]);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Envelope envelope(const EnvelopeInput& input, const Solve& solve, Store& store, const SweepOptions& options) {
  std::vector<simulation::Model> models;
  std::vector<Case> cases;
  for (const double depth : input.depths) {
    models.push_back(input.model);
    models.back().bed = uniform_bed(input.model.bed, depth, input.ramp, longest);
    for (const double speed : input.speeds) {
      cases.push_back({models.size() - 1, input.overrun});
      cases.back().overrun.entry_speed = speed;
    }
  }
  const auto results = run(models, cases, solve, store, options);
  const double none = std::numeric_limits<double>::quiet_NaN();
  Envelope out{input.model.aircraft.name, input.depths, input.speeds, {}, {}, {}};
  for (std::size_t s = 0; s < input.speeds.size(); ++s) {
    std::vector<double> distance, margin;
    for (std::size_t d = 0; d < input.depths.size(); ++d) {
      const auto& each = results[d * input.speeds.size() + s];
      const bool good = each.failure.empty() && std::isfinite(each.result.stop_distance);
      distance.push_back(good ? each.result.stop_distance : none);
      margin.push_back(good ? worst_margin(each.result, Criterion::limit) : none);
    }
    out.limit_depth.push_back(crossing(input.depths, margin));
    out.stop_distance.push_back(distance);
    out.margin.push_back(margin);
  }
  return out;
}

}  // namespace apc::study
