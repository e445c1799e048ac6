#include "apc/learning/diagnose.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "apc/base/require.h"
#include "apc/effects/other_forms.h"
#include "apc/learning/augment.h"
#include "apc/learning/verdict.h"

namespace apc::learning {
namespace {

/// What free runs say of every explanation. Of the pairs only the leading ones are fitted.
void add_free(FreeEvidence& free, double temper, std::vector<Explanation>& list, const Report& report) {
  constexpr std::size_t most_pairs = 8;
  std::vector<std::pair<double, const Explanation*>> pairs;
  for (Explanation& x : list) {
    if (x.kind != Hypothesis::Kind::effect || x.ids.empty()) continue;
    x.free_evidence = free.of(x.ids);
    if (x.ids.size() == 2 && x.fitted) pairs.emplace_back(x.log_evidence / temper + x.free_evidence, &x);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& c) { return a.first > c.first; });
  pairs.resize(std::min(most_pairs, pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    add_pair(free, pairs[i].second->fit.effects);
    if (report) report(static_cast<double>(i + 1) / static_cast<double>(pairs.size()), "fitting pairs to free runs");
  }
  for (Explanation& x : list)
    if (x.kind == Hypothesis::Kind::effect && x.ids.size() == 2) x.free_evidence = free.of(x.ids);
}

}  // namespace

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
  if (study.along) background.iterations = 2;  // it carries joints only
  background.report = part(study.along ? 0.2 : 0.0, 0.5);
  study.background = fit_background(data, background);
  const Background& b = study.background;
  auto laws = options.effects;
  laws.insert(laws.end(), effects::other_forms().begin(), effects::other_forms().end());
  if (study.along) {
    std::vector<effects::Effect> fine;
    std::copy_if(options.effects.begin(), options.effects.end(), std::back_inserter(fine),
                 [](const effects::Effect& e) { return e.fine; });
    study.screen =
        joined(weigh_along(*study.along, data, layout, laws, options.threads), screen(b, fine, part(0.5, 0.6)));
  } else {
    study.screen = screen(b, options.effects, part(0.5, 0.6));
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
      options.report(0.6 + 0.1 * std::min(1.0, static_cast<double>(i) / most_singles), "fitting single effects");
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
    if (options.report) options.report(0.7 + 0.05 * static_cast<double>(i + 1) / most_pairs, "fitting pairs");
  }
  add_linear(study.screen, d.explanations, d.sensors);
  study.free = weigh_free(data, laws, options.threads, part(0.75, 0.9));
  if (study.free) add_free(*study.free, study.screen.temper, d.explanations, part(0.9, 0.97));
  weigh(d.explanations, study.along.has_value(), singles.size(), study.screen.temper);

  std::vector<Candidate> single_columns;
  for (const Hypothesis* h : shapes) single_columns.push_back(h->candidate);
  const FamilyWise null = family_wise(study.screen.scores, single_columns, 2000, options.seed);
  make_claims(b, null, singles, study.screen.temper, d);
  make_set90(d);
  make_rivals(study.screen, singles, d);
  make_smallest(study.screen, singles, null, d);
  decide(d, study.along.has_value());
  if (study.free) augment(study);
  d.unexplained_share = 0.0;
  for (const Explanation& x : d.explanations)
    if (x.kind == Hypothesis::Kind::learned) d.unexplained_share += x.probability;
  d.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return study;
}

}  // namespace apc::learning
