#include "apc/learning/free_fit.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/learning/bounded_step.h"
#include "apc/learning/shapes.h"

namespace apc::learning {
namespace {

using effects::Applied;
using Misfits = std::vector<Eigen::VectorXd>;

constexpr int rounds = 8;
constexpr double settled = 0.05;  ///< a fall of O that is not worth another round
constexpr double widest = 6.0;    ///< deviations of the strength
constexpr int search_cycles = 4;

double square_of(const Misfits& misfits) {
  double sum = 0.0;
  for (const auto& m : misfits) sum += m.squaredNorm();
  return std::max(1e-12, sum);
}

/// One unknown of a fit: its prior, its bounds, a step for differences: wide, because the bounce makes S rough.
struct Unknown {
  enum class Kind { strength, amplitude, level };
  Kind kind = Kind::strength;
  std::size_t index = 0;  ///< of the effect or the run
  double mean = 0.0, deviation = 1.0, low = -1.0, high = 1.0, step = 0.01;
};

std::vector<Unknown> unknowns_of(const FreeRuns& f, const std::vector<Applied>& effects, const std::vector<char>& use) {
  const double sigma = f.data->bed_strength;
  std::vector<Unknown> list = {{Unknown::Kind::strength, 0, 0.0, sigma, -widest * sigma, widest * sigma, 0.5 * sigma}};
  for (std::size_t e = 0; e < effects.size(); ++e) {
    if (effects[e].effect.fine) continue;
    const effects::Parameter& p = effects[e].effect.parameters.front();
    const double below = amplitude_positive(p) ? p.neutral : p.neutral - 2.0 * (p.neutral - p.low);
    list.push_back({Unknown::Kind::amplitude, e, p.neutral, amplitude_deviation(p), std::min(below, p.neutral),
                    p.neutral + 2.0 * std::max(0.0, p.high - p.neutral), 0.2 * std::abs(p.usual - p.neutral)});
  }
  for (std::size_t r = 0; r < f.samples.size(); ++r)
    if ((use.empty() || use[r]) && f.samples[r].size > 0) {
      const double own = f.level_deviation[r];
      list.push_back({Unknown::Kind::level, r, 0.0, own, -widest * own, widest * own, 0.5 * own});
    }
  return list;
}

struct State {
  double strength = 0.0;
  std::vector<Applied> effects;
  std::vector<double> levels;
  double& value(const Unknown& u) {
    if (u.kind == Unknown::Kind::strength) return strength;
    return u.kind == Unknown::Kind::level ? levels[u.index] : effects[u.index].values.front();
  }
};

double prior_of(const std::vector<Unknown>& unknowns, State s) {
  double sum = 0.0;
  for (const Unknown& u : unknowns) sum += std::pow((s.value(u) - u.mean) / u.deviation, 2);
  return sum;
}

State state_of(const FreeFit& fit) { return {fit.strength, fit.effects, fit.levels}; }

/// Misfits, S and O there.
FreeFit evaluated(const FreeRuns& f, const std::vector<Unknown>& unknowns, const State& at, const Told& told,
                  const std::vector<char>& use) {
  FreeFit fit;
  fit.strength = at.strength, fit.effects = at.effects, fit.levels = at.levels;
  fit.misfit = free_misfits(f, at.strength, at.effects, use, at.levels);
  fit.square = square_of(fit.misfit);
  fit.objective = told.objective(fit.square) + prior_of(unknowns, at);
  return fit;
}

/// `fit` where `other` lies no lower; its covariance stays.
bool improve(FreeFit& fit, FreeFit other) {
  if (other.objective >= fit.objective) return false;
  other.covariance = std::move(fit.covariance);
  fit = std::move(other);
  return true;
}

/// ½ of the curvature of O and its downhill slope.
struct Slope {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

Slope slope_at(const FreeRuns& f, const std::vector<Unknown>& unknowns, State here, const FreeFit& fit,
               const Told& told, const std::vector<char>& use) {
  const auto n = static_cast<Eigen::Index>(unknowns.size());
  std::vector<Misfits> columns;
  for (const Unknown& u : unknowns) {
    if (u.kind == Unknown::Kind::level) {  // the strength, but of one run
      Misfits one = columns.front();
      for (std::size_t r = 0; r < one.size(); ++r)
        if (r != u.index) one[r].setZero();
      columns.push_back(std::move(one));
      continue;
    }
    State moved = here;
    double& value = moved.value(u);
    const double step = value + u.step > u.high ? -u.step : u.step;
    value += step;
    columns.push_back(free_misfits(f, moved.strength, moved.effects, use, moved.levels));
    for (std::size_t r = 0; r < fit.misfit.size(); ++r) columns.back()[r] = (fit.misfit[r] - columns.back()[r]) / step;
  }
  Slope slope{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  const double weight = told.weight(fit.square);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Misfits& a = columns[static_cast<std::size_t>(i)];
    for (std::size_t r = 0; r < fit.misfit.size(); ++r) {
      slope.gradient[i] += weight * a[r].dot(fit.misfit[r]);
      for (Eigen::Index j = 0; j < n; ++j)
        slope.information(i, j) += weight * a[r].dot(columns[static_cast<std::size_t>(j)][r]);
    }
    const Unknown& u = unknowns[static_cast<std::size_t>(i)];
    const double precision = 1.0 / (u.deviation * u.deviation);
    slope.information(i, i) += precision, slope.gradient[i] -= precision * (here.value(u) - u.mean);
  }
  return slope;
}

Eigen::VectorXd step_within(const std::vector<Unknown>& unknowns, State here, const Slope& slope) {
  Eigen::VectorXd low(slope.gradient.size()), high(slope.gradient.size());
  for (Eigen::Index i = 0; i < low.size(); ++i) {
    const Unknown& u = unknowns[static_cast<std::size_t>(i)];
    low[i] = u.low - here.value(u), high[i] = u.high - here.value(u);
  }
  return bounded_step(slope.information, slope.gradient, low, high);
}

/// `here` with the levels of `other` in those runs that gain by them: a level is felt by its own run alone.
FreeFit lower_run_by_run(const FreeRuns& f, const std::vector<Unknown>& unknowns, const FreeFit& here,
                         const FreeFit& other, const Told& told) {
  FreeFit mixed = here;
  for (std::size_t r = 0; r < here.misfit.size(); ++r) {
    if (here.misfit[r].size() == 0) continue;
    const auto share = [&](const FreeFit& fit) {
      return told.weight(here.square) * fit.misfit[r].squaredNorm() + std::pow(fit.levels[r] / f.level_deviation[r], 2);
    };
    if (share(other) < share(here)) mixed.levels[r] = other.levels[r], mixed.misfit[r] = other.misfit[r];
  }
  mixed.square = square_of(mixed.misfit);
  mixed.objective = told.objective(mixed.square) + prior_of(unknowns, state_of(mixed));
  return mixed;
}

}  // namespace

double Told::objective(double square) const {
  return numbers * (square > runs ? std::log(square) : std::log(runs) + square / runs - 1.0);
}

double Told::weight(double square) const { return numbers / std::max(square, runs); }

Told told_by(const FreeRuns& f, const std::vector<char>& use) {
  Told told;
  for (std::size_t r = 0; r < f.samples.size(); ++r)
    if ((use.empty() || use[r]) && f.samples[r].size > 0) {
      told.numbers += std::min(told_by_a_run, static_cast<double>(f.samples[r].size));
      told.runs += 1.0;
    }
  return told;
}

FreeFit fit_free(const FreeRuns& f, const std::vector<Applied>& start, double strength, const std::vector<char>& use) {
  const std::vector<Unknown> unknowns = unknowns_of(f, start, use);
  const Told told = told_by(f, use);
  FreeFit fit = evaluated(f, unknowns, {strength, start, std::vector<double>(f.samples.size(), 0.0)}, told, use);
  Slope slope;
  for (int round = 0; round < rounds; ++round) {
    const State here = state_of(fit);
    slope = slope_at(f, unknowns, here, fit, told, use);
    const Eigen::VectorXd step = step_within(unknowns, here, slope);
    const double before = fit.objective;
    bool fell = false;
    for (double share = 1.0; share > 0.2 && !fell; share *= 0.5) try {
        State trial = here;
        for (std::size_t k = 0; k < unknowns.size(); ++k)
          trial.value(unknowns[k]) = std::clamp(trial.value(unknowns[k]) + share * step[static_cast<Eigen::Index>(k)],
                                                unknowns[k].low, unknowns[k].high);
        fell = improve(fit, evaluated(f, unknowns, trial, told, use));
      } catch (const SolveError&) {
        continue;  // a shorter step
      }
    if (!fell || before - fit.objective < settled) break;
  }
  fit.covariance =
      slope.information.llt().solve(Eigen::MatrixXd::Identity(slope.information.rows(), slope.information.cols()));
  return fit;
}

FreeFit searched(const FreeRuns& f, FreeFit fit, const std::vector<char>& use) {
  const std::vector<Unknown> unknowns = unknowns_of(f, fit.effects, use);
  const Told told = told_by(f, use);
  double reach = 1.0;
  for (int cycle = 0; cycle < search_cycles; ++cycle) {
    bool fell = false;
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      if (unknowns[k].kind == Unknown::Kind::level) continue;
      const auto i = static_cast<Eigen::Index>(k);
      for (const double sign : {1.0, -1.0}) try {
          State trial = state_of(fit);
          double& value = trial.value(unknowns[k]);
          value = std::clamp(value + sign * reach * std::sqrt(fit.covariance(i, i)), unknowns[k].low, unknowns[k].high);
          if (improve(fit, evaluated(f, unknowns, trial, told, use))) {
            fell = true;
            break;
          }
        } catch (const SolveError&) {
          continue;  // the other way
        }
    }
    for (const double sign : {1.0, -1.0}) try {
        State all = state_of(fit);
        for (std::size_t r = 0; r < all.levels.size(); ++r) all.levels[r] += sign * reach * 0.5 * f.level_deviation[r];
        fell |= improve(fit, lower_run_by_run(f, unknowns, fit, evaluated(f, unknowns, all, told, use), told));
      } catch (const SolveError&) {
        continue;
      }
    if (!fell) reach *= 0.5;
  }
  return fit;
}

FreeFit fit_strength(const FreeRuns& f, const std::vector<char>& use) {
  const double sigma = f.data->bed_strength;
  const Told told = told_by(f, use);
  double best = 0.0, lowest = 1e300;
  for (const double deviations : {0.0, -1.5, 1.5, -3.0, 3.0}) try {
      const double objective =
          told.objective(square_of(free_misfits(f, deviations * sigma, {}, use))) + deviations * deviations;
      if (objective < lowest) lowest = objective, best = deviations * sigma;
    } catch (const SolveError&) {
      if (deviations == 0.0) throw;
    }
  return fit_free(f, {}, best, use);
}

double log_evidence_of(const FreeFit& with, const FreeFit& without) {
  double value = 0.5 * (without.objective - with.objective) +
                 0.5 * std::log(with.covariance.determinant() / without.covariance.determinant());
  for (const Applied& a : with.effects) {
    if (a.effect.fine) continue;
    const effects::Parameter& p = a.effect.parameters.front();
    value -= std::log(amplitude_deviation(p));
    if (amplitude_positive(p)) value += std::log(2.0);
  }
  return value;
}

}  // namespace apc::learning
