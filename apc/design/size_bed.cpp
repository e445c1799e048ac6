#include "apc/design/size_bed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/design/gradient_check.h"
#include "apc/study/critical_speed.h"
#include "apc/study/result_text.h"

namespace apc::design {
namespace {

/// Starts unlike one another: the given one; a shorter ramp and depths that fall; and the greatest depths from the
/// middle on, where only heavy aircraft roll.
std::vector<Profile> starts(const BedSpace& space, const Profile& first) {
  auto falling = first, deep = first;
  falling.ramp = 0.5 * (first.ramp + space.minimum_ramp);
  const auto nodes = first.depth.size();
  for (std::size_t j = 0; j < nodes; ++j) {
    const double share = 0.9 - 0.15 * static_cast<double>(j) / static_cast<double>(nodes);
    falling.depth[j] = std::max(space.minimum_depth, share * first.depth[j]);
    if (2 * j + 1 >= nodes) deep.depth[j] = space.maximum_depth;
  }
  return {first, falling, deep};
}

double relative_difference(double a, double b) { return std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-30}); }

bool better(const Optimum& a, const Optimum& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.objective < b.objective : a.overstep < b.overstep;
}

}  // namespace

namespace {

/// One search, with the constraints only that matter on its way. Where it ends all are looked at; those it broke join
/// and it goes on.
Optimum search(const Program& program, Method method, Eigen::VectorXd start, const OptimiserOptions& options) {
  std::vector<Eigen::VectorXd> seen;
  Optimum best;
  int evaluations = 0;
  for (int round = 0; round < 4; ++round) {
    seen.push_back(start);
    auto next = optimise(nearby(program, seen, 0.4), method, start, options);
    evaluations += next.evaluations;
    const auto values = program.at(next.z);
    next.overstep = values.tail(values.size() - 1).maxCoeff();
    const bool whole = !next.feasible || next.overstep <= options.tolerance;
    next.feasible = next.overstep <= options.tolerance;
    if (best.z.size() == 0 || better(next, best)) best = next;
    if (whole) break;
    start = next.z;
  }
  best.evaluations = evaluations;
  return best;
}

/// From the other's end half-way back to where this one ended.
Optimum again(const Program& program, const Optimum& worse, const Optimum& other, const OptimiserOptions& options) {
  auto next = search(program, worse.method, 0.5 * (worse.z + other.z), options);
  next.evaluations += worse.evaluations;
  if (better(next, worse)) return next;
  auto same = worse;
  same.evaluations = next.evaluations;
  return same;
}

/// A search ends when the objective settles, which may be before the conditions of an optimum are met: the better end
/// is searched from again, without that ease, as long as they are not.
void polish(const Program& program, OptimiserOptions options, Certificate& certificate) {
  options.ftol = 1e-9, options.xtol = 1e-8, options.evaluations = 60;
  auto& best = better(certificate.second, certificate.first) ? certificate.second : certificate.first;
  if (!best.feasible) return;
  for (int round = 0; round < 2; ++round) {
    Certificate now;
    examine(program, best.z, options, now);
    if (now.stationarity < 0.02) return;
    const auto next = search(program, Method::slsqp, best.z, options);
    const int evaluations = best.evaluations + next.evaluations;
    if (next.feasible && next.objective <= best.objective)
      best.z = next.z, best.objective = next.objective, best.overstep = next.overstep, best.ended = next.ended;
    best.evaluations = evaluations;
  }
}

}  // namespace

Certificate best_bed(Evaluator& evaluator, const Aim& aim, const Profile& start, double extra,
                     const OptimiserOptions& options) {
  const auto& space = evaluator.problem().fleet.bed;
  const auto program = make_program(evaluator, aim);
  const double enough = 5e-3;
  Certificate out;
  const auto from = starts(space, start);
  for (const auto& each : from) {
    const auto next = search(program, Method::slsqp, point_of(space, each, extra), options);
    out.ends.push_back(next.feasible ? next.objective : std::nan(""));
    const int before = out.first.evaluations;
    if (out.first.z.size() == 0 || better(next, out.first)) out.first = next;
    out.first.evaluations = before + next.evaluations;
  }
  // The second method begins elsewhere: half-way between the first one's end and another start.
  auto rough = options;
  rough.ftol = rough.xtol = 1e-5, rough.evaluations = 60;
  out.second = search(program, Method::mma, 0.5 * (out.first.z + point_of(space, from[1], extra)), rough);
  for (int round = 0; round < 3; ++round) {
    out.difference = relative_difference(out.first.objective, out.second.objective);
    if (out.first.feasible && out.second.feasible && out.difference <= 0.2 * enough) break;
    const bool second = better(out.first, out.second);
    if (second)
      out.second = again(program, out.second, out.first, rough);
    else
      out.first = again(program, out.first, out.second, options);
  }
  polish(program, options, out);
  out.difference = relative_difference(out.first.objective, out.second.objective);
  out.agreed = out.first.feasible && out.second.feasible && out.difference <= enough;
  const auto& best = better(out.second, out.first) ? out.second : out.first;
  if (best.z.size() > 0) {
    examine(program, best.z, options, out);
    out.sensitivity_error = sensitivity_difference(evaluator, aim, program, best.z, out, options);
  }
  return out;
}

