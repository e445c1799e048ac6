#include "apc/learning/next_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/learning/bounded_step.h"
#include "apc/learning/shapes.h"

namespace apc::learning {
namespace {

using effects::Applied;

Eigen::VectorXd numbers_at(const Field& f, std::size_t r, const Segments& s, const Eigen::VectorXd& eta,
                           const std::vector<Applied>& effects) {
  return simulated_features(f.runs[r], s, simulate_run(f.data, f.layout, r, f.runs[r], eta, effects), f.data.aircraft);
}

/// Unknowns that take a simulation, blocks left out: those are in the noise.
std::vector<Eigen::Index> unknowns_of(const Field& f, std::size_t r) {
  std::vector<Eigen::Index> list = f.layout.simulated(r);
  list.resize(list.size() - static_cast<std::size_t>(2 * f.layout.runs[r].blocks));
  return list;
}

}  // namespace

Run candidate_run(const Case& data, double speed, double mass) {
  Run run = data.runs.front();
  run.id = "candidate", run.lane = "candidate";
  run.overrun.entry_speed = speed;
  run.overrun.pitch_inertia *= mass / run.overrun.mass;
  run.uncertainty.pitch_inertia *= mass / run.overrun.mass, run.uncertainty.mass *= mass / run.overrun.mass;
  run.overrun.mass = mass;
  run.mass_known = true;
  run.uncertainty.mass = std::min(run.uncertainty.mass, 0.02 * mass);
  run.stop = 0.5 * data.bed.length();  // any value: there will be one
  run.exit_speed.reset();
  run.channels.clear();
  const auto add = [&](Quantity quantity, double noise, double bias, double lag, double scale) {
    Channel c;
    c.quantity = quantity, c.noise = noise, c.bias = bias, c.lag = lag, c.scale = scale;
    for (const Run& made : data.runs)
      if (const Channel* known = made.find(quantity)) {
        c = *known;
        break;
      }
    c.time.clear(), c.value.clear();
    run.channels.push_back(c);
  };
  // Where no run has the instrument: a good one of its kind.
  add(Quantity::speed, 0.1, 0.05, 0.08, 0.003);
  add(Quantity::acceleration_x, 0.03 * units::g0, 0.015 * units::g0, 0.005, 0.003);
  add(Quantity::nose_drag, 2.0 * units::kN, 1.0 * units::kN, 0.003, 0.02);
  const double noise = run.survey ? run.survey->noise : 0.015;
  run.survey = Survey{{}, {}, {}, noise};
  return run;
}

Field field_with(const Case& data, const Run& candidate) {
  Field f{data, data.runs, {}, {}, {}};
  f.runs.push_back(candidate);
  f.layout = make_layout(data, f.runs);
  Scatter scatter;
  scatter.strength = data.block_strength, scatter.correlation = data.correlation;
  f.deviation = prior_deviation(f.layout, data, f.runs, scatter);
  f.errors.block_strength = data.block_strength, f.errors.correlation = data.correlation;
  return f;
}

void differentiate(const Field& f, std::size_t r, const Eigen::VectorXd& eta, const std::vector<Applied>& effects,
                   Numbers& n) {
  n.columns = unknowns_of(f, r);
  n.by_unknown = Eigen::MatrixXd::Zero(n.value.size(), static_cast<Eigen::Index>(n.columns.size()));
  for (std::size_t k = 0; k < n.columns.size(); ++k)
    for (const double step : {0.5 * f.deviation[n.columns[k]], -0.5 * f.deviation[n.columns[k]]}) {
      Eigen::VectorXd moved = eta;
      moved[n.columns[k]] += step;
      try {
        n.by_unknown.col(static_cast<Eigen::Index>(k)) =
            (numbers_at(f, r, n.segments, moved, effects) - n.value) / step;
        break;
      } catch (const SolveError&) {
        continue;
      }
    }
}

Eigen::VectorXd by_amplitude(const Field& f, std::size_t r, const Segments& s, const Eigen::VectorXd& value,
                             const Eigen::VectorXd& eta, std::vector<Applied> effects, std::size_t which,
                             double share) {
  const effects::Parameter& p = effects[which].effect.parameters.front();
  const double side = p.usual < p.neutral ? -1.0 : 1.0, size = share * std::abs(p.usual - p.neutral);
  double& amplitude = effects[which].values.front();
  const double here = amplitude;
  for (const double step : {side * size, -side * size}) {
    amplitude = here + step;
    try {
      return (numbers_at(f, r, s, eta, effects) - value) / step;
    } catch (const SolveError&) {
      continue;
    }
  }
  return Eigen::VectorXd::Zero(value.size());
}

Eigen::MatrixXd own_covariance(const Field& f, std::size_t r, const Numbers& n) {
  Eigen::MatrixXd noise = feature_noise(f.runs[r], n.segments, n.trace, n.value, n.by_unknown.col(0),
                                        f.errors);  // simulated(): the bed's strength comes first
  for (std::size_t k = 0; k < n.columns.size(); ++k)
    if (n.columns[k] >= f.globals()) {
      const Eigen::VectorXd column = n.by_unknown.col(static_cast<Eigen::Index>(k)) * f.deviation[n.columns[k]];
      noise += column * column.transpose();
    }
  return noise;
}

Eigen::MatrixXd joint_columns(const Field& f, const Numbers& n, const std::vector<Eigen::VectorXd>& amplitudes) {
  const Eigen::Index globals = f.globals();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n.value.size(), globals + static_cast<Eigen::Index>(amplitudes.size()));
  for (std::size_t k = 0; k < n.columns.size(); ++k)
    if (n.columns[k] < f.globals()) J.col(n.columns[k]) = n.by_unknown.col(static_cast<Eigen::Index>(k));
  for (std::size_t k = 0; k < amplitudes.size(); ++k) J.col(globals + static_cast<Eigen::Index>(k)) = amplitudes[k];
  return J;
}

