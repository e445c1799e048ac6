#include "apc/learning/augment.h"

#include <algorithm>

#include "apc/base/require.h"
#include "apc/learning/weighing.h"

namespace apc::learning {
namespace {

using effects::Applied;

constexpr double most_unproven = 0.75;

bool same_forms(const std::vector<Applied>& a, const std::vector<Applied>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(), [](const Applied& x, const Applied& y) {
    return x.effect.id == y.effect.id && x.effect.form == y.effect.form;
  });
}

/// O has several minima where strength and an effect nearly do the same: fitted from the size that the diagnosis found
/// and from the fit that free runs already have, the lower one is taken. `own_form`: not where that is of another form.
std::optional<FreeFit> fitted(const FreeEvidence& free, const std::vector<Applied>& found, bool own_form) {
  std::optional<FreeFit> best;
  const auto from = [&](const std::vector<Applied>& effects, double strength) {
    try {
      FreeFit fit = fit_free(free.runs, effects, strength);
      if (!best || fit.objective < best->objective) best = std::move(fit);
    } catch (const SolveError&) {
      // the other start
    }
  };
  from(found, free.none.strength);
  const auto own = free.sets.find(ids_of(found));
  if (own != free.sets.end() && !(own_form && !same_forms(found, own->second.fit.effects)))
    from(own->second.fit.effects, own->second.fit.strength);
  return best;
}

struct Augmented {
  FreeFit fit;
  HeldOut held_out;
};

std::optional<Augmented> tested(const FreeEvidence& free, const std::vector<Applied>& found, bool own_form = false) {
  const auto fit = fitted(free, found, own_form);
  if (!fit) return std::nullopt;
  try {
    return Augmented{*fit, leave_one_out(free.runs, fit->effects, fit->strength)};
  } catch (const SolveError&) {
    return std::nullopt;
  }
}

/// Dates raise or lower whole runs, as the scatter from run to run does: half a dozen runs do not tell them apart
/// unless their laws are claimed.
bool may_be_tried(const std::vector<Applied>& effects) {
  return std::none_of(effects.begin(), effects.end(), [](const Applied& a) { return known_by_date(a.effect); });
}

std::vector<std::vector<Applied>> tries(const Study& study) {
  std::vector<std::vector<Applied>> list;
  for (const Explanation& x : study.diagnosis.explanations)
    if (x.fitted && !x.ids.empty() && x.kind == Hypothesis::Kind::effect) {
      if (may_be_tried(x.fit.effects)) list.push_back(x.fit.effects);
      break;
    }
  const FreeSet* best = nullptr;
  for (const auto& [ids, set] : study.free->sets)
    if (ids.size() == 1 && may_be_tried(set.fit.effects) && (!best || set.log_evidence > best->log_evidence))
      best = &set;
  constexpr double two_to_one = 0.693;
  if (best && best->log_evidence > two_to_one && (list.empty() || ids_of(list.front()) != ids_of(best->fit.effects)))
    list.push_back(best->fit.effects);
  return list;
}

/// A size outside its prior range takes up something else.
bool inside(const std::vector<Applied>& effects) {
  return std::all_of(effects.begin(), effects.end(), [](const Applied& a) {
    const effects::Parameter& p = a.effect.parameters.front();
    return a.values.front() >= p.low && a.values.front() <= p.high;
  });
}

/// What runs left out do not bear out is not certain, however well it fits those at hand. Joints are not asked: free
/// runs do not see them.
void doubt_what_does_not_help(Diagnosis& d, const HeldOut& held_out) {
  if (held_out.runs.empty() || held_out.helps()) return;
  for (Claim& claim : d.claims)
    if (!claim.applied.effect.fine &&
        std::any_of(d.augmented.begin(), d.augmented.end(), [&](const Applied& a) { return a.effect.id == claim.id; }))
      claim.probability = std::min(claim.probability, most_unproven);
  std::stable_sort(d.claims.begin(), d.claims.end(),
                   [](const Claim& a, const Claim& c) { return a.probability > c.probability; });
  if (d.verdict == Verdict::found && d.claims.front().probability <= most_unproven) d.verdict = Verdict::ambiguous;
}

}  // namespace

void augment(Study& study) {
  Diagnosis& d = study.diagnosis;
  study.strength = study.free->none.strength;
  std::optional<Augmented> chosen;
  if (!d.augmented.empty()) {
    chosen = tested(*study.free, d.augmented);
    // Another form may serve predictions better, but does not stand for the claimed one.
    if (chosen && !same_forms(chosen->fit.effects, d.augmented))
      if (auto own = tested(*study.free, d.augmented, true); own && !own->held_out.helps()) chosen = std::move(own);
  } else if (d.verdict == Verdict::ambiguous || d.verdict == Verdict::unexplained) {
    for (const auto& effects : tries(study))
      if (auto one = tested(*study.free, effects); one && one->held_out.helps() && inside(one->fit.effects) &&
                                                   (!chosen || one->held_out.after < chosen->held_out.after))
        chosen = std::move(one);
    d.tried = chosen.has_value();
  }
  if (!chosen) return;
  d.augmented = chosen->fit.effects, study.strength = chosen->fit.strength, study.held_out = chosen->held_out;
  if (!d.tried) doubt_what_does_not_help(d, study.held_out);
}

}  // namespace apc::learning
