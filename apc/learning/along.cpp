#include "apc/learning/along.h"

#include <algorithm>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/learning/along_noise.h"
#include "apc/learning/simulated_swing.h"

namespace apc::learning {
namespace {

using effects::Applied;
using effects::Effect;

/// Evidence is divided by this before it becomes probability: with ruts in every run, and without. Chosen on cases with
/// known truth.
constexpr double temper_surveyed = 1.5, temper_unsurveyed = 3.0;
/// The bed is linearised again half the way to what is likeliest, twelve times, whether or not that helps (evidence
/// without an effect has several summits); then from the best of these, while it rises, with longer steps where that
/// helped and shorter ones where it did not. No effect is to be paid for steps that were not taken.
constexpr int free_rounds = 12, most_rounds = 8;
constexpr double least_share_of_step = 0.05, converged = 0.2;
/// A tire cannot be told to have lost its pressure before the main gear is in the full bed.
constexpr double earliest_tire_loss = 30.0;

/// Columns of all runs side by side: one matrix of rows × candidates per run.
using Columns = std::vector<std::vector<Eigen::VectorXd>>;

Hypothesis effect_hypothesis(const Applied& shape, Eigen::Index column) {
  const effects::Parameter& p = shape.effect.parameters.front();
  Hypothesis h;
  h.id = shape.effect.id;
  h.applied = shape;
  h.candidate = {{column}, {amplitude_deviation(p)}, {p.usual >= p.neutral && amplitude_positive(p)}, 0.0};
  return h;
}

void add_effects(const Along& along, const Case& data, const std::vector<Effect>& effects, unsigned threads,
                 Columns& columns, std::vector<Hypothesis>& list) {
  double longest = 0.0;
  for (const AlongRun& a : along.runs) longest = std::max(longest, a.motion.place.back());
  std::vector<Applied> shapes;
  std::vector<double> steps;
  for (const Effect& effect : effects) {
    if (effect.fine) continue;
    const effects::Parameter& p = effect.parameters.front();
    for (const Applied& shape : shapes_of(effect, longest)) {
      if (effect.id == "tire_loss" && shape.values[1] < earliest_tire_loss) continue;
      list.push_back(effect_hypothesis(shape, static_cast<Eigen::Index>(list.size())));
      shapes.push_back(shape);
      steps.push_back(0.3 * (p.usual - p.neutral));
    }
  }
  for (auto& run : columns) run.resize(list.size());
  parallel_for(shapes.size() * along.runs.size(), threads, [&](std::size_t job) {
    const std::size_t r = job / shapes.size(), k = job % shapes.size();
    const AlongRun& a = along.runs[r];
    effects::Alterations with = a.here;
    with.effects.push_back(shapes[k]);
    with.effects.back().values.front() = shapes[k].effect.parameters.front().neutral + steps[k];
    const Balance b = balance_at_loads(data, along.gears, data.runs[r], a.motion, with);
    columns[r][k] =
        (read_off(a.readings, along.gears, data.runs[r], a.motion, b, data.runs[r].overrun.entry_speed) - a.predicted) /
        steps[k];
  });
}

/// Bias, scale and lag of speed and acceleration_x, in all runs or in one.
void add_sensors(const Along& along, const Case& data, const Layout& layout, Columns& columns,
                 std::vector<Hypothesis>& list) {
  static const char* const faults[] = {"bias", "scale", "lag"};
  for (const Quantity quantity : {Quantity::speed, Quantity::acceleration_x})
    for (std::size_t fault = 0; fault < 3; ++fault)
      for (std::size_t only = 0; only <= along.runs.size(); ++only) {
        const auto recorded = [&](const Run& run) { return run.find(quantity) != nullptr; };
        if (only > 0 ? along.runs.size() == 1 || !recorded(data.runs[only - 1])
                     : std::none_of(data.runs.begin(), data.runs.end(), recorded))
          continue;
        Hypothesis h;
        h.kind = Hypothesis::Kind::sensor;
        h.id = name_of(quantity) + "." + faults[fault];
        double deviation = 0.0;
        for (std::size_t r = 0; r < along.runs.size(); ++r) {
          Eigen::VectorXd column = Eigen::VectorXd::Zero(along.runs[r].predicted.size());
          for (std::size_t c = 0; c < data.runs[r].channels.size(); ++c) {
            const Channel& channel = data.runs[r].channels[c];
            if (channel.quantity != quantity || (only > 0 && r + 1 != only)) continue;
            const RunLayout& at = layout.runs[r];
            column += along.runs[r].unknowns.col(fault == 0 ? at.bias[c] : fault == 1 ? at.scale[c] : at.lag[c]);
            deviation = fault == 0 ? 5.0 * std::max(channel.bias, channel.noise * 0.1) : fault == 1 ? 0.05 : 0.25;
          }
          columns[r].push_back(std::move(column));
        }
        if (only > 0) h.run = data.runs[only - 1].id;
        // No instrument runs ahead of what it measures.
        h.candidate = {{static_cast<Eigen::Index>(columns.front().size()) - 1}, {deviation}, {fault == 2}, 0.0};
        list.push_back(std::move(h));
      }
}

/// Drag of the main gear as a smooth function of the place, or of the speed: hats 5 m or 5 m/s apart.
void add_learned(const Along& along, const Case& data, Columns& columns, std::vector<Hypothesis>& list) {
  double longest = 0.0;
  for (const AlongRun& a : along.runs) longest = std::max(longest, a.motion.place.back());
  const double scale = 0.08 * data.aircraft.mass * 9.81;  // N: about a fifth of the bed's drag
  for (const bool by_speed : {false, true}) {
    constexpr double spacing = 5.0;
    const auto hats = static_cast<Eigen::Index>((by_speed ? 40.0 : longest) / spacing) + 2;
    const Eigen::MatrixXd factor = exponential_factor(hats, spacing, by_speed ? 15.0 : 10.0, scale);
    Hypothesis h;
    h.kind = Hypothesis::Kind::learned;
    h.id = by_speed ? "drag by speed" : "drag along the bed";
    for (Eigen::Index k = 0; k < hats; ++k) {
      h.candidate.columns.push_back(static_cast<Eigen::Index>(columns.front().size()) + k);
      h.candidate.deviation.push_back(1.0), h.candidate.positive.push_back(false);
    }
    for (std::size_t r = 0; r < along.runs.size(); ++r) {
      const AlongRun& a = along.runs[r];
      const Run& run = data.runs[r];
      Eigen::MatrixXd plain(a.predicted.size(), hats);
      for (Eigen::Index k = 0; k < hats; ++k) {
        Balance b = a.response.base;
        for (Eigen::Index i = 0; i < b.along.size(); ++i) {
          const auto s = static_cast<std::size_t>(i);
          for (const GearFacts& g : along.gears) {
            const double place = a.motion.place[s] - g.behind;
            if (g.nose || place <= 0.0) continue;
            const double u = std::abs((by_speed ? a.motion.speed[s] : place) / spacing - static_cast<double>(k));
            b.along[i] -= scale * std::max(0.0, 1.0 - u) / run.overrun.mass;
          }
        }
        plain.col(k) =
            (read_off(a.readings, along.gears, run, a.motion, b, run.overrun.entry_speed) - a.predicted) / scale;
      }
      const Eigen::MatrixXd smooth = plain * factor;
      for (Eigen::Index k = 0; k < hats; ++k) columns[r].emplace_back(smooth.col(k));
    }
    list.push_back(std::move(h));
  }
}

}  // namespace

std::optional<Along> balance_along(const Case& data, const Layout& layout, unsigned threads) {
  Along along;
  along.gears = gear_facts(data);
  if (along.gears.empty()) return std::nullopt;
  for (std::size_t r = 0; r < data.runs.size(); ++r) {
    auto motion = measured_motion(data, layout, r);
    if (!motion) return std::nullopt;
    along.runs.emplace_back().motion = std::move(*motion);
  }
  parallel_for(along.runs.size(), threads, [&](std::size_t r) {
    AlongRun& a = along.runs[r];
    const Run& run = data.runs[r];
    if (!swing_unknown(run)) lead_swing(data, layout, r, expected_sinking, a.motion);
    load_motion(data, along.gears, run, a.motion);
    if (swing_unknown(run)) simulate_swing(data, layout, along.gears, r, expected_sinking, a.motion);
    a.readings = readings_of(data, along.gears, run, a.motion);
    a.measured.resize(static_cast<Eigen::Index>(a.readings.size()));
    for (std::size_t i = 0; i < a.readings.size(); ++i) a.measured[static_cast<Eigen::Index>(i)] = a.readings[i].value;
    effects::Alterations plain;
    plain.conditions = run.conditions;
    a.nominal = balance_at_loads(data, along.gears, run, a.motion, plain);
    a.plain = read_off(a.readings, along.gears, run, a.motion, a.nominal, run.overrun.entry_speed);
    a.response.base = a.nominal;
  });
  const AlongPrior prior = along_prior(data, layout);
  const Eigen::VectorXd of_the_bed = bed_unknowns(layout);
  const auto fit_at = [&](const Eigen::VectorXd& bed, int passes) {
    along.bed = bed;
    parallel_for(along.runs.size(), threads,
                 [&](std::size_t r) { linearise_at(data, layout, along.gears, r, along.bed, along.runs[r]); });
    return fit_noise(along, data, layout, prior, passes, threads);
  };
  try {
    Eigen::VectorXd bed = Eigen::VectorXd::Zero(layout.size + Extra::count), best, towards;
    double highest = -1e300;
    AlongNoise noise;
    for (int round = 0; round < free_rounds; ++round) {
      const Eigen::VectorXd likeliest = fit_at(bed, 1);
      if (along.log_evidence > highest)
        highest = along.log_evidence, best = bed, towards = likeliest, noise = along.noise;
      bed += 0.5 * (of_the_bed.cwiseProduct(likeliest) - bed);
    }
    double share = 0.5;
    for (int round = 0; round < most_rounds && share > least_share_of_step; ++round) {
      along.noise = noise;
      bed = best + share * (of_the_bed.cwiseProduct(towards) - best);
      const Eigen::VectorXd likeliest = fit_at(bed, 1);
      const double gain = along.log_evidence - highest;
      if (gain > 0.0) best = bed, towards = likeliest, highest = along.log_evidence, noise = along.noise;
      share = gain > 0.0 ? std::min(1.0, 1.5 * share) : 0.4 * share;
      if (gain > 0.0 && gain < converged) break;
    }
    along.noise = noise, fit_at(best, 2);
  } catch (const SolveError&) {
    return std::nullopt;
  }
  return along;
}

Screen weigh_along(const Along& along, const Case& data, const Layout& layout, const std::vector<Effect>& effects,
                   unsigned threads) {
  Screen result;
  result.temper = temper_surveyed;
  for (const AlongRun& a : along.runs)
    if (std::none_of(a.readings.begin(), a.readings.end(),
                     [](const Reading& r) { return r.kind == Reading::Kind::rut; }))
      result.temper = temper_unsurveyed;
  Columns columns(along.runs.size());
  add_effects(along, data, effects, threads, columns, result.hypotheses);
  share_shapes(result.hypotheses);
  add_sensors(along, data, layout, columns, result.hypotheses);
  add_learned(along, data, columns, result.hypotheses);
  const Eigen::Index n = along.precision.rows(), k = static_cast<Eigen::Index>(columns.front().size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n), cross = Eigen::MatrixXd::Zero(n, k),
                  plain = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), score = Eigen::VectorXd::Zero(k);
  double square = 0.0;
  for (std::size_t r = 0; r < along.runs.size(); ++r) {
    const AlongRun& a = along.runs[r];
    Eigen::MatrixXd F(a.predicted.size(), k);
    for (Eigen::Index i = 0; i < k; ++i) F.col(i) = columns[r][static_cast<std::size_t>(i)];
    const auto lower = a.factor.triangularView<Eigen::Lower>();
    F = Eigen::MatrixXd(lower.solve(F));
    const Eigen::MatrixXd S = lower.solve(a.unknowns(Eigen::all, a.touched));
    const Eigen::VectorXd y = lower.solve(a.difference);
    information(a.touched, a.touched) += S.transpose() * S;
    cross(a.touched, Eigen::all) += S.transpose() * F, right(a.touched) += S.transpose() * y;
    plain += F.transpose() * F, score += F.transpose() * y, square += y.squaredNorm();
  }
  result.scores = marginal_scores(information, along.precision, cross, right, plain, score, square);
  return result;
}

}  // namespace apc::learning
