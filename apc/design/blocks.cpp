#include "apc/design/blocks.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"

namespace apc::design {

Blocks blocks_of(const BedSpace& space, const Profile& profile, double length, const Rounding& rounding) {
  Blocks blocks{space.block_length, {}};
  const auto rows = static_cast<int>(std::ceil(length / space.block_length - 1e-9));
  for (int row = 0; row < std::max(rows, 2); ++row) {
    const double at = (row + 0.5) * space.block_length;
    const double depth = profile.depth_at(at);
    const double share = rounding.near + (rounding.far - rounding.near) * std::min(1.0, at / rounding.reach);
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

double slope_use(const BedSpace& space, const Blocks& blocks) {
  double steepest = 0.0;
  for (std::size_t row = 0; row < blocks.depth.size(); ++row) {
    const double change = blocks.depth[row] - (row > 0 ? blocks.depth[row - 1] : 0.0);
    steepest = std::max(steepest, std::abs(change) / (row > 0 ? 1.0 : 0.5));
  }
  return steepest / (space.maximum_slope * blocks.row_length + space.step);
}

namespace {

/// Use up to which a trial by the fast method keeps the limits of the proof by the reference method.
constexpr double keeps = 1.0 - 2e-4;

/// Fills the worst use from the figures of all cases.
void judge(const Problem& problem, Built& built) {
  built.worst = {Kind::slope, 0, "", -1, "slope from row to row"};
  built.worst_use = slope_use(problem.fleet.bed, built.blocks);
  for (std::size_t k = 0; k < built.figures.size(); ++k) {
    const auto names = load_constraints(problem.fleet, k, problem.models[k]);
    for (std::size_t c = 0; c < names.size(); ++c)
      if (built.figures[k].use[c] > built.worst_use) built.worst_use = built.figures[k].use[c], built.worst = names[c];
  }
}

/// A trial of the fast method in the bed continued beyond its end.
void try_out(Evaluator& evaluator, double speed_factor, Built& built) {
  built.bed = bed_of(evaluator.problem().fleet.bed, built.blocks);
  built.figures = evaluator.in_bed(built.bed, speed_factor);
  judge(evaluator.problem(), built);
}

/// The bed as it is, by the reference method and with histories.
void prove(const Problem& problem, double speed_factor, Built& built) {
  built.bed = bed_of(problem.fleet.bed, built.blocks);
  const simulation::Options reference{simulation::Method::reference, 1e-7, 0.005, 120.0};
  built.results.assign(problem.fleet.cases.size(), {});
  built.figures.assign(problem.fleet.cases.size(), {});
  parallel_for(built.results.size(), problem.threads, [&](std::size_t k) {
    auto model = problem.models[k];
    model.bed = built.bed;
    auto overrun = problem.fleet.cases[k].overrun;
    overrun.entry_speed *= speed_factor;
    built.results[k] = problem.solve(model, overrun, reference);
    built.figures[k] = figures(built.results[k], model, problem.fleet.limits, built.bed.length(), {});
  });
  judge(problem, built);
}

double longest_stop(const std::vector<Figures>& all) {
  double longest = 0.0;
  for (const auto& each : all) longest = std::max(longest, each.distance);
  return longest;
}

/// Rounding down gives depth away. Raises rows by one step wherever every limit is still kept and the longest stop gets
/// shorter: a stretch of rows as a whole, else its halves, the far one first.
class Raise {
 public:
  Raise(Evaluator& evaluator, double speed_factor, Built& best, double& need)
      : evaluator_(evaluator), speed_factor_(speed_factor), best_(best), need_(need) {}

  void run() {
    for (int pass = 0; pass < 3; ++pass) {
      const double before = need_;
      stretch(0, best_.blocks.depth.size());
      if (need_ > before - 0.05) return;
    }
  }

 private:
  void stretch(std::size_t from, std::size_t to) {
    constexpr int most = 80;             // beds tried
    constexpr std::size_t shortest = 3;  // rows
    if (trials_ >= most || attempt(from, to) || to - from <= shortest) return;
    const auto middle = from + (to - from) / 2;
    stretch(middle, to);
    stretch(from, middle);
  }
  /// True when the rows were raised, or when nobody rolls there.
  bool attempt(std::size_t from, std::size_t to) {
    const auto& space = evaluator_.problem().fleet.bed;
    if (static_cast<double>(from) * best_.blocks.row_length > need_) return true;
    Built trial;
    trial.rounding = best_.rounding, trial.blocks = best_.blocks;
    for (auto row = from; row < to; ++row) {
      trial.blocks.depth[row] += space.step;
      if (trial.blocks.depth[row] > space.maximum_depth + 1e-9) return false;
    }
    ++trials_;
    try_out(evaluator_, speed_factor_, trial);
    const double need = longest_stop(trial.figures);
    if (trial.worst_use > keeps || need > need_ - 1e-3) return false;
    best_ = trial, need_ = need;
    return true;
  }

  Evaluator& evaluator_;
  double speed_factor_;
  Built& best_;
  double& need_;
  int trials_ = 0;
};

}  // namespace

Built build(Evaluator& evaluator, const Profile& profile, double length, double speed_factor) {
  const auto& problem = evaluator.problem();
  const auto& space = problem.fleet.bed;
  Built best;
  best.worst_use = 1e9;
  double need = 1e9;
  const auto attempt = [&](const Rounding& rounding) {
    Built trial;
    trial.rounding = rounding;
    trial.blocks = blocks_of(space, profile, std::max(profile.reference, length), rounding);
    try_out(evaluator, speed_factor, trial);
    const double its_need = longest_stop(trial.figures);
    const bool kept = best.worst_use <= keeps;
    const bool better = trial.worst_use <= keeps ? !kept || its_need < need : !kept && trial.worst_use < best.worst_use;
    if (better) best = trial, need = its_need;
  };
  attempt({0.5, 0.5, 1.0});
  if (best.worst_use > keeps) {
    // Lower everywhere is no remedy where a bed deepens: the aircraft then rolls farther, into deeper rows. So the
    // rounding is tilted over the way of the case in question.
    const double reach = best.worst.kind == Kind::slope ? need : best.figures[best.worst.fleet_case].distance;
    for (int near = 3; near >= -3; --near)
      for (int far = 3; far >= -3; --far) attempt({0.1 + 0.3 * near, 0.1 + 0.3 * far, reach});
  }
  // A space of one depth asks for a bed of one depth.
  if (best.worst_use <= keeps && space.nodes > 1) Raise(evaluator, speed_factor, best, need).run();
  const double rows = (length > 0 ? length : need) / space.block_length;
  best.blocks.depth.resize(static_cast<std::size_t>(length > 0 ? std::floor(rows + 1e-9) : std::ceil(rows - 1e-9)),
                           best.blocks.depth.back());
  for (int row = 0; row < 4; ++row) {  // a stop right at the end may need one more row once the bed ends there
    prove(problem, speed_factor, best);
    if (length > 0 || longest_stop(best.figures) <= best.bed.length()) break;
    best.blocks.depth.push_back(best.blocks.depth.back());
  }
  return best;
}

}  // namespace apc::design
