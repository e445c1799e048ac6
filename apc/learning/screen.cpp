#include "apc/learning/screen.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/learning/seam_search.h"

namespace apc::learning {
namespace {

using effects::Applied;
using effects::Effect;

/// Whitened columns of all runs, and the products the scores need.
struct Columns {
  std::vector<Eigen::MatrixXd> per_run;  ///< rows × columns
  Eigen::Index count = 0;
};

/// What is learned when nothing else fits: drag (N, shared by the main tires) that depends on one coordinate.
Effect learned_force(const std::string& id, double centre, double half_width, bool by_speed) {
  Effect e;
  e.id = id;
  e.law = "learned";
  e.parameters = {{"f", "N", dimension::force, -5e4, 5e4, 1e4, 0.0}};
  e.force = [centre, half_width, by_speed](const effects::TireState& state, effects::Values q,
                                           effects::TireChange& change) {
    if (state.nose) return;
    const double u = std::abs((by_speed ? state.speed : state.bed_distance) - centre) / half_width;
    if (u < 1.0) change.drag += q[0] * (1.0 - u) / state.wheels * effects::in_bed(state.bed_depth);
  };
  return e;
}

double longest_way(const Background& b) {
  double longest = 0.0;
  for (std::size_t r = 0; r < b.training; ++r)
    longest = std::max(longest, std::min(b.traces[r].stop, b.data->bed.length()));
  return longest;
}

class Collector {
 public:
  explicit Collector(const Background& b) : b_(b) {
    columns_.per_run.resize(b.training);
    for (std::size_t r = 0; r < b.training; ++r) columns_.per_run[r].resize(b.rows[r].size, 0);
  }

  /// One column per applied effect, by a difference from the fit; returns the first index.
  Eigen::Index simulate(const std::vector<Applied>& list, const std::vector<double>& steps) {
    const Eigen::Index first = grow(static_cast<Eigen::Index>(list.size()));
    std::vector<Eigen::VectorXd> base(b_.training);
    for (std::size_t r = 0; r < b_.training; ++r)
      base[r] = predict(b_.runs[r], b_.rows[r], b_.traces[r], b_.layout.runs[r], b_.eta, b_.data->aircraft);
    parallel_for(list.size() * b_.training, b_.threads, [&](std::size_t job) {
      const std::size_t r = job / list.size(), k = job % list.size();
      std::vector<Applied> added = b_.added;
      added.push_back(list[k]);
      for (const double step : {steps[k], -steps[k]}) {
        added.back().values.front() = list[k].effect.parameters.front().neutral + step;
        try {
          const Trace trace = simulate_run(*b_.data, b_.layout, r, b_.runs[r], b_.eta, added, b_.guides[r]);
          Eigen::MatrixXd column =
              (predict(b_.runs[r], b_.rows[r], trace, b_.layout.runs[r], b_.eta, b_.data->aircraft) - base[r]) / step;
          whiten_rows(b_, r, column);
          columns_.per_run[r].col(first + static_cast<Eigen::Index>(k)) = column;
          break;
        } catch (const SolveError&) {
          continue;
        }
      }
    });
    return first;
  }

  /// Room for `n` columns, zero.
  Eigen::Index grow(Eigen::Index n) {
    const Eigen::Index first = columns_.count;
    columns_.count += n;
    for (auto& m : columns_.per_run) {
      m.conservativeResize(Eigen::NoChange, columns_.count);
      m.rightCols(n).setZero();
    }
    return first;
  }

  Eigen::MatrixXd& run(std::size_t r) { return columns_.per_run[r]; }

  Scores scores() const {
    const Eigen::VectorXd offset = b_.offset();
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(b_.layout.size, columns_.count),
                    plain = Eigen::MatrixXd::Zero(columns_.count, columns_.count);
    Eigen::VectorXd score = Eigen::VectorXd::Zero(columns_.count);
    double square = 0.0;
    for (std::size_t r = 0; r < b_.training; ++r) {
      const RunLinear& l = b_.linear[r];
      const Eigen::MatrixXd& F = columns_.per_run[r];
      Eigen::VectorXd local(l.S.cols());
      for (std::size_t k = 0; k < l.columns.size(); ++k) local[static_cast<Eigen::Index>(k)] = offset[l.columns[k]];
      const Eigen::VectorXd residual = l.misfit + l.S * local;
      const Eigen::MatrixXd part = l.S.transpose() * F;
      for (std::size_t k = 0; k < l.columns.size(); ++k)
        cross.row(l.columns[k]) += part.row(static_cast<Eigen::Index>(k));
      plain += F.transpose() * F;
      score += F.transpose() * residual;
      square += residual.squaredNorm();
    }
    return marginal_scores(b_.information, b_.prior.precision, cross, b_.right, plain, score, square);
  }

