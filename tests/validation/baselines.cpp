#include "baselines.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/weighing.h"

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

/// Speed, its slope and the place of the nose wheel from the speed record alone: straight lines over ± 0.25 s.
struct Point {
  double time = 0.0, place = 0.0, speed = 0.0, slope = 0.0;
};

std::vector<Point> differentiated(const Run& run) {
  std::vector<Point> list;
  const Channel* c = run.find(Quantity::speed);
  if (!c) return list;
  double place = 0.0;
  for (std::size_t i = 1; i < c->time.size(); ++i) {
    if (c->time[i] <= 0.0) continue;
    place += 0.5 * (c->value[i] + c->value[i - 1]) * (c->time[i] - std::max(0.0, c->time[i - 1]));
    double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
    for (std::size_t k = 0; k < c->time.size(); ++k) {
      const double d = c->time[k] - c->time[i];
      if (std::abs(d) <= 0.25) n += 1.0, t += d, v += c->value[k], tt += d * d, tv += d * c->value[k];
    }
    const double spread = n * tt - t * t;
    if (n < 3.0 || spread <= 0.0 || c->value[i] < 4.0) continue;
    list.push_back({c->time[i], place, (v * tt - t * tv) / spread, (n * tv - t * v) / spread});
  }
  return list;
}

void by_sparse_regression(Study& study) {
  const Background& b = study.background;
  const Case& data = *b.data;
  std::vector<Applied> terms;
  for (const char* id : {"inertial", "wall_tear", "adhesion", "rubble_friction", "debris", "cover", "slope", "aero",
                         "thrust", "softening", "rate"})
    terms.push_back(effects::applied(effects::find_effect(effects::catalogue(), id),
                                     effects::find_effect(effects::catalogue(), id).parameters.front().usual));
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> lacking;
  for (std::size_t r = 0; r < b.training; ++r) {
    const simulation::History& h = b.traces[r].result.history;
    for (const Point& p : differentiated(b.runs[r])) {
      const auto i = static_cast<std::size_t>(std::lower_bound(h.distance.begin(), h.distance.end(), p.place) -
                                              h.distance.begin());
      if (i + 1 >= h.time.size()) continue;
      // Force each term adds at its usual size, at the model's penetration and the measured speed.
      Eigen::VectorXd row(static_cast<Eigen::Index>(terms.size()));
      const double mass = b.runs[r].overrun.mass;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Applied& term = terms[k];
        double force = 0.0;
        for (std::size_t g = 0; g < data.aircraft.gears.size(); ++g) {
          const aircraft::Gear& gear = data.aircraft.gears[g];
          const aircraft::Tire& tire = data.aircraft.tires.at(gear.tire);
          const double density = data.bed.nominal ? data.bed.nominal->density : 320.0;
          effects::Alterations plain, with;
          with.effects = {term};
          const effects::TireFacts facts{g, gear.is_nose(), gear.wheels(), tire.width, tire.radius(), density};
          const effects::TirePlace place{{p.speed, h.gears[g].bed_depth[i], h.gears[g].penetration[i]},
                                         h.gears[g].distance[i],
                                         h.distance[i],
                                         p.time};
          if (term.effect.bed || term.effect.force)
            force += gear.wheels() * (effects::load(data.tables[g], with, facts, place).drag -
                                      effects::load(data.tables[g], plain, facts, place).drag);
        }
        if (term.effect.thrust) force -= term.effect.thrust(p.time, term.values);
        if (term.effect.id == "slope") force += mass * units::g0 * term.values.front();
        if (term.effect.id == "aero") force += 0.5 * 1.225 * term.values.front() * p.speed * p.speed;
        row[static_cast<Eigen::Index>(k)] = force / mass;
      }
      rows.push_back(row);
      lacking.push_back(-p.slope - h.deceleration[i]);
    }
  }
  if (rows.size() < 20) return claim(study, Verdict::nothing, {});
  Eigen::MatrixXd X(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(terms.size()));
  Eigen::VectorXd y(X.rows());
  for (Eigen::Index i = 0; i < X.rows(); ++i)
    X.row(i) = rows[static_cast<std::size_t>(i)], y[i] = lacking[static_cast<std::size_t>(i)];
  // Sequentially thresholded: coefficients are in usual sizes; below a fifth of one a term goes.
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < terms.size(); ++k) kept.push_back(k);
  Eigen::VectorXd coefficient;
  for (int round = 0; round < 10 && !kept.empty(); ++round) {
    Eigen::MatrixXd K(X.rows(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k)
      K.col(static_cast<Eigen::Index>(k)) = X.col(static_cast<Eigen::Index>(kept[k]));
    coefficient =
        (K.transpose() * K + 1e-3 * Eigen::MatrixXd::Identity(K.cols(), K.cols())).ldlt().solve(K.transpose() * y);
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const effects::Parameter& p = terms[kept[k]].effect.parameters.front();
      const double size = coefficient[static_cast<Eigen::Index>(k)];
      if (std::abs(size) > 0.2 && (size > 0.0 || !amplitude_positive(p))) left.push_back(kept[k]);
    }
    if (left.size() == kept.size()) break;
    kept = left;
  }
  std::vector<std::pair<Applied, double>> list;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    Applied one = terms[kept[k]];
    const effects::Parameter& p = one.effect.parameters.front();
    one.values.front() = std::clamp(coefficient[static_cast<Eigen::Index>(k)] * p.usual, p.low, p.high);
    list.emplace_back(one, 0.9);
  }
  // The two that move the force most.
  const auto weight = [&](const Applied& a) {
    for (std::size_t k = 0; k < terms.size(); ++k)
      if (terms[k].effect.id == a.effect.id)
        return std::abs(a.values.front() / a.effect.parameters.front().usual) *
               X.col(static_cast<Eigen::Index>(k)).norm();
    return 0.0;
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const auto& x, const auto& z) { return weight(x.first) > weight(z.first); });
  if (list.size() > 2) list.resize(2);
  claim(study, list.empty() ? Verdict::nothing : Verdict::found, list);
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
      by_sparse_regression(study);
      break;
  }
  return study;
}

}  // namespace scoring
