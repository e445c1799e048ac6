#include "baselines.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/weighing.h"
#include "sparse_regression.h"

namespace scoring {
namespace {

using namespace apc;
using namespace apc::learning;
using effects::Applied;

/// Nominal free runs of the training runs; held-out runs follow without.
Study nominal(const Case& data) {
  Study study;
  Background& b = study.background;
  b.data = &data;
  b.runs = data.runs;
  b.training = data.runs.size();
  b.runs.insert(b.runs.end(), data.held_out.begin(), data.held_out.end());
  b.layout = make_layout(data, b.runs);
  b.eta = prior_mean(b.layout, b.runs);
  b.traces.resize(b.runs.size());
  for (std::size_t r = 0; r < b.training; ++r) {
    b.rows.push_back(make_rows(b.runs[r], data));
    b.measured.push_back(measured(b.runs[r], b.rows.back()));
    b.traces[r] = simulate_run(data, b.layout, r, b.runs[r], b.eta, {});
  }
  return study;
}

void claim(Study& study, Verdict verdict, const std::vector<std::pair<Applied, double>>& list) {
  Diagnosis& d = study.diagnosis;
  d.verdict = verdict;
  std::vector<std::string> ids;
  for (const auto& [applied, probability] : list) {
    Claim c;
    c.id = applied.effect.id, c.probability = probability, c.applied = applied;
    c.deviation.assign(applied.values.size(), std::nan(""));
    for (std::size_t r = 0; r < study.background.training; ++r)
      c.work[study.background.runs[r].id] = work_of(study.background, r, applied);
    d.claims.push_back(std::move(c));
    if (probability < 0.5) continue;
    ids.push_back(applied.effect.id);
    d.augmented.push_back(applied);
  }
  std::sort(ids.begin(), ids.end());
  d.set90 = {ids};
}

double end_of(const Case& data, const Background& b) {
  double longest = 0.0;
  for (std::size_t r = 0; r < b.training; ++r)
    longest = std::max(longest, std::min(b.traces[r].stop, data.bed.length()));
  return longest;
}

/// Readings over their quoted noise.
void divide_by_noise(const Run& run, const Rows& rows, Eigen::MatrixXd& m) {
  for (std::size_t c = 0; c < run.channels.size(); ++c)
    m.middleRows(rows.channel_start[c], static_cast<Eigen::Index>(rows.samples[c])) /= run.channels[c].noise;
  const double rut = run.survey ? run.survey->noise : 1.0;
  m.middleRows(rows.nose_rut_start, rows.last - rows.nose_rut_start) /= rut;
  if (rows.stop || rows.exit) m.bottomRows(1) /= run.stop_noise;
}

/// One shape of one effect under white noise: gain over nothing and amplitude, nuisances (bed strength; entry speed,
/// mass and instruments of each run) fitted along with their priors.
struct Fit {
  Applied shape;
  double amplitude = 0.0, gain = 0.0;
};

std::vector<Fit> white_noise_fits(const Study& study, double& readings) {
  const Background& b = study.background;
  const Case& data = *b.data;
  Scatter scatter;
  const Eigen::VectorXd deviation = prior_deviation(b.layout, data, b.runs, scatter);
  std::vector<Applied> shapes;
  for (const auto& effect : effects::catalogue())
    for (const Applied& shape : shapes_of(effect, end_of(data, b))) shapes.push_back(shape);
  const auto n = static_cast<Eigen::Index>(shapes.size());
  Eigen::VectorXd score = Eigen::VectorXd::Zero(n), gram = score;
  readings = 0.0;
  // Run by run: the only unknown they share, the bed's strength, is fitted with each of them.
  for (std::size_t r = 0; r < b.training; ++r) {
    const Run& run = b.runs[r];
    const Rows& rows = b.rows[r];
    const auto read = [&](const Trace& trace) {
      return predict(run, rows, trace, b.layout.runs[r], b.eta, data.aircraft);
    };
    const Eigen::VectorXd base = read(b.traces[r]);
    Eigen::MatrixXd misfit = b.measured[r] - base;
    const RunLayout& at = b.layout.runs[r];
    std::vector<Eigen::Index> simulated = {b.layout.bed_strength, at.entry_speed, at.mass};
    const Eigen::MatrixXd instruments = instrument_columns(run, rows, b.traces[r], at, b.eta, data.aircraft);
    const auto own = instrument_indices(at);
    Eigen::MatrixXd S(rows.size, static_cast<Eigen::Index>(simulated.size() + own.size())), E(rows.size, n);
    for (std::size_t k = 0; k < simulated.size(); ++k) {
      Eigen::VectorXd eta = b.eta;
      const double step = 0.5 * deviation[simulated[k]];
      eta[simulated[k]] += step;
      S.col(static_cast<Eigen::Index>(k)) =
          (read(simulate_run(data, b.layout, r, run, eta, {})) - base) / step * deviation[simulated[k]];
    }
    for (std::size_t k = 0; k < own.size(); ++k)
      S.col(static_cast<Eigen::Index>(simulated.size() + k)) =
          instruments.col(static_cast<Eigen::Index>(k)) * deviation[own[k]];
    for (Eigen::Index j = 0; j < n; ++j) {
      Applied one = shapes[static_cast<std::size_t>(j)];
      const effects::Parameter& p = one.effect.parameters.front();
      const double step = 0.3 * (p.usual - p.neutral);
      one.values.front() = p.neutral + step;
      try {
        E.col(j) = (read(simulate_run(data, b.layout, r, run, b.eta, {one})) - base) / step;
      } catch (const SolveError&) {
        E.col(j).setZero();
      }
    }
    divide_by_noise(run, rows, misfit), divide_by_noise(run, rows, S), divide_by_noise(run, rows, E);
    const Eigen::MatrixXd M = S.transpose() * S + Eigen::MatrixXd::Identity(S.cols(), S.cols());
    const Eigen::LLT<Eigen::MatrixXd> factor(M);
    const Eigen::MatrixXd projected = E - S * factor.solve(S.transpose() * E);
    score += projected.transpose() * misfit;
    gram += projected.cwiseProduct(E).colwise().sum().transpose();
    readings += static_cast<double>(rows.size);
  }
  std::vector<Fit> fits;
  for (Eigen::Index j = 0; j < n; ++j) {
    const effects::Parameter& p = shapes[static_cast<std::size_t>(j)].effect.parameters.front();
    if (!(gram[j] > 0.0)) continue;
    const double amplitude = std::clamp(score[j] / gram[j], std::min(p.low, p.neutral) - p.neutral, p.high - p.neutral);
    Fit fit{shapes[static_cast<std::size_t>(j)], amplitude,
            2.0 * amplitude * score[j] - amplitude * amplitude * gram[j]};
    fit.shape.values.front() = p.neutral + amplitude;
    fits.push_back(fit);
  }
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& x, const Fit& y) { return x.gain > y.gain; });
  return fits;
}