 private:
  const Background& b_;
  Columns columns_;
};

void add_effects(const Background& b, const std::vector<Effect>& effects, Collector& collector,
                 std::vector<Hypothesis>& list) {
  std::vector<Applied> applied;
  std::vector<double> steps;
  for (const Effect& effect : effects) {
    if (std::any_of(b.added.begin(), b.added.end(), [&](const Applied& a) { return a.effect.id == effect.id; }))
      continue;
    if (effect.fine) continue;
    const auto shapes = shapes_of(effect, longest_way(b));
    for (const Applied& shape : shapes) {
      Hypothesis h;
      h.id = effect.id;
      h.applied = shape;
      const effects::Parameter& amplitude = effect.parameters.front();
      const double sign = amplitude.usual < amplitude.neutral ? -1.0 : 1.0;
      steps.push_back(sign * 0.3 * std::abs(amplitude.usual - amplitude.neutral));
      h.candidate = {{static_cast<Eigen::Index>(applied.size())},
                     {amplitude_deviation(amplitude)},
                     {amplitude_positive(amplitude)},
                     0.0};
      // One-sided amplitudes that fall (lock_up) count downwards.
      if (sign < 0.0) h.candidate.positive = {false};
      applied.push_back(shape);
      list.push_back(std::move(h));
    }
  }
  const Eigen::Index first = collector.simulate(applied, steps);
  for (Hypothesis& h : list) h.candidate.columns.front() += first;
}

/// Joints: their place is searched run by run, one entry per pitch.
void add_fine(const Background& b, const std::vector<Effect>& effects, Collector& collector,
              std::vector<Hypothesis>& list) {
  for (const Effect& effect : effects) {
    if (!effect.fine ||
        std::any_of(b.added.begin(), b.added.end(), [&](const Applied& a) { return a.effect.id == effect.id; }))
      continue;
    for (SeamFit& fit : search_seams(b, effect)) {
      Hypothesis h;
      h.id = effect.id;
      h.applied = std::move(fit.applied);
      h.places = std::move(fit.places);
      const Eigen::Index column = collector.grow(1);
      for (std::size_t r = 0; r < b.training; ++r) collector.run(r).col(column) = fit.columns[r];
      const effects::Parameter& amplitude = effect.parameters.front();
      h.candidate = {{column}, {amplitude_deviation(amplitude)}, {amplitude_positive(amplitude)}, fit.log_weight};
      list.push_back(std::move(h));
    }
  }
}

/// Faults of a channel in all runs or in one: scale (5 %), bias (five times the quoted), lag (0.25 s).
void add_sensors(const Background& b, Collector& collector, std::vector<Hypothesis>& list) {
  std::vector<Quantity> quantities;
  for (std::size_t r = 0; r < b.training; ++r)
    for (const Channel& c : b.runs[r].channels)
      if (std::find(quantities.begin(), quantities.end(), c.quantity) == quantities.end())
        quantities.push_back(c.quantity);
  static const char* const faults[] = {"bias", "scale", "lag"};
  for (const Quantity quantity : quantities)
    for (std::size_t fault = 0; fault < 3; ++fault)
      for (std::size_t only = 0; only <= b.training; ++only) {
        if (only > 0 && b.training == 1) continue;
        Hypothesis h;
        h.kind = Hypothesis::Kind::sensor;
        h.id = name_of(quantity) + "." + faults[fault];
        double deviation = 0.0;
        const Eigen::Index column = collector.grow(1);
        for (std::size_t r = 0; r < b.training; ++r) {
          if (only > 0 && r + 1 != only) continue;
          for (std::size_t c = 0; c < b.runs[r].channels.size(); ++c) {
            const Channel& channel = b.runs[r].channels[c];
            if (channel.quantity != quantity) continue;
            if (only > 0) h.run = b.runs[r].id;
            const Eigen::Index wanted = fault == 0   ? b.layout.runs[r].bias[c]
                                        : fault == 1 ? b.layout.runs[r].scale[c]
                                                     : b.layout.runs[r].lag[c];
            const auto& names = b.linear[r].columns;
            const auto at = std::find(names.begin(), names.end(), wanted) - names.begin();
            collector.run(r).col(column) += b.linear[r].S.col(at);
            deviation = fault == 0 ? 5.0 * std::max(channel.bias, channel.noise * 0.1) : fault == 1 ? 0.05 : 0.25;
          }
        }
        if (deviation == 0.0) continue;
        h.candidate = {{column}, {deviation}, {false}, 0.0};
        list.push_back(std::move(h));
      }
}

void add_learned(const Background& b, Collector& collector, std::vector<Hypothesis>& list) {
  const auto gaussian = [&](const std::string& id, Eigen::Index first, Eigen::Index n, const Eigen::MatrixXd& factor) {
    for (std::size_t r = 0; r < b.training; ++r)
      collector.run(r).middleCols(first, n) = Eigen::MatrixXd(collector.run(r).middleCols(first, n) * factor);
    Hypothesis h;
    h.kind = Hypothesis::Kind::learned;
    h.id = id;
    for (Eigen::Index k = 0; k < n; ++k)
      h.candidate.columns.push_back(first + k), h.candidate.deviation.push_back(1.0),
          h.candidate.positive.push_back(false);
    list.push_back(std::move(h));
  };
  // Strength along the bed, the same in every lane: sums of the block columns, no simulation needed.
  Eigen::Index knots = 0;
  for (std::size_t r = 0; r < b.training; ++r) knots = std::max(knots, b.layout.runs[r].blocks);
  const Eigen::Index first = collector.grow(knots);
  for (std::size_t r = 0; r < b.training; ++r) {
    const auto& names = b.linear[r].columns;
    const auto nose = std::find(names.begin(), names.end(), b.layout.runs[r].nose_blocks) - names.begin();
    const Eigen::Index n = b.layout.runs[r].blocks;
    collector.run(r).middleCols(first, n) = b.linear[r].S.middleCols(nose, n) + b.linear[r].S.middleCols(nose + n, n);
  }
  gaussian("strength along the bed", first, knots, exponential_factor(knots, b.layout.spacing, 8.0, 0.25));

  const double scale = 0.08 * b.data->aircraft.mass * 9.81;  // N: about a fifth of the bed's drag
  for (const bool by_speed : {false, true}) {
    const double spacing = by_speed ? 5.0 : 5.0, reach = by_speed ? 40.0 : longest_way(b);
    std::vector<Applied> hats;
    std::vector<double> steps;
    for (double centre = 0.0; centre <= reach + spacing; centre += spacing) {
      hats.push_back(effects::applied(learned_force("learned", centre, spacing, by_speed), 0.0));
      steps.push_back(0.3 * scale);
    }
    const auto n = static_cast<Eigen::Index>(hats.size());
    const Eigen::Index start = collector.simulate(hats, steps);
    gaussian(by_speed ? "drag by speed" : "drag along the bed", start, n,
             exponential_factor(n, spacing, by_speed ? 15.0 : 10.0, scale));
  }
}

}  // namespace

void share_shapes(std::vector<Hypothesis>& list) {
  std::map<std::string, std::array<double, 2>> counts;  // shapes of the catalogue's law, of other forms
  for (const Hypothesis& h : list)
    if (h.kind == Hypothesis::Kind::effect) counts[h.id][h.applied.effect.form.empty() ? 0 : 1] += 1.0;
  for (Hypothesis& h : list) {
    if (h.kind != Hypothesis::Kind::effect) continue;
    const auto& [own, other] = counts[h.id];
    if (own > 0.0 && other > 0.0)
      h.candidate.log_weight += std::log(0.5 * (own + other) / (h.applied.effect.form.empty() ? own : other));
  }
}

Eigen::MatrixXd exponential_factor(Eigen::Index n, double spacing, double length, double deviation) {
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      covariance(i, j) = deviation * deviation * std::exp(-std::abs(static_cast<double>(i - j)) * spacing / length);
  return Eigen::LLT<Eigen::MatrixXd>(covariance).matrixL();
}

Screen screen(const Background& b, const std::vector<Effect>& effects, const Report& report) {
  Screen result;
  Collector collector(b);
  add_effects(b, effects, collector, result.hypotheses);
  add_fine(b, effects, collector, result.hypotheses);
  if (report) report(0.6, "screening effects");
  add_sensors(b, collector, result.hypotheses);
  if (std::any_of(effects.begin(), effects.end(), [](const Effect& e) { return !e.fine; }))
    add_learned(b, collector, result.hypotheses);
  result.scores = collector.scores();
  if (report) report(1.0, "screened");
  return result;
}

}  // namespace apc::learning
