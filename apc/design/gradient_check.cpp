#include "apc/design/gradient_check.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::design {
namespace {

/// What a constraint divides its quantity by; 0 when sensitivities do not tell its gradient.
double unit_of(const Aim& aim, const Figures& figures, const Constraint& constraint, const Fleet& fleet,
               const simulation::Model& model) {
  if (constraint.kind == Kind::stop) {
    if (aim.objective == Objective::speed) return aim.length;
    if (aim.objective != Objective::minimax) return aim.reference;
    const auto at = std::find(aim.cases.begin(), aim.cases.end(), constraint.fleet_case) - aim.cases.begin();
    return aim.alone[static_cast<std::size_t>(at)];
  }
  if (constraint.kind != Kind::drag && constraint.kind != Kind::vertical) return 0.0;
  const auto names = load_constraints(fleet, constraint.fleet_case, model);
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (names[c].kind != constraint.kind || names[c].gear != constraint.gear) continue;
    if (constraint.window < 0) return 1.0;
    auto others = figures.windows[c];
    others.resize(others.size() / 2 - 1);  // the peaks in windows
    if (static_cast<std::size_t>(constraint.window) >= others.size()) return 0.0;
    const double here = others[static_cast<std::size_t>(constraint.window)];
    others[static_cast<std::size_t>(constraint.window)] = 0.0;
    // Where another peak is as high, the largest one has no gradient of its own.
    const double next = *std::max_element(others.begin(), others.end());
    return here >= figures.use[c] - 1e-5 && next < here - 1e-5 ? 1.0 : 0.0;
  }
  return 0.0;
}

double limit_of(const simulation::Result& result, const Constraint& constraint, const Limits& limits) {
  for (const auto& gear : result.gears)
    if (gear.name == constraint.gear) {
      const bool ultimate = limits.criterion == Criterion::ultimate;
      if (constraint.kind == Kind::drag) return ultimate ? gear.drag_ultimate : gear.drag_limit;
      return gear.vertical_limit * (ultimate ? 1.5 : 1.0);
    }
  return 0.0;
}

double entry(const simulation::Sensitivity& slope, const Constraint& constraint) {
  if (constraint.kind == Kind::stop) return slope.stop_distance;
  for (const auto& gear : slope.gears)
    if (gear.name == constraint.gear) return constraint.kind == Kind::drag ? gear.peak_drag : gear.peak_vertical;
  return std::nan("");
}

}  // namespace

double sensitivity_difference(Evaluator& evaluator, const Aim& aim, const Program& program, const Eigen::VectorXd& z,
                              const Certificate& certificate, const OptimiserOptions& options) {
  const auto& problem = evaluator.problem();
  if (!problem.sensitivity || aim.feasibility) return std::nan("");
  const auto slopes = jacobian(program, z, 2 * options.step, Differences::central);
  const double factor = aim.objective == Objective::speed ? z[z.size() - 1] : 1.0;
  const auto figures = evaluator.run({{profile_of(problem.fleet.bed, z, aim.reference), factor}}, aim.cases).front();
  struct Check {
    Eigen::Index row;
    Constraint constraint;
    double unit;
  };
  std::vector<Check> checks;
  for (const auto& active : certificate.active) {
    const auto& each = active.constraint;
    if (each.kind == Kind::slope || each.kind == Kind::bound) continue;
    const auto at = std::find(aim.cases.begin(), aim.cases.end(), each.fleet_case) - aim.cases.begin();
    const double unit =
        unit_of(aim, figures[static_cast<std::size_t>(at)], each, problem.fleet, problem.models[each.fleet_case]);
    const auto same = [&](const Constraint& other) {
      return other.kind == each.kind && other.fleet_case == each.fleet_case && other.gear == each.gear &&
             other.window == each.window;
    };
    const auto row = std::find_if(program.constraints.begin(), program.constraints.end(), same);
    if (unit > 0 && row != program.constraints.end())
      checks.push_back({static_cast<Eigen::Index>(row - program.constraints.begin()) + 1, each, unit});
  }
  if (checks.empty()) return std::nan("");

  // The last number is the programme's own (length, share or speed), not one of the bed.
  const auto variables = static_cast<std::size_t>(z.size()) - 1;
  std::vector<double> difference(checks.size() * variables, 0.0);
  parallel_for(difference.size(), problem.threads, [&](std::size_t i) {
    const auto& check = checks[i / variables];
    const auto variable = static_cast<Eigen::Index>(i % variables);
    const auto k = check.constraint.fleet_case;
    const auto bed_at = [&](double amount) {
      auto moved = z;
      moved[variable] += amount;
      return bed_of(problem.fleet.bed, profile_of(problem.fleet.bed, moved, aim.reference), evaluator.reach());
    };
    simulation::ScalarParameter parameter{"variable of the design", "1", 1e-6, 1.0, {}};
    parameter.shift = [&](simulation::Model& model, simulation::Overrun&, double amount) {
      model.bed = bed_at(amount);
    };
    auto model = problem.models[k];
    model.bed = bed_at(0.0);
    auto overrun = problem.fleet.cases[k].overrun;
    overrun.entry_speed *= factor;
    try {
      const simulation::Options reference{simulation::Method::reference, 1e-7, 0.0, 120.0};
      const auto slope = problem.sensitivity(model, overrun, parameter, reference);
      double unit = check.unit;
      if (check.constraint.kind != Kind::stop)
        unit = limit_of(problem.solve(model, overrun, problem.solver), check.constraint, problem.fleet.limits);
      difference[i] = std::abs(entry(slope, check.constraint) / unit - slopes(check.row, variable));
    } catch (const SolveError&) {
      difference[i] = 0.0;  // the reference method gave up: nothing to compare with
    }
  });
  double worst = 0.0;
  for (std::size_t c = 0; c < checks.size(); ++c) {
    const double scale = slopes.row(checks[c].row).head(z.size() - 1).cwiseAbs().maxCoeff();
    for (std::size_t v = 0; v < variables; ++v) worst = std::max(worst, difference[c * variables + v] / scale);
  }
  return worst;
}

}  // namespace apc::design