void by_bic(Study& study) {
  double readings = 0.0;
  const auto fits = white_noise_fits(study, readings);
  const double price = std::log(std::max(2.0, readings));
  // One shape an effect; probabilities from the differences of BIC, equal priors.
  std::vector<std::pair<Applied, double>> list;
  double highest = 0.0;
  for (const Fit& fit : fits) {
    const double value = 0.5 * (fit.gain - price * static_cast<double>(fit.shape.values.size()));
    if (std::none_of(list.begin(), list.end(), [&](const auto& x) { return x.first.effect.id == fit.shape.effect.id; }))
      list.emplace_back(fit.shape, value), highest = std::max(highest, value);
  }
  double sum = std::exp(-highest);
  for (const auto& [shape, value] : list) sum += std::exp(value - highest);
  for (auto& [shape, value] : list) value = std::exp(value - highest) / sum;
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
  std::erase_if(list, [](const auto& x) { return x.second < 0.02; });
  claim(study, list.empty() || list.front().second < 0.5 ? Verdict::nothing : Verdict::found, list);
}

/// Strength and sizes from free runs, as `apc diagnose` has them; but what is claimed is added unasked, whether runs
/// left out become better or not.
void add_unasked(Study& study) {
  study.free.emplace().runs = free_runs(*study.background.data, 0);
  study.free->none = fit_strength(study.free->runs);
  study.strength = study.free->none.strength;
  if (study.diagnosis.augmented.empty()) return;
  try {
    const FreeFit fit = fit_free(study.free->runs, study.diagnosis.augmented, study.strength);
    study.diagnosis.augmented = fit.effects, study.strength = fit.strength;
  } catch (const SolveError&) {
    // its own sizes stay
  }
  study.held_out.runs.emplace_back();
  study.held_out.before = 1.0;
}

}  // namespace

const char* name_of(Baseline baseline) {
  static const char* const names[] = {"always_nothing", "always_inertial", "white_noise_bic", "sparse_regression"};
  return names[static_cast<std::size_t>(baseline)];
}

Study answer_of(Baseline baseline, const Case& data) {
  Study study = nominal(data);
  switch (baseline) {
    case Baseline::always_nothing:
      claim(study, Verdict::nothing, {});
      break;
    case Baseline::always_inertial: {
      double readings = 0.0;
      for (const Fit& fit : white_noise_fits(study, readings))
        if (fit.shape.effect.id == "inertial") claim(study, Verdict::found, {{fit.shape, 0.9}});
      break;
    }
    case Baseline::white_noise_bic:
      by_bic(study);
      break;
    case Baseline::sparse_regression:
      if (const auto list = sparse_regression(study.background); list.empty())
        claim(study, Verdict::nothing, {});
      else
        claim(study, Verdict::found, list);
      break;
  }
  add_unasked(study);
  return study;
}

}  // namespace scoring
