#include "apc/learning/verdict.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "apc/learning/free_evidence.h"

namespace apc::learning {
namespace {

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

/// Nothing is missing, too, where that is so many times as probable as the most probable effect or a force to be
/// learned: many that are hardly possible are not one that is likely. Only where all effects are weighed alike.
constexpr double outshine = 3.0;

}  // namespace

const char* text(Verdict verdict) {
  static const char* const names[] = {"found", "ambiguous", "nothing", "unexplained", "sensor"};
  return names[static_cast<std::size_t>(verdict)];
}

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
  // Dates raise or lower whole runs, as their own scatter does: laws of them go into predictions when near certain.
  for (const Claim& c : d.claims)
    if (c.probability >= (known_by_date(c.applied.effect) ? 0.8 : 0.5) && d.verdict != Verdict::nothing &&
        d.verdict != Verdict::sensor)
      d.augmented.push_back(c.applied);
}

}  // namespace apc::learning
