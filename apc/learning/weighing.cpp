#include "apc/learning/weighing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace apc::learning {
namespace {

/// Prior odds against no effect. Chosen on cases with known truth, as the tempers of the two screens.
constexpr double odds_effect = 0.5, odds_pair = 0.15, odds_sensor = 0.1, odds_learned = 0.02;
constexpr double odds_effect_along = 2.0, odds_pair_along = 0.2, odds_sensor_along = 0.5;
/// A tire that loses its pressure at the same place in every run is a rare thing, and with its free place a flexible
/// one.
constexpr double odds_tire_loss = 0.3;

/// Prior odds of one explanation of a kind against no effect.
struct Odds {
  double effect = 0.0, pair = 0.0, sensor = 0.0, learned = 0.0;
  double of(const Explanation& x) const {
    switch (x.kind) {
      case Hypothesis::Kind::effect:
        if (x.ids.empty()) return 1.0;
        return (x.ids.size() == 1 ? effect : pair) *
               (std::find(x.ids.begin(), x.ids.end(), "tire_loss") != x.ids.end() ? odds_tire_loss : 1.0);
      case Hypothesis::Kind::sensor:
        return sensor;
      case Hypothesis::Kind::learned:
        return learned;
    }
    return 1.0;
  }
};

/// Along the motion every single effect and every pair is weighed; through the simulator only the few leading ones,
/// each with as much of the prior as four of them would have.
Odds odds_of(bool along, std::size_t effects, const std::vector<Explanation>& list) {
  double sensors = 1.0;
  for (const Explanation& x : list) sensors += x.kind == Hypothesis::Kind::sensor ? 1.0 : 0.0;
  const auto n = static_cast<double>(effects);
  if (along)
    return {odds_effect_along / n, odds_pair_along / (0.5 * n * (n - 1.0)), odds_sensor_along / sensors, odds_learned};
  return {4.0 * odds_effect / n, 4.0 * odds_pair / n, 4.0 * odds_sensor / sensors, odds_learned};
}

}  // namespace

double mean_evidence(const std::vector<double>& list) {
  const double highest = *std::max_element(list.begin(), list.end());
  double sum = 0.0;
  for (const double value : list) sum += std::exp(value - highest);
  return highest + std::log(sum / static_cast<double>(list.size()));
}

std::vector<Single> best_shapes(const Screen& screen) {
  std::map<std::string, Single> best;
  std::map<std::string, std::vector<double>> all;
  for (const Hypothesis& h : screen.hypotheses) {
    if (h.kind != Hypothesis::Kind::effect) continue;
    const Evidence e = evidence_of(screen.scores, h.candidate);
    all[h.id].push_back(e.log_evidence);
    const auto found = best.find(h.id);
    if (found == best.end() || found->second.evidence.log_evidence < e.log_evidence) best[h.id] = {&h, e, 0.0};
  }
  std::vector<Single> list;
  for (auto& [id, single] : best) {
    single.log_evidence = mean_evidence(all[id]);
    list.push_back(single);
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Single& a, const Single& b) { return a.log_evidence > b.log_evidence; });
  return list;
}

effects::Applied started(const Hypothesis& h, double amplitude) {
  effects::Applied applied = h.applied;
  const effects::Parameter& p = h.applied.effect.parameters.front();
  applied.values.front() = std::clamp(p.neutral + amplitude, std::min(p.low, p.neutral), std::max(p.high, p.neutral));
  return applied;
}