Training train(const Field& f, const std::vector<Applied>& effects, unsigned threads) {
  Training t;
  const std::size_t n = f.data.runs.size();
  const Eigen::VectorXd eta = Eigen::VectorXd::Zero(f.layout.size);
  t.runs.resize(n), t.measured.resize(n), t.kept.resize(n), t.factor.resize(n);
  parallel_for(n, threads, [&](std::size_t r) {
    const Run& run = f.runs[r];
    Numbers& numbers = t.runs[r];
    numbers.segments = make_segments(run, std::min(run.stop.value_or(f.data.bed.length()), f.data.bed.length()));
    numbers.trace = simulate_run(f.data, f.layout, r, run, eta, effects);
    numbers.value = simulated_features(run, numbers.segments, numbers.trace, f.data.aircraft);
    differentiate(f, r, eta, effects, numbers);
    t.measured[r] = measured_features(run, numbers.segments);
    for (Eigen::Index k = 0; k < t.measured[r].size(); ++k)
      if (std::isfinite(t.measured[r][k])) t.kept[r].push_back(k);
    const Eigen::MatrixXd all = own_covariance(f, r, numbers);
    t.factor[r].compute(all(t.kept[r], t.kept[r]));
  });
  return t;
}

namespace {

/// Unknowns of a fit: those all runs share, then amplitudes; their priors.
struct Shared {
  Eigen::VectorXd mean, weight;
};

Shared shared_prior(const Field& f, const std::vector<Applied>& effects) {
  const Eigen::Index globals = f.globals(), n = globals + static_cast<Eigen::Index>(effects.size());
  Shared prior{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  prior.weight.head(globals) = f.deviation.head(globals).cwiseAbs2().cwiseInverse();
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const effects::Parameter& p = effects[k].effect.parameters.front();
    prior.weight[globals + static_cast<Eigen::Index>(k)] = 1.0 / std::pow(amplitude_deviation(p), 2);
    prior.mean[globals + static_cast<Eigen::Index>(k)] = p.neutral;
  }
  return prior;
}

Eigen::VectorXd place_of(const Field& f, const Contender& c) {
  Eigen::VectorXd here(f.globals() + static_cast<Eigen::Index>(c.effects.size()));
  here.head(f.globals()) = c.eta.head(f.globals());
  for (std::size_t k = 0; k < c.effects.size(); ++k)
    here[f.globals() + static_cast<Eigen::Index>(k)] = c.effects[k].values.front();
  return here;
}

/// Range of an amplitude: as in fits through the simulator, twice the catalogue's.
std::array<double, 2> bounds(const effects::Parameter& p) {
  const double below = amplitude_positive(p) ? p.neutral : p.neutral - 2.0 * (p.neutral - p.low);
  return {std::min(below, p.neutral), p.neutral + 2.0 * std::max(0.0, p.high - p.neutral)};
}

/// Amplitudes stay inside their ranges.
Eigen::VectorXd step_within(const Field& f, const Contender& c, const Eigen::MatrixXd& information,
                            const Eigen::VectorXd& gradient) {
  const double none = std::numeric_limits<double>::infinity();
  Eigen::VectorXd low = Eigen::VectorXd::Constant(gradient.size(), -none), high = -low;
  for (std::size_t k = 0; k < c.effects.size(); ++k) {
    const Eigen::Index i = f.globals() + static_cast<Eigen::Index>(k);
    const auto [lowest, highest] = bounds(c.effects[k].effect.parameters.front());
    low[i] = lowest - c.effects[k].values.front(), high[i] = highest - c.effects[k].values.front();
  }
  return bounded_step(information, gradient, low, high);
}

/// `from` moved; no unknown further than three deviations from what is known of it, amplitudes inside their ranges.
Contender moved(const Field& f, const Contender& from, const Eigen::VectorXd& step) {
  Contender c = from;
  for (Eigen::Index k = 0; k < f.globals(); ++k)
    c.eta[k] = std::clamp(c.eta[k] + step[k], -3.0 * f.deviation[k], 3.0 * f.deviation[k]);
  for (std::size_t k = 0; k < c.effects.size(); ++k) {
    const effects::Parameter& p = c.effects[k].effect.parameters.front();
    double& amplitude = c.effects[k].values.front();
    const auto [low, high] = bounds(p);
    amplitude = std::clamp(amplitude + step[f.globals() + static_cast<Eigen::Index>(k)], low, high);
  }
  return c;
}

/// Numbers and whitened misfits of all runs at hand; what they and the prior have against the contender.
struct Seen {
  std::vector<Eigen::VectorXd> value, misfit;
  double square = 0.0, objective = 0.0;
};

Seen look(const Field& f, const Training& t, const Shared& prior, const Contender& c, unsigned threads) {
  Seen seen;
  seen.value.resize(t.runs.size()), seen.misfit.resize(t.runs.size());
  parallel_for(t.runs.size(), threads, [&](std::size_t r) {
    seen.value[r] = numbers_at(f, r, t.runs[r].segments, c.eta, c.effects);
    seen.misfit[r] = t.factor[r].matrixL().solve(Eigen::VectorXd((t.measured[r] - seen.value[r])(t.kept[r])));
  });
  for (const auto& m : seen.misfit) seen.square += m.squaredNorm();
  seen.objective = seen.square + (prior.weight.array() * (place_of(f, c) - prior.mean).array().square()).sum();
  return seen;
}

}  // namespace

