#include "apc/design/program.h"

#include <algorithm>
#include <numeric>

namespace apc::design {

const char* text(Objective objective) {
  switch (objective) {
    case Objective::length:
      return "length";
    case Objective::volume:
      return "volume";
    case Objective::minimax:
      return "minimax";
    default:
      return "speed";
  }
}

namespace {

bool free_ramp(const BedSpace& space) { return space.maximum_ramp > space.minimum_ramp; }
bool free_depth(const BedSpace& space) { return space.maximum_depth > space.minimum_depth; }

double share(double value, double low, double high) { return (value - low) / (high - low); }

}  // namespace

Eigen::VectorXd point_of(const BedSpace& space, const Profile& profile, double extra) {
  std::vector<double> z;
  if (free_ramp(space)) z.push_back(share(profile.ramp, space.minimum_ramp, space.maximum_ramp));
  if (free_depth(space))
    for (const double depth : profile.depth) z.push_back(share(depth, space.minimum_depth, space.maximum_depth));
  z.push_back(extra);
  return Eigen::Map<Eigen::VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
}

Profile profile_of(const BedSpace& space, const Eigen::VectorXd& z, double reference) {
  Profile profile{space.minimum_ramp, reference,
                  std::vector<double>(static_cast<std::size_t>(space.nodes), space.minimum_depth)};
  Eigen::Index next = 0;
  if (free_ramp(space)) profile.ramp += z[next++] * (space.maximum_ramp - space.minimum_ramp);
  if (free_depth(space))
    for (double& depth : profile.depth) depth += z[next++] * (space.maximum_depth - space.minimum_depth);
  return profile;
}

namespace {

/// One point's values appended in the order of the names.
class Writer {
 public:
  Writer(const Evaluator& evaluator, const Aim& aim) : evaluator_(evaluator), aim_(aim) {}

  std::vector<Constraint> names() const {
    const auto& problem = evaluator_.problem();
    std::vector<Constraint> out;
    const auto like = profile_of(problem.fleet.bed, Eigen::VectorXd::Zero(problem.fleet.bed.nodes + 2), aim_.reference);
    const auto watch = watch_of(like);
    for (const std::size_t k : aim_.cases) {
      if (!aim_.feasibility) out.push_back({Kind::stop, k, "", -1, ""});
      for (const auto& each : load_constraints(problem.fleet, k, problem.models[k])) {
        const auto count = static_cast<int>(windows_of(each, watch));
        for (int window = 0; window < count; ++window)
          out.push_back({each.kind, k, each.gear, count > 1 ? window : -1, ""});
      }
    }
    const auto slope = [&](const std::string& what) { out.push_back({Kind::slope, 0, "", -1, what}); };
    slope("slope of the ramp");
    for (int j = 1; j < problem.fleet.bed.nodes; ++j)
      slope("slope behind node " + std::to_string(j)), slope("falling slope behind node " + std::to_string(j));
    return out;
  }

  Eigen::VectorXd values(const Profile& profile, double extra, const std::vector<Figures>& cases) const {
    const double slack = aim_.feasibility ? extra : -aim_.reserve;
    std::vector<double> out{objective(profile, extra)};
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (!aim_.feasibility) out.push_back(stop(i, cases[i], extra));
      for (const auto& windows : cases[i].windows)
        for (const double use : windows) out.push_back(use - 1.0 - slack);
    }
    const auto& space = evaluator_.problem().fleet.bed;
    out.push_back(profile.depth.front() / profile.ramp / space.maximum_slope - 1.0);
    const auto at = profile.stations();
    for (std::size_t j = 0; j + 1 < at.size(); ++j) {
      const double slope = (profile.depth[j + 1] - profile.depth[j]) / (at[j + 1] - at[j]) / space.maximum_slope;
      out.push_back(slope - 1.0), out.push_back(-slope - 1.0);
    }
    return Eigen::Map<Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
  }

  /// How near a case comes to any of its constraints: its largest g.
  double nearest(std::size_t i, const Figures& figures, double extra) const {
    const double slack = aim_.feasibility ? extra : -aim_.reserve;
    double g = aim_.feasibility ? -1e9 : stop(i, figures, extra);
    for (const double use : figures.use) g = std::max(g, use - 1.0 - slack);
    return g;
  }

 private:
  double objective(const Profile& profile, double extra) const {
    if (aim_.feasibility || aim_.objective != Objective::volume)
      return aim_.objective == Objective::speed && !aim_.feasibility ? -extra : extra;
    const auto& space = evaluator_.problem().fleet.bed;
    return profile.section(extra * aim_.reference) / (space.maximum_depth * aim_.reference);
  }
  double stop(std::size_t i, const Figures& figures, double extra) const {
    if (aim_.objective == Objective::speed) return figures.distance / aim_.length - 1.0;
    if (aim_.objective == Objective::minimax) return figures.distance / aim_.alone[i] - extra;
    return figures.distance / aim_.reference - extra;
  }