namespace {

const Optimum& winner(const Certificate& certificate) {
  return better(certificate.second, certificate.first) ? certificate.second : certificate.first;
}

std::string listed(const std::vector<Constraint>& constraints, const Fleet& fleet) {
  std::string out;
  for (const auto& each : constraints) out += (out.empty() ? "" : "; ") + describe(each, fleet);
  return out;
}

/// The constraints that hold the optimum, heaviest first, each one named once although it may touch in several zones.
std::vector<Constraint> holding(const Certificate& certificate) {
  std::vector<Constraint> out;
  for (const auto& active : certificate.active) {
    const auto& each = active.constraint;
    const bool known = std::any_of(out.begin(), out.end(), [&](const Constraint& other) {
      return other.kind == each.kind && other.fleet_case == each.fleet_case && other.gear == each.gear &&
             other.what == each.what;
    });
    if (!known && each.kind != Kind::bound && active.weight > 0.02) out.push_back(each);
  }
  return out;
}

/// No bed keeps the load limits: how near one comes, and what stands in the way.
void forbid_by_loads(Evaluator& evaluator, Aim aim, const Profile& start, const SizeOptions& options, Design& design) {
  aim.feasibility = true;
  const auto search = best_bed(evaluator, aim, start, 1.0, options.optimiser);
  const auto& best = winner(search);
  if (best.z.size() > 0 && best.objective <= 1e-3) {
    design.profile = profile_of(evaluator.problem().fleet.bed, best.z, aim.reference);
    return;
  }
  design.forbidding = holding(search);
  if (design.forbidding.empty()) design.forbidding.push_back(design.uniform.limiting);
  design.reason = "no bed within these depths keeps the load limits: at best a limit is overstepped by " +
                  std::to_string(static_cast<int>(std::ceil(100 * best.objective))) +
                  " %. In the way: " + listed(design.forbidding, evaluator.problem().fleet);
}

/// Shortest bed for each case alone, by the method with gradients only.
std::vector<double> alone(Evaluator& evaluator, const Aim& aim, const SizeOptions& options) {
  std::vector<double> out;
  for (const std::size_t k : aim.cases) {
    Aim one{Objective::length, aim.reference, 0.0, {k}, {}, 0.0, false};
    const auto uniform = uniform_bed(evaluator, {k});
    const Profile start{
        evaluator.problem().fleet.bed.maximum_ramp, aim.reference,
        std::vector<double>(static_cast<std::size_t>(evaluator.problem().fleet.bed.nodes), uniform.depth)};
    const auto program = make_program(evaluator, one);
    const auto best =
        optimise(program, Method::slsqp, point_of(evaluator.problem().fleet.bed, start, uniform.length / aim.reference),
                 options.optimiser);
    out.push_back(best.feasible ? best.objective * aim.reference : uniform.length);
  }
  return out;
}

void judge_cases(Evaluator& evaluator, Design& design) {
  const auto& problem = evaluator.problem();
  const auto& bed = design.built.bed;
  design.cases.resize(problem.fleet.cases.size());
  parallel_for(design.cases.size(), problem.threads, [&](std::size_t k) {
    auto& out = design.cases[k];
    out.fleet_case = k;
    const auto& figures = design.built.figures[k];
    out.stop_distance = design.built.results[k].stop_distance;
    const auto names = load_constraints(problem.fleet, k, problem.models[k]);
    for (std::size_t c = 0; c < names.size(); ++c)
      if (figures.use[c] > out.use) out.use = figures.use[c], out.active = names[c];
    if (figures.distance / bed.length() > out.use) out.active = {Kind::stop, k, "", -1, ""};
    auto model = problem.models[k];
    model.bed = bed;
    const auto use = [&](const simulation::Result& result) { return worst_use(result, model, problem.fleet.limits); };
    std::vector<double> name{static_cast<double>(k), problem.fleet.limits.criterion == Criterion::limit ? 0.0 : 1.0};
    name.insert(name.end(), bed.distance.begin(), bed.distance.end());
    name.insert(name.end(), bed.depth.begin(), bed.depth.end());
    const auto speeds = evaluator.remembered("speeds " + study::to_text(name), [&]() -> std::vector<double> {
      if (stop_requested()) throw Interrupted();
      const auto found = study::critical_speed(model, problem.fleet.cases[k].overrun, bed.length(), use, problem.solve,
                                               {simulation::Method::fast, 1e-6, 0.01, 120.0});
      return {found.arrest, found.intact};
    });
    out.arrest_speed = speeds.at(0), out.max_exit_speed = speeds.at(1);
  });
}

/// The optimum of the feasible problem, its length, and whether it fits the space's greatest length.
void settle(const Problem& problem, const Aim& aim, Design& design) {
  const auto& best = winner(design.certificate);
  design.profile = profile_of(problem.fleet.bed, best.z, aim.reference);
  const double extra = best.z[best.z.size() - 1];
  design.feasible = best.feasible;
  if (aim.objective == Objective::speed) {
    design.speed_factor = extra, design.length = aim.length;
    for (const auto& each : problem.fleet.cases)
      if (each.overrun.entry_speed * extra < problem.fleet.floor_speed) design.feasible = false;
    if (!design.feasible) design.reason = "the floor speed cannot be reached for all in the given length";
  } else {
    design.length = aim.objective == Objective::minimax ? 0.0 : extra * aim.reference;
  }
}

}  // namespace

