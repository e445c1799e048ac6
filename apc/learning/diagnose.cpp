#include "apc/learning/diagnose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

#include "apc/base/require.h"
#include "apc/effects/other_forms.h"
#include "apc/learning/weighing.h"

namespace apc::learning {
namespace {

void make_claims(const Background& b, const FamilyWise& null, const std::vector<Single>& singles, double temper,
                 Diagnosis& d) {
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

/// The effects of an explanation that have a size: one fitted at its neutral value explains nothing.
std::vector<std::string> ids_with_size(const Explanation& x) {
  std::vector<std::string> ids;
  for (const std::string& id : x.ids) {
    const auto fitted = std::find_if(x.fit.effects.begin(), x.fit.effects.end(),
                                     [&](const effects::Applied& a) { return a.effect.id == id; });
    if (fitted != x.fit.effects.end()) {
      const effects::Parameter& p = fitted->effect.parameters.front();
      if (std::abs(fitted->values.front() - p.neutral) < 1e-3 * (p.high - p.low)) continue;
    }
    ids.push_back(id);
  }
  return ids;
}

void make_set90(Diagnosis& d) {
  double sum = 0.0;
  std::set<std::vector<std::string>> seen;
  for (const Explanation& x : d.explanations) {
    if (x.kind == Hypothesis::Kind::learned) continue;
    const auto ids = ids_with_size(x);
    if (seen.insert(ids).second) d.set90.push_back(ids);
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
                                  std::sqrt(screen.scores.gram(c, c) * std::max(0.0, 1.0 - rho * rho) / screen.temper);
      if (std::abs(rho) > 0.8)
        d.rivals.push_back({singles[k].hypothesis->id, singles[i].hypothesis->id, rho, std::abs(separability)});
    }
}

void make_smallest(const Screen& screen, const std::vector<Single>& singles, const FamilyWise& null, Diagnosis& d) {
  const double reach = std::sqrt(screen.temper) * (std::sqrt(null.quantile(0.99)) + 1.28);
  for (const Single& s : singles) {
    const Eigen::Index c = s.hypothesis->candidate.columns.front();
    const double gram = screen.scores.gram(c, c);
    if (gram > 0.0)
      d.smallest_detectable[s.hypothesis->id + "." + s.hypothesis->applied.effect.parameters.front().name] =
          reach / std::sqrt(gram);
  }
}

/// Nothing is missing, too, where that is so many times as probable as the most probable effect or a force to be
/// learned: many that are hardly possible are not one that is likely. Only where all effects are weighed alike.
constexpr double outshine = 3.0;

void decide(Diagnosis& d, bool along) {
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
  } else if (silent + sensor > 0.5 ||
             (along &&
              silent + sensor > outshine * std::max(learned, d.claims.empty() ? 0.0 : d.claims.front().probability))) {
    d.verdict = Verdict::nothing;
  } else if (!d.claims.empty() && d.claims.front().probability > 0.8 && silent + sensor < 0.1) {
    d.verdict = Verdict::found;
  } else {
    d.verdict = Verdict::ambiguous;
  }
  for (const Claim& c : d.claims)
    if (c.probability >= 0.5 && d.verdict != Verdict::nothing && d.verdict != Verdict::sensor)
      d.augmented.push_back(c.applied);
  // Something is missing for certain, only not which: the likeliest explanation is better than none.
  if (d.augmented.empty() && d.verdict == Verdict::ambiguous && silent + sensor < 0.1)
    for (const Explanation& x : d.explanations)
      if (x.fitted) {
        d.augmented = x.fit.effects;
        break;
      }
}

/// The nuisances of a free run with the effects just added, for predictions.
void add_nuisances(const Background& b, Diagnosis& d) {
  const auto ids = ids_of(d.augmented);
  auto found = std::find_if(d.explanations.begin(), d.explanations.end(),
                            [&](const Explanation& x) { return x.fitted && x.ids == ids; });
  if (found == d.explanations.end()) {
    d.explanations.emplace_back().ids = ids;
    found = d.explanations.end() - 1;
    found->fitted = true;
    found->fit.effects = d.augmented;
  }
  found->fit.eta = refit_background(b, found->fit.effects, 2, {}).eta;
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
  const Layout layout = make_layout(data, data.runs);
  part(0.0, 0.2)(0.0, "balancing forces along the measured motion");
  study.along = balance_along(data, layout, options.threads);
  BackgroundOptions background;
  background.threads = options.threads;
  if (study.along) background.iterations = 2;  // it carries joints and predictions only
  background.report = part(study.along ? 0.2 : 0.0, 0.5);
  study.background = fit_background(data, background);
  const Background& b = study.background;
  if (study.along) {
    std::vector<effects::Effect> fine;
    std::copy_if(options.effects.begin(), options.effects.end(), std::back_inserter(fine),
                 [](const effects::Effect& e) { return e.fine; });
    auto laws = options.effects;
    laws.insert(laws.end(), effects::other_forms().begin(), effects::other_forms().end());
    study.screen =
        joined(weigh_along(*study.along, data, layout, laws, options.threads), screen(b, fine, part(0.5, 0.65)));
  } else {
    study.screen = screen(b, options.effects, part(0.5, 0.65));
  }
  const std::vector<Single> singles = best_shapes(study.screen);
  const NuisanceFactor nuisances(b);
  Diagnosis& d = study.diagnosis;
  d.explanations.emplace_back();  // nothing: what the refits gain by moving nuisances alone is nothing's, too
  if (!study.along) d.explanations.back().log_evidence = refine(b, nuisances, {}, 4).log_evidence;
  std::map<std::string, double> fine_gain;
  constexpr std::size_t most_singles = 7, most_pairs = 6;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const Single& s = singles[i];
    if (study.along && s.hypothesis->applied.effect.fine) {
      // Its depth, width and every run's place are fitted through the simulator; the gain counts in pairs, too.
      Explanation x = explained(b, nuisances, {started(*s.hypothesis, s.evidence.amplitude[0])}, s.hypothesis->places);
      x.log_evidence = std::max(
          s.log_evidence, simulated_share(study.screen) * (x.log_evidence - refine(b, nuisances, {}, 4).log_evidence));
      fine_gain[s.hypothesis->id] = x.log_evidence - s.log_evidence;
      d.explanations.push_back(std::move(x));
    } else if (study.along) {
      d.explanations.push_back(weighed(b, {s.hypothesis}, s.evidence, s.log_evidence));
    } else if (i < most_singles) {
      d.explanations.push_back(
          explained(b, nuisances, {started(*s.hypothesis, s.evidence.amplitude[0])}, s.hypothesis->places));
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
    std::vector<double> all;  ///< of every pair of shapes
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
      const auto [found, fresh] = pairs.try_emplace(ids, Pair{shapes[i], shapes[k], e, {}});
      found->second.all.push_back(e.log_evidence);
      if (!fresh && found->second.evidence.log_evidence < e.log_evidence)
        found->second.a = shapes[i], found->second.c = shapes[k], found->second.evidence = e;
    }
  std::vector<Pair> ordered;
  for (const auto& [ids, pair] : pairs) ordered.push_back(pair);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Pair& a, const Pair& c) { return a.evidence.log_evidence > c.evidence.log_evidence; });
  const std::size_t taken = study.along ? ordered.size() : std::min(most_pairs, ordered.size());
  for (std::size_t i = 0; i < taken; ++i) {
    const Pair& p = ordered[i];
    if (study.along) {
      d.explanations.push_back(
          weighed(b, {p.a, p.c}, p.evidence, mean_evidence(p.all) + fine_gain[p.a->id] + fine_gain[p.c->id]));
      continue;
    }
    d.explanations.push_back(explained(b, nuisances,
                                       {started(*p.a, p.evidence.amplitude[0]), started(*p.c, p.evidence.amplitude[1])},
                                       p.a->places.empty() ? p.c->places : p.a->places));
    if (options.report) options.report(0.85 + 0.13 * static_cast<double>(i + 1) / most_pairs, "fitting pairs");
  }
  add_linear(study.screen, d.explanations, d.sensors);
  weigh(d.explanations, study.along.has_value(), singles.size(), study.screen.temper);

  std::vector<Candidate> single_columns;
  for (const Hypothesis* h : shapes) single_columns.push_back(h->candidate);
  const FamilyWise null = family_wise(study.screen.scores, single_columns, 2000, options.seed);
  make_claims(b, null, singles, study.screen.temper, d);
  make_set90(d);
  make_rivals(study.screen, singles, d);
  make_smallest(study.screen, singles, null, d);
  decide(d, study.along.has_value());
  if (study.along && !d.augmented.empty()) add_nuisances(b, d);
  d.unexplained_share = 0.0;
  for (const Explanation& x : d.explanations)
    if (x.kind == Hypothesis::Kind::learned) d.unexplained_share += x.probability;
  d.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return study;
}

}  // namespace apc::learning
