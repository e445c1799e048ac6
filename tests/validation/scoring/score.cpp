#include "score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scoring {
namespace {

/// Regularised incomplete beta by its continued fraction (Numerical Recipes 6.4).
double incomplete_beta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - incomplete_beta(b, a, 1.0 - x);
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x)) / a;
  double f = 1.0, c = 1.0, d = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const int m = i / 2;
    const double numerator = i == 0       ? 1.0
                             : i % 2 == 0 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                                          : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1.0 + numerator * d;
    if (std::abs(d) < 1e-300) d = 1e-300;
    d = 1.0 / d;
    c = 1.0 + numerator / c;
    if (std::abs(c) < 1e-300) c = 1e-300;
    f *= c * d;
    if (std::abs(c * d - 1.0) < 1e-12) break;
  }
  return front * (f - 1.0);
}

double beta_quantile(double p, double a, double b) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (incomplete_beta(a, b, middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double quantile(std::vector<double> v, double share) {
  if (v.empty()) return std::nan("");
  std::sort(v.begin(), v.end());
  const double place = share * static_cast<double>(v.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  return i + 1 < v.size() ? v[i] + (place - static_cast<double>(i)) * (v[i + 1] - v[i]) : v[i];
}

std::string joined(const std::set<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) text += (text.empty() ? "" : "+") + id;
  return text.empty() ? "nothing" : text;
}

struct Scorer {
  Table table;
  std::vector<double> amplitude_errors, work_errors, gains, brier, log_scores, seconds;
  std::vector<std::pair<double, bool>> reliability;

  void fail(const Truth& t, const Answer& a, const std::string& why) {
    std::string said = a.readable ? a.verdict : "no answer";
    for (const Claim& c : a.effects)
      if (c.probability >= 0.1) {
        char text[96];
        std::snprintf(text, sizeof text, " %s %.2f", c.id.c_str(), c.probability);
        said += text;
      }
    table.failures.push_back(t.name + " " + t.kind + (t.decidable ? "" : " (hard)") + " truth " + joined(t.ids()) +
                             ": " + why + "; said " + said);
  }

  void one(const Truth& t, const Answer& a, const std::filesystem::path& folder, const std::filesystem::path& answers);
  void effects_named(const Truth&, const Answer&);
  void numbers_of(const Truth&, const Answer&);
  void held(const Truth&, const std::filesystem::path& folder, const std::filesystem::path& answers);
};

void Scorer::effects_named(const Truth& t, const Answer& a) {
  const bool speaks = a.verdict == "found" || a.verdict == "ambiguous";
  const std::string first = speaks && !a.effects.empty() ? a.effects.front().id : "";
  const auto claimed = [&](const std::string& id) {
    return std::any_of(a.effects.begin(), a.effects.end(),
                       [&](const Claim& c) { return c.id == id && c.probability >= 0.5; });
  };
  if (t.kind == "M" || t.kind == "X") {
    const bool right = first == t.effects.front().id;
    table.shares["1 first, " + t.kind + (t.decidable ? " decidable" : " hard")].count(right);
    if (!right) fail(t, a, "not first");
  }
  if (t.kind == "P") {
    int both = 0;
    for (const TrueEffect& e : t.effects) both += claimed(e.id) ? 1 : 0;
    table.shares[std::string("1 both, P") + (t.decidable ? " decidable" : " hard")].count(both == 2);
    table.shares[std::string("1 one of two, P") + (t.decidable ? " decidable" : " hard")].count(both >= 1);
    if (both < 2) fail(t, a, both == 1 ? "one of two" : "none of two");
  }
  const bool silent = a.verdict == "nothing" || a.verdict == "sensor";
  const auto holds = [&](const std::set<std::string>& ids) {
    return std::find(a.set90.begin(), a.set90.end(), ids) != a.set90.end();
  };
  if (t.kind != "U") {
    table.shares["2 truth in set90"].count(holds(t.ids()) || (t.kind == "N" && silent));
    if (t.kind != "C")
      table.numbers["set size sum"] += static_cast<double>(a.set90.size()), table.numbers["set size count"] += 1.0;
  }
  if (t.kind == "N") {
    table.shares["3 false alarm"].count(a.verdict == "found");
    if (a.verdict == "found") fail(t, a, "false alarm");
  }
  bool confident_wrong = false;
  for (const Claim& c : a.effects) confident_wrong |= c.probability >= 0.8 && !t.ids().contains(c.id);
  table.shares["4 confident wrong"].count(confident_wrong);
  if (confident_wrong) fail(t, a, "confident and wrong");
  if (t.kind == "U") {
    table.shares["5 unexplained"].count(a.verdict == "unexplained");
    table.shares["5 blamed on the catalogue"].count(confident_wrong);
    if (a.verdict != "unexplained") fail(t, a, "not unexplained");
  }
  if (t.kind == "C") {
    const std::set<std::string> ids = t.ids();
    const bool inside = holds(ids);
    const double visible = t.effects.empty() ? 0.0 : t.effects.front().detectability;
    const bool found = a.verdict == "found" && first == t.effects.front().id;
    if (!(silent && visible < 4.0)) {
      const bool right =
          found ||
          (a.verdict == "ambiguous" &&
           std::any_of(a.set90.begin(), a.set90.end(),
                       [&](const auto& m) { return std::includes(m.begin(), m.end(), ids.begin(), ids.end()); })) ||
          (a.set90.size() >= 2 && inside);
      table.shares["6 cannot tell"].count(right);
      if (!right) fail(t, a, "not told as ambiguous");
    }
  }
  if (t.kind == "E") {
    const bool right = a.verdict != "found" || (!t.effects.empty() && first == t.effects.front().id);
    table.shares["12 odd data"].count(right);
    if (!right) fail(t, a, "false claim on odd data");
  }
  for (const Claim& c : a.effects) {
    const bool right = t.ids().contains(c.id);
    const double p = std::clamp(c.probability, 0.01, 0.99);
    brier.push_back(std::pow(c.probability - (right ? 1.0 : 0.0), 2));
    log_scores.push_back(-std::log(right ? p : 1.0 - p));
    reliability.emplace_back(c.probability, right);
  }
}

void Scorer::numbers_of(const Truth& t, const Answer& a) {
  for (const TrueEffect& e : t.effects) {
    const auto claim = std::find_if(a.effects.begin(), a.effects.end(), [&](const Claim& c) { return c.id == e.id; });
    if (claim == a.effects.end()) continue;
    if (t.kind == "M" && e.law == "catalogue" && e.parameters.contains(e.amplitude) &&
        claim->parameters.contains(e.amplitude)) {
      double truth = e.parameters.at(e.amplitude), estimate = claim->parameters.at(e.amplitude);
      if (e.id == "lock_up") truth = 0.85 - truth, estimate = 0.85 - estimate;
      amplitude_errors.push_back(std::abs(estimate / truth - 1.0));
      if (claim->interval.contains(e.amplitude)) {
        const auto [low, high] = claim->interval.at(e.amplitude);
        table.shares["7 interval holds the truth"].count(e.parameters.at(e.amplitude) >= low &&
                                                         e.parameters.at(e.amplitude) <= high);
      }
    }
    if (e.id == "depth_as_built" || e.id == "lock_up") continue;
    double wrong = 0.0, size = 0.0;
    for (const auto& [run, work] : claim->work)
      if (t.work.contains(run) && t.work.at(run).contains(e.id))
        wrong += std::abs(work - t.work.at(run).at(e.id)), size += std::abs(t.work.at(run).at(e.id));
    if (size > 0.0) work_errors.push_back(wrong / size);
  }
}

void Scorer::held(const Truth& t, const std::filesystem::path& folder, const std::filesystem::path& answers) {
  for (const auto& [run, known] : t.held) {
    const auto place = answers / t.name / "held";
    const double base = held_error(folder, place / (run + ".base.csv"), run),
                 augmented = held_error(folder, place / (run + ".augmented.csv"), run);
    if (!std::isfinite(base) || !std::isfinite(augmented)) continue;
    table.shares["9 harm"].count(augmented > 1.02 * base);
    if (run == "held2") table.shares["9 harm, held2"].count(augmented > 1.02 * base);
    table.numbers["base error " + t.name + " " + run] = base;
    const bool counts = base - known.ideal > 0.3 * known.ideal && known.base - known.ideal > 0.15 * known.base;
    if (counts) gains.push_back((base - augmented) / (base - known.ideal));
    char text[128];
    std::snprintf(text, sizeof text, "held %s %s %s base %.2f augmented %.2f (range's base %.2f ideal %.2f)%s",
                  t.name.c_str(), t.kind.c_str(), run.c_str(), base, augmented, known.base, known.ideal,
                  counts ? " counts" : "");
    table.failures.push_back(text);
  }
}

void Scorer::one(const Truth& t, const Answer& a, const std::filesystem::path& folder,
                 const std::filesystem::path& answers) {
  table.shares["0 answered"].count(a.readable);
  if (!a.readable) fail(t, a, "no answer");
  effects_named(t, a);
  numbers_of(t, a);
  held(t, folder, answers);
  if (a.seconds) seconds.push_back(*a.seconds);
}

}  // namespace

std::pair<double, double> Share::interval() const {
  return {hits == 0 ? 0.0 : beta_quantile(0.025, hits, of - hits + 1),
          hits == of ? 1.0 : beta_quantile(0.975, hits + 1, of - hits)};
}

std::string Share::text() const {
  const auto [low, high] = interval();
  char line[96];
  std::snprintf(line, sizeof line, "%2d/%2d = %3.0f %%  [%.0f, %.0f]", hits, of, of ? 100.0 * hits / of : 0.0,
                100 * low, 100 * high);
  return line;
}

Table score(const std::filesystem::path& cases, const std::filesystem::path& answers) {
  Scorer scorer;
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(cases))
    if (std::filesystem::exists(entry.path() / "truth" / "truth.json")) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  for (const auto& folder : folders)
    scorer.one(read_truth(folder), read_answer(answers, folder.filename().string()), folder, answers);
  Table& t = scorer.table;
  const auto line = [&](const std::string& name, const std::string& value) {
    t.text += name + std::string(name.size() < 34 ? 34 - name.size() : 1, ' ') + value + "\n";
  };
  for (const auto& [name, share] : t.shares) line(name, share.text());
  const auto number = [&](const std::string& name, double value) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3g", value);
    t.numbers[name] = value;
    line(name, text);
  };
  number("2 mean set size", t.numbers["set size sum"] / std::max(1.0, t.numbers["set size count"]));
  number("7 amplitude error, median", quantile(scorer.amplitude_errors, 0.5));
  number("7 work error, median", quantile(scorer.work_errors, 0.5));
  number("8 held-out gain, median", quantile(scorer.gains, 0.5));
  number("8 held-out gain, 10th percentile", quantile(scorer.gains, 0.1));
  number("8 runs that count", static_cast<double>(scorer.gains.size()));
  double sum = 0.0;
  for (const double b : scorer.brier) sum += b / static_cast<double>(scorer.brier.size());
  number("10 Brier", sum);
  double error = 0.0;
  for (int bin = 0; bin < 10; ++bin) {
    double p = 0.0, hits = 0.0, count = 0.0;
    for (const auto& [claimed, right] : scorer.reliability)
      if (std::min(9, static_cast<int>(claimed * 10.0)) == bin) p += claimed, hits += right ? 1.0 : 0.0, count += 1.0;
    if (count > 0.0) error += std::abs(p - hits) / static_cast<double>(scorer.reliability.size());
  }
  number("10 expected calibration error", error);
  sum = 0.0;
  for (const double l : scorer.log_scores) sum += l / static_cast<double>(scorer.log_scores.size());
  number("10 mean log score", sum);
  number("11 seconds, median", quantile(scorer.seconds, 0.5));
  number("11 seconds, largest", quantile(scorer.seconds, 1.0));
  return t;
}

}  // namespace scoring
