#include "apc/design/size_bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "apc/base/parallel.h"
#include "apc/study/critical_speed.h"

namespace apc::design {
namespace {

/// A start unlike the first one: a shorter ramp, depths falling from the first node to the last.
Profile other_start(const BedSpace& space, const Profile& first) {
  auto other = first;
  other.ramp = 0.5 * (first.ramp + space.minimum_ramp);
  for (std::size_t j = 0; j < other.depth.size(); ++j) {
    const double share = 0.9 - 0.15 * static_cast<double>(j) / static_cast<double>(other.depth.size());
    other.depth[j] = std::max(space.minimum_depth, share * first.depth[j]);
  }
  return other;
}

double relative_difference(double a, double b) { return std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-30}); }

bool better(const Optimum& a, const Optimum& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.objective < b.objective : a.overstep < b.overstep;
}

}  // namespace

namespace {

/// Largest nose drag of each case over its limit, minus 1, among the constraints of a programme.
std::vector<double> nose_peaks(const Program& program, const Aim& aim, const Eigen::VectorXd& z) {
  const auto values = program.at(z);
  std::vector<double> out(aim.cases.size(), -1.0);
  for (std::size_t c = 0; c < program.constraints.size(); ++c) {
    const auto& each = program.constraints[c];
    if (each.kind != Kind::drag || each.gear != "nose") continue;
    const auto at = std::find(aim.cases.begin(), aim.cases.end(), each.fleet_case) - aim.cases.begin();
    auto& peak = out[static_cast<std::size_t>(at)];
    peak = std::max(peak, values[static_cast<Eigen::Index>(c) + 1]);
  }
  return out;
}

/// The optimum by one method on watched places. What the places miss of each case's true peak is taken off its limit,
/// and the search repeated, until that no longer changes.
Optimum by_gradients(Evaluator& evaluator, const Aim& asked, Method method, Eigen::VectorXd start,
                     const OptimiserOptions& options, std::vector<double>& allowance) {
  const auto exact = make_program(evaluator, asked, Peaks::exact),
             plain = make_program(evaluator, asked, Peaks::watched);
  Optimum best;
  int evaluations = 0;
  auto aim = asked;
  for (int round = 0; round < 4; ++round) {
    aim.allowance = allowance;
    auto next = optimise(make_program(evaluator, aim, Peaks::watched), method, start, options);
    if (next.z.size() == 0) break;
    evaluations += next.evaluations, start = next.z;
    const auto values = exact.at(next.z);
    next.overstep = values.tail(values.size() - 1).maxCoeff();
    next.feasible = next.feasible && next.overstep <= 1e-3;
    if (best.z.size() == 0 || better(next, best)) best = next;
    if (asked.feasibility) break;
    const auto true_peaks = nose_peaks(exact, asked, next.z), seen = nose_peaks(plain, asked, next.z);
    double change = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double missed = std::max(0.0, true_peaks[i] - seen[i]);
      if (true_peaks[i] > -0.05) change = std::max(change, std::abs(missed - allowance[i]));
      allowance[i] = missed;
    }
    if (change < 5e-4) break;
  }
  best.evaluations = evaluations;
  return best;
}

}  // namespace

Certificate best_bed(Evaluator& evaluator, const Aim& aim, const Profile& start, double extra,
                     const OptimiserOptions& options) {
  const auto& space = evaluator.problem().fleet.bed;
  const double enough = 5e-3;
  Certificate out;
  std::array<std::vector<double>, 2> allowance;
  allowance.fill(std::vector<double>(aim.cases.size(), 0.0));
  out.first = by_gradients(evaluator, aim, Method::slsqp, point_of(space, start, extra), options, allowance[0]);
  out.second = by_gradients(evaluator, aim, Method::mma, point_of(space, other_start(space, start), extra), options,
                            allowance[1]);
  for (int round = 0; round < 3; ++round) {
    out.difference = relative_difference(out.first.objective, out.second.objective);
    if (out.first.feasible && out.second.feasible && out.difference <= enough) break;
    // The worse one starts again where it ended, with a fresh model of the problem.
    const bool second = better(out.first, out.second);
    auto& worse = second ? out.second : out.first;
    auto next = by_gradients(evaluator, aim, worse.method, worse.z, options, allowance[second]);
    next.evaluations += worse.evaluations;
    if (better(next, worse))
      worse = next;
    else
      worse.evaluations = next.evaluations;
  }
  out.agreed = out.first.feasible && out.second.feasible && out.difference <= enough;
  const bool second = better(out.second, out.first);
  const auto& best = second ? out.second : out.first;
  auto examined = aim;
  examined.allowance = allowance[second];
  if (best.z.size() > 0) examine(make_program(evaluator, examined, Peaks::watched), best.z, options, out);
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
    Aim one{Objective::length, aim.reference, 0.0, {k}, {}, {}, 0.0, false};
    const auto uniform = uniform_bed(evaluator, {k});
    const Profile start{
        evaluator.problem().fleet.bed.maximum_ramp, aim.reference,
        std::vector<double>(static_cast<std::size_t>(evaluator.problem().fleet.bed.nodes), uniform.depth)};
    const auto program = make_program(evaluator, one, Peaks::watched);
    const auto best =
        optimise(program, Method::slsqp, point_of(evaluator.problem().fleet.bed, start, uniform.length / aim.reference),
                 options.optimiser);
    out.push_back(best.feasible ? best.objective * aim.reference : uniform.length);
  }
  return out;
}

void judge_cases(const Problem& problem, Design& design) {
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
    const auto speeds = study::critical_speed(model, problem.fleet.cases[k].overrun, bed.length(), use, problem.solve,
                                              {simulation::Method::fast, 1e-6, 0.01, 120.0});
    out.arrest_speed = speeds.arrest, out.max_exit_speed = speeds.intact;
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
  Aim aim{options.objective, 0.0, options.length > 0 ? options.length : space.maximum_length, {}, {}, {}, 0.0, false};
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
  settle(problem, aim, design);
  if (design.feasible) {
    design.built =
        build(problem, design.profile, options.objective == Objective::speed ? aim.length : 0.0, design.speed_factor);
    if (options.objective == Objective::minimax)
      for (const auto& each : design.built.figures) design.length = std::max(design.length, each.distance);
    judge_cases(problem, design);
  }
  if (design.feasible && design.length > space.maximum_length + 1e-6) {
    design.feasible = false;
    design.forbidding = holding(design.certificate);
    design.reason =
        "the shortest bed within the load limits is longer than the space allows (maximum_length). In the way: " +
        listed(design.forbidding, problem.fleet);
  } else if (!design.feasible && design.reason.empty()) {
    design.reason = "no bed was found that keeps all limits";
  }
  return finish();
}

}  // namespace apc::design
