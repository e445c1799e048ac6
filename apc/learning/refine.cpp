#include "apc/learning/refine.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/learning/screen.h"

namespace apc::learning {
namespace {

using effects::Applied;

/// One free parameter of the set: where it is, its prior, its bounds.
struct Free {
  std::size_t effect = 0, parameter = 0;
  double mean = 0.0, deviation = 1.0, low = 0.0, high = 1.0, step = 0.0;
  bool positive = false;
  Eigen::Index unknown = -1;  ///< the place of a run: index in eta; then `effect` and `parameter` mean nothing
  std::size_t run = 0;
};

double& value_of(const Free& f, std::vector<Applied>& set, Eigen::VectorXd& eta) {
  return f.unknown >= 0 ? eta[f.unknown] : set[f.effect].values[f.parameter];
}

/// Shapes that the data seldom tell and that would only blur the amplitude stay at their usual values.
bool kept_fixed(const std::string& effect, const std::string& parameter) {
  return (effect == "rate" && parameter == "v0") || (effect == "inertial" && parameter == "Cz") ||
         (effect == "seams" && parameter == "pitch") || (effect == "depth_as_built" && parameter == "shift");
}

std::vector<Free> free_parameters(const std::vector<Applied>& set) {
  std::vector<Free> result;
  for (std::size_t e = 0; e < set.size(); ++e)
    for (std::size_t k = 0; k < set[e].effect.parameters.size(); ++k) {
      const effects::Parameter& p = set[e].effect.parameters[k];
      if (kept_fixed(set[e].effect.id, p.name)) continue;
      Free f{e, k, 0.0, 1.0, p.low, p.high, 0.0, false, -1, 0};
      if (k == 0) {
        f.mean = p.neutral;
        f.deviation = amplitude_deviation(p);
        f.positive = amplitude_positive(p);
        f.low = p.neutral - (f.positive ? 0.0 : 2.0 * (p.neutral - p.low));
        f.high = p.neutral + 2.0 * (p.high - p.neutral);
        f.step = 0.05 * (p.high - p.low);
      } else {
        f.mean = 0.5 * (p.low + p.high);
        f.deviation = 0.5 * (p.high - p.low);
        f.step = 0.02 * (p.high - p.low);
      }
      result.push_back(f);
    }
  return result;
}

/// Where each run is along the bed, for effects finer than that is known.
void add_places(const Background& b, const std::vector<Applied>& set, std::vector<Free>& list) {
  if (std::none_of(set.begin(), set.end(), [](const Applied& a) { return a.effect.fine; })) return;
  for (std::size_t r = 0; r < b.training; ++r)
    for (const Eigen::Index unknown : {b.layout.runs[r].shift, b.layout.runs[r].stretch}) {
      const double deviation = 1.0 / std::sqrt(b.prior.precision(unknown, unknown));
      list.push_back({0, 1, 0.0, deviation, -4.0 * deviation, 4.0 * deviation, 0.05 * deviation, false, unknown, r});
    }
}

/// Of effect parameters; the places' prior is among the nuisances'.
double prior_of(const std::vector<Free>& free, const std::vector<Applied>& set) {
  double sum = 0.0;
  for (const Free& f : free)
    if (f.unknown < 0) sum += std::pow((set[f.effect].values[f.parameter] - f.mean) / f.deviation, 2);
  return sum;
}

std::vector<Applied> together(const Background& b, const std::vector<Applied>& set) {
  std::vector<Applied> all = b.added;
  all.insert(all.end(), set.begin(), set.end());
  return all;
}

double objective_of(const Background& b, const Eigen::VectorXd& eta, const std::vector<Applied>& set,
                    const std::vector<Free>& free, std::vector<Eigen::VectorXd>& misfits) {
  misfits.resize(b.training);
  const auto all = together(b, set);
  parallel_for(b.training, b.threads, [&](std::size_t r) { misfits[r] = whitened_misfit(b, r, eta, all); });
  double sum = prior_term(b, eta) + prior_of(free, set);
  for (const auto& m : misfits) sum += m.squaredNorm();
  return sum;
}

}  // namespace

std::size_t free_parameter_count(const Applied& applied) { return free_parameters({applied}).size(); }

std::vector<double> parameter_deviations(const Applied& applied, const SetFit& fit, std::size_t column) {
  std::vector<double> result(applied.values.size(), std::nan(""));
  for (const Free& f : free_parameters({applied})) result[f.parameter] = fit.deviation(column++);
  return result;
}

SetFit refine(const Background& b, const NuisanceFactor& nuisances, const std::vector<Applied>& start, int iterations,
              const std::vector<std::array<double, 2>>& places) {
  SetFit fit;
  fit.effects = start;
  fit.eta = b.eta;
  for (std::size_t r = 0; r < places.size(); ++r)
    fit.eta[b.layout.runs[r].shift] = places[r][0], fit.eta[b.layout.runs[r].stretch] = places[r][1];
  std::vector<Free> free = free_parameters(start);
  add_places(b, start, free);
  const auto n = static_cast<Eigen::Index>(free.size());
  std::vector<Eigen::VectorXd> misfits;
  fit.objective = objective_of(b, fit.eta, fit.effects, free, misfits);

  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd lambda(n);
  for (Eigen::Index k = 0; k < n; ++k) lambda[k] = 1.0 / std::pow(free[static_cast<std::size_t>(k)].deviation, 2);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    // Effect columns at the present place, by central differences (one-sided at a bound).
    std::vector<Eigen::MatrixXd> E(b.training);
    for (std::size_t r = 0; r < b.training; ++r) E[r] = Eigen::MatrixXd::Zero(b.rows[r].size, n);
    parallel_for(b.training * free.size(), b.threads, [&](std::size_t job) {
      const std::size_t r = job / free.size(), k = job % free.size();
      const Free& f = free[k];
      if (f.unknown >= 0 && f.run != r) return;
      auto up = fit.effects, down = fit.effects;
      Eigen::VectorXd eta_up = fit.eta, eta_down = fit.eta;
      double& above = value_of(f, up, eta_up);
      double& below = value_of(f, down, eta_down);
      above = std::min(above + f.step, std::max(f.high, above));
      below = std::max(below - f.step, std::min(f.low, below));
      if (above - below <= 0.0) return;
      try {
        E[r].col(static_cast<Eigen::Index>(k)) =
            -(whitened_misfit(b, r, eta_up, together(b, up)) - whitened_misfit(b, r, eta_down, together(b, down))) /
            (above - below);
      } catch (const SolveError&) {
        return;  // an impossible neighbour: no information from this run
      }
    });
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(b.layout.size, n), square = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd gradient_eta = -b.prior.precision * (fit.eta - b.prior.mean), gradient = Eigen::VectorXd::Zero(n);
    for (std::size_t r = 0; r < b.training; ++r) {
      const RunLinear& l = b.linear[r];
      const Eigen::MatrixXd part = l.S.transpose() * E[r];
      const Eigen::VectorXd pull = l.S.transpose() * misfits[r];
      for (std::size_t k = 0; k < l.columns.size(); ++k) {
        cross.row(l.columns[k]) += part.row(static_cast<Eigen::Index>(k));
        gradient_eta[l.columns[k]] += pull[static_cast<Eigen::Index>(k)];
      }
      square += E[r].transpose() * E[r];
      gradient += E[r].transpose() * misfits[r];
    }
    for (Eigen::Index k = 0; k < n; ++k) {
      const Free& f = free[static_cast<std::size_t>(k)];
      gradient[k] -= lambda[k] * (value_of(f, fit.effects, fit.eta) - f.mean);
      if (f.unknown >= 0) gradient_eta[f.unknown] = 0.0;  // moves with the effects, not with the nuisances
    }
    const Eigen::MatrixXd solved = nuisances.factor.solve(cross);
    const Eigen::VectorXd free_step = nuisances.factor.solve(gradient_eta);
    C = square + Eigen::MatrixXd(lambda.asDiagonal()) - cross.transpose() * solved;
    const Eigen::VectorXd q = C.ldlt().solve(gradient - cross.transpose() * free_step);
    const Eigen::VectorXd step = free_step - solved * q;
    bool moved = false;
    const double before = fit.objective;
    for (double share = 1.0; share > 0.1; share *= 0.4) {
      auto trial = fit.effects;
      Eigen::VectorXd eta = fit.eta + share * step;
      for (Eigen::Index k = 0; k < n; ++k) {
        const Free& f = free[static_cast<std::size_t>(k)];
        double& value = value_of(f, trial, eta);
        const double limit = f.parameter == 0 ? 1e300 : f.unknown >= 0 ? 0.5 * f.deviation : 0.2 * (f.high - f.low);
        value = std::clamp(value + std::clamp(share * q[k], -limit, limit), std::min(f.low, value),
                           std::max(f.high, value));
      }
      std::vector<Eigen::VectorXd> there;
      double after = 0.0;
      try {
        after = objective_of(b, eta, trial, free, there);
      } catch (const SolveError&) {
        continue;
      }
      if (after >= fit.objective) continue;
      fit.objective = after, fit.effects = trial, fit.eta = eta, misfits = there;
      moved = true;
      break;
    }
    if (!moved || before - fit.objective < 0.5) break;
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(C);
  fit.covariance = factor.solve(Eigen::MatrixXd::Identity(n, n));
  fit.log_evidence = -0.5 * (fit.objective - b.objective);
  const Eigen::VectorXd pivots = factor.vectorD();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Free& f = free[static_cast<std::size_t>(k)];
    fit.log_evidence += 0.5 * std::log(lambda[k]) - 0.5 * std::log(std::max(pivots[k], 1e-300));
    if (f.parameter == 0 && f.positive) fit.log_evidence += std::log(2.0);
    const double value = value_of(f, fit.effects, fit.eta);
    fit.at_bound.push_back(value <= f.low || value >= f.high);
  }
  return fit;
}

}  // namespace apc::learning
