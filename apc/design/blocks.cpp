#include "apc/design/blocks.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"

namespace apc::design {

Blocks blocks_of(const BedSpace& space, const Profile& profile, double length, double share) {
  Blocks blocks{space.block_length, {}};
  const auto rows = static_cast<int>(std::ceil(length / space.block_length - 1e-9));
  for (int row = 0; row < std::max(rows, 2); ++row) {
    const double depth = profile.depth_at((row + 0.5) * space.block_length);
    const double rounded = space.step * std::floor(depth / space.step + share + 1e-9);
    blocks.depth.push_back(std::clamp(rounded, space.step, std::max(space.step, space.maximum_depth)));
  }
  return blocks;
}

bed::Bed bed_of(const BedSpace& space, const Blocks& blocks) {
  Profile none{1.0, 2.0, {0.0}};
  auto bed = bed_of(space, none, 1.5);  // everything but the profile
  bed.distance = {0.0};
  bed.depth = {0.0};
  const auto rows = blocks.depth.size();
  for (std::size_t row = 0; row < rows; ++row) {
    const bool straight = row > 0 && row + 1 < rows && blocks.depth[row - 1] == blocks.depth[row] &&
                          blocks.depth[row] == blocks.depth[row + 1];
    if (straight) continue;
    bed.distance.push_back((static_cast<double>(row) + 0.5) * blocks.row_length);
    bed.depth.push_back(blocks.depth[row]);
  }
  bed.distance.push_back(static_cast<double>(rows) * blocks.row_length);
  bed.depth.push_back(blocks.depth.back());
  return bed;
}

std::vector<simulation::Result> run_fleet(const Problem& problem, const bed::Bed& bed, End end,
                                          const simulation::Options& options) {
  auto used = bed;
  if (end == End::continued) used.distance.push_back(bed.length() + 2000.0), used.depth.push_back(bed.depth.back());
  std::vector<simulation::Result> results(problem.fleet.cases.size());
  parallel_for(results.size(), problem.threads, [&](std::size_t k) {
    auto model = problem.models[k];
    model.bed = used;
    results[k] = problem.solve(model, problem.fleet.cases[k].overrun, options);
  });
  return results;
}

namespace {

/// Fills results, figures and the worst use of `built.bed`.
void judge(const Problem& problem, End end, const simulation::Options& options, Built& built) {
  built.results = run_fleet(problem, built.bed, end, options);
  built.figures.clear();
  built.worst_use = 0.0;
  for (std::size_t k = 0; k < built.results.size(); ++k) {
    const auto names = load_constraints(problem.fleet, k, problem.models[k]);
    const double length = built.bed.length() + (end == End::continued ? 2000.0 : 0.0);
    built.figures.push_back(figures(built.results[k], problem.models[k], problem.fleet.limits, length, {}));
    for (std::size_t c = 0; c < names.size(); ++c)
      if (built.figures[k].use[c] > built.worst_use) built.worst_use = built.figures[k].use[c], built.worst = names[c];
  }
}

double longest_stop(const std::vector<Figures>& all) {
  double longest = 0.0;
  for (const auto& each : all) longest = std::max(longest, each.distance);
  return longest;
}

}  // namespace

Built build(const Problem& asked, const Profile& profile, double length, double speed_factor) {
  auto problem = asked;
  for (auto& each : problem.fleet.cases) each.overrun.entry_speed *= speed_factor;
  const auto& space = problem.fleet.bed;
  Built best;
  best.worst_use = 1e9;
  double best_need = 1e9;
  for (double share = 0.5; share > -1.1; share -= 0.125) {
    Built trial;
    trial.share = share;
    trial.blocks = blocks_of(space, profile, std::max(profile.reference, length), share);
    trial.bed = bed_of(space, trial.blocks);
    judge(problem, End::continued, problem.solver, trial);
    const double need = longest_stop(trial.figures);
    const bool keeps = trial.worst_use <= 1.0, kept = best.worst_use <= 1.0;
    const bool better = keeps ? !kept || need < best_need - 1e-6 : !kept && trial.worst_use < best.worst_use;
    if (better) best = trial, best_need = need;
  }
  const simulation::Options reference{simulation::Method::reference, 1e-7, 0.005, 120.0};
  best.blocks = blocks_of(space, profile, length > 0 ? length : best_need, best.share);
  if (length > 0) best.blocks.depth.resize(static_cast<std::size_t>(std::floor(length / space.block_length + 1e-9)));
  for (int row = 0; row < 4; ++row) {  // a stop right at the end may need one more row once the bed ends there
    best.bed = bed_of(space, best.blocks);
    judge(problem, End::as_built, reference, best);
    if (length > 0 || longest_stop(best.figures) <= best.bed.length()) break;
    best.blocks.depth.push_back(best.blocks.depth.back());
  }
  return best;
}

}  // namespace apc::design
