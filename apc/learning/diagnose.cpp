#include "apc/learning/diagnose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

/// Evidence is divided by this before it becomes probability: the background model is not exact, and what it lacks
/// repeats from run to run. Chosen on cases with known truth.
constexpr double temper = 4.0;
constexpr double odds_effect = 0.5, odds_pair = 0.15, odds_sensor = 0.1, odds_learned = 0.02;
/// A tire that loses its pressure at the same place in every run is a rare thing, and with its free place a flexible
/// one.
constexpr double odds_tire_loss = 0.1;

/// The best shape of each effect, most evident first.
struct Single {
  const Hypothesis* hypothesis;
  Evidence evidence;
  double log_evidence;  ///< averaged over the shapes
};

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
    const double highest = *std::max_element(all[id].begin(), all[id].end());
    double sum = 0.0;
    for (const double value : all[id]) sum += std::exp(value - highest);
    single.log_evidence = highest + std::log(sum / static_cast<double>(all[id].size()));
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

using Places = std::vector<std::array<double, 2>>;

Explanation explained(const Background& b, const NuisanceFactor& nuisances, const std::vector<effects::Applied>& start,
                      const Places& places) {
  Explanation x;
  x.fit = refine(b, nuisances, start, 4, places);
  x.fitted = true;
  x.ids = ids_of(start);
  x.log_evidence = x.fit.log_evidence;
  return x;
}

/// Sensors and learned forces: linear, so the screen's evidence is already theirs.
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

double prior_odds(const Explanation& x, std::size_t effects, std::size_t sensors) {
  switch (x.kind) {
    case Hypothesis::Kind::effect:
      if (x.ids.empty()) return 1.0;
      return (x.ids.size() == 1 ? odds_effect : odds_pair) * 4.0 / static_cast<double>(effects) *
             (std::find(x.ids.begin(), x.ids.end(), "tire_loss") != x.ids.end() ? odds_tire_loss : 1.0);
    case Hypothesis::Kind::sensor:
      return odds_sensor * 4.0 / static_cast<double>(sensors);
    case Hypothesis::Kind::learned:
      return odds_learned;
  }
  return 1.0;
}

void weigh(std::vector<Explanation>& list, std::size_t effects) {
  std::size_t sensors = 1;
  for (const Explanation& x : list) sensors += x.kind == Hypothesis::Kind::sensor ? 1 : 0;
  double highest = -1e300, sum = 0.0;
  for (Explanation& x : list) {
    x.probability = std::log(prior_odds(x, effects, sensors)) + x.log_evidence / temper;
    highest = std::max(highest, x.probability);
  }
  for (Explanation& x : list) sum += x.probability = std::exp(x.probability - highest);
  for (Explanation& x : list) x.probability /= sum;
  std::stable_sort(list.begin(), list.end(),
                   [](const Explanation& a, const Explanation& b) { return a.probability > b.probability; });
}

void make_claims(const Background& b, const FamilyWise& null, const std::vector<Single>& singles, Diagnosis& d) {
  std::map<std::string, Claim> claims;
  for (const Explanation& x : d.explanations)
    for (const std::string& id : x.ids) {
      Claim& claim = claims[id];
      claim.probability += x.probability;
      if (!claim.id.empty() || !x.fitted) continue;
      claim.id = id;
      std::size_t column = 0;
      for (const auto& applied : x.fit.effects) {
        const std::size_t free = free_parameter_count(applied);
        if (applied.effect.id == id) {
          claim.applied = applied;
          claim.deviation = parameter_deviations(applied, x.fit, column);
        }
        column += free;
      }
    }
  for (auto& [id, claim] : claims) {
    if (claim.probability < 0.02 || claim.id.empty()) continue;
    for (const Single& s : singles)
      if (s.hypothesis->id == id) claim.p_family_wise = null.p_of(s.evidence.gain / temper);
    for (std::size_t r = 0; r < b.runs.size(); ++r)
      if (!b.traces[r].result.history.time.empty()) claim.work[b.runs[r].id] = work_of(b, r, claim.applied);
    d.claims.push_back(claim);
  }
  std::stable_sort(d.claims.begin(), d.claims.end(),
                   [](const Claim& a, const Claim& c) { return a.probability > c.probability; });
}