std::vector<std::string> ids_of(const std::vector<effects::Applied>& list) {
  std::vector<std::string> ids;
  for (const auto& a : list) ids.push_back(a.effect.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

Explanation explained(const Background& b, const NuisanceFactor& nuisances, const std::vector<effects::Applied>& start,
                      const std::vector<std::array<double, 2>>& places) {
  Explanation x;
  x.fit = refine(b, nuisances, start, 4, places);
  x.fitted = true;
  x.ids = ids_of(start);
  x.log_evidence = x.fit.log_evidence;
  return x;
}

Explanation weighed(const Background& b, const std::vector<const Hypothesis*>& set, const Evidence& evidence,
                    double log_evidence) {
  Explanation x;
  x.fitted = true;
  x.log_evidence = log_evidence;
  x.fit.log_evidence = log_evidence;
  x.fit.eta = b.eta;
  std::vector<double> variance;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Hypothesis& h = *set[i];
    x.fit.effects.push_back(started(h, evidence.amplitude[static_cast<Eigen::Index>(i)]));
    for (std::size_t r = 0; r < h.places.size(); ++r)
      x.fit.eta[b.layout.runs[r].shift] = h.places[r][0], x.fit.eta[b.layout.runs[r].stretch] = h.places[r][1];
    const auto free = free_parameter_count(h.applied);
    const auto k = static_cast<Eigen::Index>(i);
    for (std::size_t p = 0; p < free; ++p)  // shapes were not fitted
      variance.push_back(p == 0 ? evidence.covariance(k, k) : std::nan(""));
  }
  x.fit.covariance =
      Eigen::Map<Eigen::VectorXd>(variance.data(), static_cast<Eigen::Index>(variance.size())).asDiagonal();
  x.fit.at_bound.assign(variance.size(), false);
  x.ids = ids_of(x.fit.effects);
  return x;
}

double simulated_share(const Screen& along) { return along.temper / Screen{}.temper; }

Screen joined(Screen along, const Screen& simulated) {
  std::vector<Hypothesis> fine;
  for (const Hypothesis& h : simulated.hypotheses)
    if (h.kind == Hypothesis::Kind::effect && h.applied.effect.fine) fine.push_back(h);
  const Eigen::Index n = along.scores.gram.rows(), k = static_cast<Eigen::Index>(fine.size());
  const double scale = simulated_share(along);
  Scores both{Eigen::MatrixXd::Zero(n + k, n + k), Eigen::VectorXd::Zero(n + k), along.scores.misfit};
  both.gram.topLeftCorner(n, n) = along.scores.gram, both.score.head(n) = along.scores.score;
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index from = fine[static_cast<std::size_t>(i)].candidate.columns.front();
    both.score[n + i] = scale * simulated.scores.score[from];
    for (Eigen::Index j = 0; j < k; ++j)
      both.gram(n + i, n + j) =
          scale * simulated.scores.gram(from, fine[static_cast<std::size_t>(j)].candidate.columns.front());
  }
  for (Eigen::Index i = 0; i < k; ++i) {
    Hypothesis h = fine[static_cast<std::size_t>(i)];
    h.candidate.columns.front() = n + i;
    h.candidate.log_weight *= scale;
    along.hypotheses.push_back(std::move(h));
  }
  along.scores = std::move(both);
  return along;
}

void add_linear(const Screen& screen, std::vector<Explanation>& list, std::vector<SensorClaim>& sensors) {
  for (const Hypothesis& h : screen.hypotheses) {
    if (h.kind == Hypothesis::Kind::effect) continue;
    const Evidence e = evidence_of(screen.scores, h.candidate);
    Explanation x;
    x.kind = h.kind;
    x.label = h.id + (h.run.empty() ? "" : " in " + h.run);
    x.log_evidence = e.log_evidence;
    if (h.kind == Hypothesis::Kind::sensor && e.log_evidence > 4.0)
      sensors.push_back({h.run, h.id, e.amplitude[0], std::sqrt(e.covariance(0, 0)), e.log_evidence});
    list.push_back(std::move(x));
  }
  std::stable_sort(sensors.begin(), sensors.end(),
                   [](const SensorClaim& a, const SensorClaim& b) { return a.log_evidence > b.log_evidence; });
}

void weigh(std::vector<Explanation>& list, bool along, std::size_t effects, double temper) {
  const Odds odds = odds_of(along, effects, list);
  double highest = -1e300, sum = 0.0;
  for (Explanation& x : list) {
    x.probability = std::log(odds.of(x)) + x.log_evidence / temper + x.free_evidence;
    highest = std::max(highest, x.probability);
  }
  for (Explanation& x : list) sum += x.probability = std::exp(x.probability - highest);
  for (Explanation& x : list) x.probability /= sum;
  std::stable_sort(list.begin(), list.end(),
                   [](const Explanation& a, const Explanation& b) { return a.probability > b.probability; });
}

}  // namespace apc::learning