  const Evaluator& evaluator_;
  Aim aim_;
};

/// Range of z_t.
std::pair<double, double> extra_range(const Evaluator& evaluator, const Aim& aim) {
  if (aim.feasibility) return {-1.0, 20.0};
  if (aim.objective == Objective::speed) return {0.3, 1.5};
  if (aim.objective == Objective::minimax) return {0.8, 10.0};
  // The least volume may be had far beyond the space; how long the shortest bed is, is asked without that limit.
  const double longest =
      aim.objective == Objective::volume ? evaluator.problem().fleet.bed.maximum_length : evaluator.reach();
  return {std::min(0.2, 0.5 * longest / aim.reference), longest / aim.reference};
}

}  // namespace

Program make_program(Evaluator& evaluator, const Aim& aim) {
  const auto& space = evaluator.problem().fleet.bed;
  const auto writer = Writer(evaluator, aim);
  const auto size = point_of(space, profile_of(space, Eigen::VectorXd::Zero(space.nodes + 2), 100.0), 0.0).size();
  Program program{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Ones(size), writer.names(), {}, {}};
  std::tie(program.low[size - 1], program.high[size - 1]) = extra_range(evaluator, aim);
  const auto trial_of = [&evaluator, aim](const Eigen::VectorXd& z) {
    const double factor = aim.objective == Objective::speed && !aim.feasibility ? z[z.size() - 1] : 1.0;
    return Trial{profile_of(evaluator.problem().fleet.bed, z, aim.reference), factor};
  };
  const auto evaluate = [&evaluator, aim, writer, trial_of](const std::vector<Eigen::VectorXd>& points,
                                                            const std::vector<std::size_t>& members,
                                                            const std::vector<Figures>& others) {
    std::vector<Trial> trials;
    std::vector<std::size_t> cases;
    for (const auto& z : points) trials.push_back(trial_of(z));
    for (const auto i : members) cases.push_back(aim.cases[i]);
    const auto all = evaluator.run(trials, cases);
    std::vector<Eigen::VectorXd> out;
    for (std::size_t p = 0; p < points.size(); ++p) {
      auto figures = others;
      for (std::size_t i = 0; i < members.size(); ++i) figures[members[i]] = all[p][i];
      out.push_back(writer.values(trials[p].profile, points[p][points[p].size() - 1], figures));
    }
    return out;
  };
  std::vector<std::size_t> everyone(aim.cases.size());
  std::iota(everyone.begin(), everyone.end(), std::size_t{0});
  program.evaluate = [evaluate, everyone](const std::vector<Eigen::VectorXd>& points) {
    return evaluate(points, everyone, std::vector<Figures>(everyone.size()));
  };
  program.evaluate_near = [&evaluator, aim, writer, trial_of, evaluate](const Eigen::VectorXd& z,
                                                                        const std::vector<Eigen::VectorXd>& points) {
    constexpr double far = 0.15;
    const auto here = evaluator.run({trial_of(z)}, aim.cases).front();
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < here.size(); ++i)
      if (writer.nearest(i, here[i], z[z.size() - 1]) > -far) near.push_back(i);
    return evaluate(points, near, here);
  };
  return program;
}

Program nearby(const Program& whole, const std::vector<Eigen::VectorXd>& points, double near) {
  const auto all = whole.evaluate(points);
  std::vector<Eigen::Index> rows{0};
  Program part{whole.low, whole.high, {}, {}, {}};
  for (std::size_t i = 0; i < whole.constraints.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i) + 1;
    const auto kind = whole.constraints[i].kind;
    const bool kept = kind == Kind::stop || kind == Kind::slope ||
                      std::any_of(all.begin(), all.end(), [&](const auto& values) { return values[row] > -near; });
    if (kept) rows.push_back(row), part.constraints.push_back(whole.constraints[i]);
  }
  const auto chosen = [rows](const std::vector<Eigen::VectorXd>& values) {
    std::vector<Eigen::VectorXd> out;
    for (const auto& each : values) out.push_back(each(rows));
    return out;
  };
  part.evaluate = [chosen, of = whole.evaluate](const auto& z) { return chosen(of(z)); };
  part.evaluate_near = [chosen, of = whole.evaluate_near](const auto& z, const auto& trials) {
    return chosen(of(z, trials));
  };
  return part;
}

Eigen::MatrixXd jacobian(const Program& program, const Eigen::VectorXd& z, double step, Differences kind) {
  std::vector<Eigen::VectorXd> points{z};
  std::vector<double> sign;
  for (Eigen::Index j = 0; j < z.size(); ++j) {
    sign.push_back(z[j] + step > program.high[j] ? -1.0 : 1.0);
    points.push_back(z);
    points.back()[j] += sign.back() * step;
    if (kind == Differences::forward) continue;
    points.push_back(z);
    points.back()[j] -= sign.back() * step;
  }
  const auto values = program.evaluate_near(z, points);
  Eigen::MatrixXd out(values.front().size(), z.size());
  for (Eigen::Index j = 0; j < z.size(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    out.col(j) = kind == Differences::forward
                     ? Eigen::VectorXd((values[1 + at] - values[0]) * (sign[at] / step))
                     : Eigen::VectorXd((values[1 + 2 * at] - values[2 + 2 * at]) * (sign[at] / (2 * step)));
  }
  return out;
}

}  // namespace apc::design