void make_set90(Diagnosis& d) {
  double sum = 0.0;
  std::set<std::vector<std::string>> seen;
  for (const Explanation& x : d.explanations) {
    if (x.kind == Hypothesis::Kind::learned) continue;
    if (seen.insert(x.ids).second) d.set90.push_back(x.ids);
    sum += x.probability;
    if (sum >= 0.9 || d.set90.size() >= 4) break;
  }
}

void make_rivals(const Screen& screen, const std::vector<Single>& singles, Diagnosis& d) {
  for (std::size_t i = 0; i < std::min<std::size_t>(6, singles.size()); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Eigen::Index a = singles[i].hypothesis->candidate.columns.front(),
                         c = singles[k].hypothesis->candidate.columns.front();
      const double rho = correlation_of(screen.scores, c, a);
      const double separability = singles[k].evidence.amplitude[0] *
                                  std::sqrt(screen.scores.gram(c, c) * std::max(0.0, 1.0 - rho * rho) / temper);
      if (std::abs(rho) > 0.8)
        d.rivals.push_back({singles[k].hypothesis->id, singles[i].hypothesis->id, rho, std::abs(separability)});
    }
}

void make_smallest(const Screen& screen, const std::vector<Single>& singles, const FamilyWise& null, Diagnosis& d) {
  const double reach = std::sqrt(temper) * (std::sqrt(null.quantile(0.99)) + 1.28);
  for (const Single& s : singles) {
    const Eigen::Index c = s.hypothesis->candidate.columns.front();
    const double gram = screen.scores.gram(c, c);
    if (gram > 0.0)
      d.smallest_detectable[s.hypothesis->id + "." + s.hypothesis->applied.effect.parameters.front().name] =
          reach / std::sqrt(gram);
  }
}

void decide(Diagnosis& d) {
  const Explanation& first = d.explanations.front();
  double silent = 0.0, sensor = 0.0, learned = 0.0;
  for (const Explanation& x : d.explanations) {
    if (x.kind == Hypothesis::Kind::effect && x.ids.empty()) silent += x.probability;
    if (x.kind == Hypothesis::Kind::sensor) sensor += x.probability;
    if (x.kind == Hypothesis::Kind::learned) learned += x.probability;
  }
  if (learned > 0.5) {
    d.verdict = Verdict::unexplained;
    for (const Explanation& x : d.explanations)
      if (x.kind == Hypothesis::Kind::learned) {
        d.learned = x.label;
        break;
      }
  } else if (sensor > 0.5) {
    d.verdict = Verdict::sensor;
  } else if (silent + sensor > 0.5) {
    d.verdict = Verdict::nothing;
  } else if (first.kind == Hypothesis::Kind::effect && !first.ids.empty() && first.probability > 0.6 &&
             silent + sensor < 0.1) {
    d.verdict = Verdict::found;
  } else {
    d.verdict = Verdict::ambiguous;
  }
  for (const Claim& c : d.claims)
    if (c.probability >= 0.5 && d.verdict != Verdict::nothing && d.verdict != Verdict::sensor)
      d.augmented.push_back(c.applied);
  if (d.augmented.empty() && d.verdict == Verdict::ambiguous)
    for (const Explanation& x : d.explanations)
      if (x.fitted) {
        d.augmented = x.fit.effects;
        break;
      }
}

}  // namespace

const char* text(Verdict verdict) {
  static const char* const names[] = {"found", "ambiguous", "nothing", "unexplained", "sensor"};
  return names[static_cast<std::size_t>(verdict)];
}