Design size_bed(const Problem& problem, study::Store& store, const SizeOptions& options) {
  Evaluator evaluator(problem, store);
  const auto& space = problem.fleet.bed;
  Design design;
  design.objective = options.objective;
  Aim aim{options.objective, 0.0, options.length > 0 ? options.length : space.maximum_length, {}, {}, 0.0, false};
  aim.cases.resize(problem.fleet.cases.size());
  std::iota(aim.cases.begin(), aim.cases.end(), std::size_t{0});

  design.uniform = uniform_bed(evaluator, aim.cases);
  aim.reference =
      options.objective == Objective::speed ? aim.length : std::min(design.uniform.length, 2 * space.maximum_length);
  Profile start{std::max(space.minimum_ramp, space.maximum_ramp), aim.reference,
                std::vector<double>(static_cast<std::size_t>(space.nodes), design.uniform.depth)};
  const auto finish = [&]() -> Design& {
    design.runs = evaluator.runs(), design.gave_up = evaluator.gave_up();
    return design;
  };
  if (!design.uniform.feasible) {
    forbid_by_loads(evaluator, aim, start, options, design);
    if (!design.reason.empty()) return finish();
    start = design.profile;
  }
  if (options.objective == Objective::minimax) aim.alone = design.alone = alone(evaluator, aim, options);
  const double extra = options.objective == Objective::minimax ? 1.2 : 1.0;
  design.certificate = best_bed(evaluator, aim, start, extra, options.optimiser);
  if (options.objective == Objective::volume && !winner(design.certificate).feasible) {
    aim.objective = Objective::length;  // tells how long a bed has to be, and what makes it so
    design.certificate = best_bed(evaluator, aim, start, extra, options.optimiser);
  }
  settle(problem, aim, design);
  if (design.feasible) {
    const double given = options.objective == Objective::speed ? aim.length : 0.0;
    design.built = build(evaluator, design.profile, given, design.speed_factor);
    // Where no rounding keeps the limits, the best bed with a little reserve is rounded instead.
    auto z = winner(design.certificate).z;
    auto careful = aim;
    for (int round = 0; round < 3 && design.built.worst_use > 1.0; ++round) {
      careful.reserve += 1.5 * (design.built.worst_use - 1.0) + 2e-3;
      const auto next = search(make_program(evaluator, careful), Method::slsqp, z, options.optimiser);
      if (!next.feasible) break;
      z = next.z;
      const double factor = options.objective == Objective::speed ? z[z.size() - 1] : 1.0;
      auto trial = build(evaluator, profile_of(space, z, aim.reference), given, factor);
      if (trial.worst_use >= design.built.worst_use) continue;
      design.built = std::move(trial), design.speed_factor = factor;
    }
    if (options.objective == Objective::minimax)
      for (const auto& each : design.built.figures) design.length = std::max(design.length, each.distance);
    judge_cases(evaluator, design);
  }
  if (design.feasible && design.length > space.maximum_length + 1e-6) {
    design.feasible = false;
    design.forbidding = holding(design.certificate);
    design.reason = std::string(aim.objective == Objective::minimax ? "the fairest" : "the shortest") +
                    " bed within the load limits is longer than the space allows (maximum_length). In the way: " +
                    listed(design.forbidding, problem.fleet);
  } else if (!design.feasible && design.reason.empty()) {
    design.reason = "no bed was found that keeps all limits";
  }
  return finish();
}

}  // namespace apc::design