Fitted fit(const Field& f, const Training& t, const std::vector<Applied>& effects, unsigned threads, int rounds) {
  const Shared prior = shared_prior(f, effects);
  Fitted result{{effects, Eigen::VectorXd::Zero(f.layout.size), 0.0}, {}};
  Contender& c = result.contender;
  Seen seen = look(f, t, prior, c, threads);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Eigen::MatrixXd> J(t.runs.size());
    parallel_for(t.runs.size(), threads, [&](std::size_t r) {
      std::vector<Eigen::VectorXd> amplitudes;
      for (std::size_t k = 0; k < effects.size(); ++k)
        amplitudes.push_back(
            by_amplitude(f, r, t.runs[r].segments, seen.value[r], c.eta, c.effects, k, rounds == 1 ? 1.0 : 0.3));
      const Eigen::MatrixXd all = joint_columns(f, t.runs[r], amplitudes);
      J[r] = t.factor[r].matrixL().solve(Eigen::MatrixXd(all(t.kept[r], Eigen::all)));
    });
    Eigen::MatrixXd information = prior.weight.asDiagonal();
    Eigen::VectorXd gradient = -(prior.weight.array() * (place_of(f, c) - prior.mean).array());
    for (std::size_t r = 0; r < J.size(); ++r)
      information += J[r].transpose() * J[r], gradient += J[r].transpose() * seen.misfit[r];
    const Eigen::LLT<Eigen::MatrixXd> factor(information);
    result.covariance = factor.solve(Eigen::MatrixXd::Identity(information.rows(), information.rows()));
    if (round + 1 == rounds) break;  // the last round is for the covariance
    const Eigen::VectorXd step = step_within(f, c, information, gradient);
    bool fell = false;
    for (double share = 1.0; share > 0.2 && !fell; share *= 0.5) {
      try {
        const Contender trial = moved(f, c, share * step);
        Seen there = look(f, t, prior, trial, threads);
        fell = there.objective < seen.objective;
        if (fell) c = trial, seen = std::move(there);
      } catch (const SolveError&) {
        continue;  // a shorter step
      }
    }
    if (!fell) rounds = std::min(rounds, round + 2);
  }
  double count = 0.0;
  for (const auto& kept : t.kept) count += static_cast<double>(kept.size());
  c.misfit = std::sqrt(seen.square / std::max(1.0, count));
  return result;
}

Eigen::MatrixXd amplitude_spread(const Field& f, std::size_t r, const Segments& s, const Eigen::VectorXd& value,
                                 const Fitted& fitted) {
  const Contender& c = fitted.contender;
  const Eigen::Index n = static_cast<Eigen::Index>(c.effects.size()), all = fitted.covariance.rows();
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(value.size(), n);
  if (n == 0) return spread;
  // Directions of the joint posterior in which the amplitudes vary: C_·A L⁻ᵀ with C_AA = L Lᵀ.
  const Eigen::LLT<Eigen::MatrixXd> factor(fitted.covariance.bottomRightCorner(n, n));
  const Eigen::MatrixXd directions =
      factor.matrixL().solve(Eigen::MatrixXd(fitted.covariance.rightCols(n).transpose()));
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::VectorXd ends[2] = {value, value};
    for (const int side : {0, 1}) {
      Contender end = moved(f, c, (side == 0 ? 1.0 : -1.0) * directions.row(k).transpose().head(all));
      Eigen::VectorXd eta = Eigen::VectorXd::Zero(f.layout.size);
      eta.head(f.globals()) = end.eta.head(f.globals());
      try {
        ends[side] = numbers_at(f, r, s, eta, end.effects);
      } catch (const SolveError&) {
        continue;  // that end stays where the fit is
      }
    }
    spread.col(k) = 0.5 * (ends[0] - ends[1]);
  }
  return spread;
}

}  // namespace apc::learning