Study diagnose(const Case& data, const DiagnoseOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  Study study;
  const auto part = [&](double from, double to) {
    return [&options, from, to](double share, const std::string& what) {
      if (options.report) options.report(from + (to - from) * share, what);
    };
  };
  BackgroundOptions background;
  background.threads = options.threads;
  background.report = part(0.0, 0.5);
  study.background = fit_background(data, background);
  const Background& b = study.background;
  study.screen = screen(b, options.effects, part(0.5, 0.65));
  const std::vector<Single> singles = best_shapes(study.screen);
  const NuisanceFactor nuisances(b);
  Diagnosis& d = study.diagnosis;
  d.explanations.emplace_back();  // nothing: what the refits gain by moving nuisances alone is nothing's, too
  {
    const SetFit idle = refine(b, nuisances, {}, 4);
    d.explanations.back().log_evidence = idle.log_evidence;
  }
  constexpr std::size_t most_singles = 7, most_pairs = 6;
  std::set<std::string> refined;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const Single& s = singles[i];
    if (i < most_singles) {
      d.explanations.push_back(
          explained(b, nuisances, {started(*s.hypothesis, s.evidence.amplitude[0])}, s.hypothesis->places));
      refined.insert(s.hypothesis->id);
    } else {
      Explanation x;
      x.ids = {s.hypothesis->id};
      x.log_evidence = s.log_evidence;
      d.explanations.push_back(std::move(x));
    }
    if (options.report)
      options.report(0.65 + 0.2 * std::min(1.0, static_cast<double>(i) / most_singles), "fitting single effects");
  }
  // Pairs in the linear space, over all shapes of the leading effects; the best are fitted.
  struct Pair {
    const Hypothesis *a, *c;
    Evidence evidence;
  };
  std::map<std::vector<std::string>, Pair> pairs;
  std::vector<const Hypothesis*> shapes;
  for (const Hypothesis& h : study.screen.hypotheses)
    if (h.kind == Hypothesis::Kind::effect) shapes.push_back(&h);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (shapes[i]->id == shapes[k]->id) continue;
      Candidate both = shapes[i]->candidate;
      both.columns.push_back(shapes[k]->candidate.columns[0]);
      both.deviation.push_back(shapes[k]->candidate.deviation[0]);
      both.positive.push_back(shapes[k]->candidate.positive[0]);
      both.log_weight += shapes[k]->candidate.log_weight;
      const Evidence e = evidence_of(study.screen.scores, both);
      std::vector<std::string> ids = {shapes[i]->id, shapes[k]->id};
      std::sort(ids.begin(), ids.end());
      const auto found = pairs.find(ids);
      if (found == pairs.end() || found->second.evidence.log_evidence < e.log_evidence)
        pairs[ids] = {shapes[i], shapes[k], e};
    }
  std::vector<Pair> ordered;
  for (const auto& [ids, pair] : pairs) ordered.push_back(pair);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Pair& a, const Pair& c) { return a.evidence.log_evidence > c.evidence.log_evidence; });
  for (std::size_t i = 0; i < std::min(most_pairs, ordered.size()); ++i) {
    const Pair& p = ordered[i];
    d.explanations.push_back(explained(b, nuisances,
                                       {started(*p.a, p.evidence.amplitude[0]), started(*p.c, p.evidence.amplitude[1])},
                                       p.a->places.empty() ? p.c->places : p.a->places));
    if (options.report) options.report(0.85 + 0.13 * static_cast<double>(i + 1) / most_pairs, "fitting pairs");
  }
  add_linear(study.screen, d.explanations, d.sensors);
  weigh(d.explanations, singles.size());

  std::vector<Candidate> single_columns;
  for (const Hypothesis* h : shapes) single_columns.push_back(h->candidate);
  const FamilyWise null = family_wise(study.screen.scores, single_columns, 2000, options.seed);
  make_claims(b, null, singles, d);
  make_set90(d);
  make_rivals(study.screen, singles, d);
  make_smallest(study.screen, singles, null, d);
  decide(d);
  d.unexplained_share = 0.0;
  for (const Explanation& x : d.explanations)
    if (x.kind == Hypothesis::Kind::learned) d.unexplained_share += x.probability;
  d.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return study;
}

}  // namespace apc::learning
