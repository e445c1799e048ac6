#include <algorithm>

#include "apc/design/size_bed.h"

namespace apc::design {
namespace {

struct Look {
  double worst = 0.0, longest = 0.0;
  Constraint at;
};

Profile flat(const BedSpace& space, double depth) {
  const double ramp = std::max({space.minimum_ramp, space.maximum_ramp, depth / space.maximum_slope});
  return {std::min(ramp, std::max(space.maximum_ramp, space.minimum_ramp)), space.maximum_length,
          std::vector<double>(static_cast<std::size_t>(space.nodes), depth)};
}

Look look(Evaluator& evaluator, const std::vector<std::size_t>& cases, double depth) {
  const auto& problem = evaluator.problem();
  const auto all = evaluator.run({{flat(problem.fleet.bed, depth), 1.0}}, cases).front();
  Look out;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    out.longest = std::max(out.longest, all[i].distance);
    const auto names = load_constraints(problem.fleet, cases[i], problem.models[cases[i]]);
    for (std::size_t c = 0; c < names.size(); ++c)
      if (all[i].use[c] > out.worst) out.worst = all[i].use[c], out.at = names[c];
  }
  return out;
}

}  // namespace

Uniform uniform_bed(Evaluator& evaluator, const std::vector<std::size_t>& cases) {
  const auto& space = evaluator.problem().fleet.bed;
  const double steepest = space.maximum_slope * space.maximum_ramp;
  double low = space.minimum_depth, high = std::min(space.maximum_depth, std::max(steepest, low));
  auto shallow = look(evaluator, cases, low);
  if (shallow.worst > 1.0) return {false, low, shallow.longest, shallow.at};
  auto deep = look(evaluator, cases, high);
  if (deep.worst <= 1.0) return {true, high, deep.longest, deep.at};
  while (high - low > 5e-4) {  // half a millimetre: the start of a search, not its result
    const double middle = 0.5 * (low + high);
    const auto now = look(evaluator, cases, middle);
    if (now.worst <= 1.0)
      low = middle, shallow = now;
    else
      high = middle, deep = now;
  }
  return {true, low, shallow.longest, deep.at};
}

}  // namespace apc::design
