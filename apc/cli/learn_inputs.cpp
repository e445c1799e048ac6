#include "apc/cli/learn_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/effects/effect_json.h"
#include "apc/effects/other_forms.h"

namespace apc::cli {

void add_case_options(CLI::App& command, const std::shared_ptr<LearnWords>& words) {
  command.add_option("case", words->folder, "folder with case.json")->required();
  command.add_option("--aliases", words->aliases, "names and units of a flight recorder's columns (apc-aliases/1)");
  command.add_option("--effect", words->own, "your own effects (apc-effect/1), ranked beside the catalogue");
  command.add_option("--threads", words->threads, "threads, 0 = all");
}

learning::Case load(const LearnWords& words) {
  return learning::load_case(words.folder, words.aliases.empty() ? std::nullopt : std::optional(words.aliases));
}

std::vector<effects::Effect> known_effects(const LearnWords& words) {
  std::vector<effects::Effect> known = effects::catalogue();
  for (const auto& path : words.own) known.push_back(effects::load_own_effect(path));
  return known;
}

learning::Study study_of(const learning::Case& data, const LearnWords& words, const Settings& settings) {
  learning::DiagnoseOptions options;
  options.threads = words.threads;
  options.effects = known_effects(words);
  const auto progress = settings.quiet ? nullptr : std::make_shared<Progress>("diagnosing " + data.title);
  if (progress) options.report = [progress](double share, const std::string& what) { progress->show(share, what); };
  return learning::diagnose(data, options);
}

std::optional<learning::NextPlan> plan_of(const learning::Case& data, learning::Study& study, const LearnWords& words,
                                          const Settings& settings) {
  learning::Diagnosis& d = study.diagnosis;
  if (d.verdict != learning::Verdict::ambiguous && d.verdict != learning::Verdict::found) return std::nullopt;
  std::vector<effects::Applied> claims;
  for (const auto& claim : d.claims) claims.push_back(claim.applied);
  const auto known = known_effects(words);
  const auto contenders = learning::contenders_of(d.set90, d.rivals, claims, known);
  if (contenders.size() < 2) return std::nullopt;
  const auto began = std::chrono::steady_clock::now();
  learning::NextOptions options;
  options.threads = words.threads, options.coarse = true;
  const auto progress = settings.quiet ? nullptr : std::make_shared<Progress>("next run for " + data.title);
  if (progress) options.report = [progress](double share, const std::string& what) { progress->show(share, what); };
  std::optional<learning::NextPlan> plan;
  try {
    plan = learning::plan_next(data, contenders, known, options);
    d.next = plan->recommended();
  } catch (const SolveError&) {
    // A diagnosis stands without a recommendation; `apc next` says what went wrong.
  }
  d.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return plan;
}

std::string verdict_text(const learning::Study& study) {
  const learning::Diagnosis& d = study.diagnosis;
  std::string out =
      "warning: experimental. Odds and tempers were chosen on measured cases with known truth, where the right effect\n"
      "came first in two of three and weak ones stayed silent (apc/doc/verification.md); on others nobody has\n"
      "checked. Take the ranking as a hint where to look.\n" +
      fmt::format("VERDICT  {}", learning::text(d.verdict));
  if (!d.learned.empty()) out += ": a force that follows \"" + d.learned + "\", none of the catalogue";
  out += "\n";
  for (const auto& claim : d.claims) {
    if (claim.probability < 0.05) continue;
    out += fmt::format("  {:<18} P {:.2f}  family-wise p {:.4f} ", effects::named(claim.applied.effect),
                       claim.probability, claim.p_family_wise);
    for (std::size_t k = 0; k < claim.applied.values.size(); ++k) {
      const auto& p = claim.applied.effect.parameters[k];
      const double factor = p.unit.empty() ? 1.0 : parse_unit(p.unit).factor;
      const bool free = k < claim.deviation.size() && std::isfinite(claim.deviation[k]);
      out += fmt::format(" {} {:.4g}{}{}", p.name, claim.applied.values[k] / factor,
                         free ? fmt::format(" ± {:.2g}", claim.deviation[k] / factor) : "",
                         p.unit.empty() ? "" : " " + p.unit);
    }
    out += "\n";
  }
  if (!study.held_out.runs.empty()) {
    std::string names;
    for (const auto& a : d.augmented) names += (names.empty() ? "" : " and ") + effects::named(a.effect);
    out += fmt::format("RUNS LEFT OUT  error {:.2f} without, {:.2f} with {}{}\n", study.held_out.before,
                       study.held_out.after, names,
                       !study.held_out.helps() ? ": no help, not added to the model"
                       : d.tried               ? ": added, though which effect it is stays open"
                                               : "");
  }
  if (!d.rivals.empty()) {
    out += "CANNOT TELL APART\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(6, d.rivals.size()); ++i)
      out += fmt::format("  {} | {}   correlation {:+.2f}, {:.1f} deviations apart\n", d.rivals[i].a, d.rivals[i].b,
                         d.rivals[i].correlation, d.rivals[i].separability);
  }
  out += "NOT MISSING ABOVE (90 % power)\n ";
  for (const auto& [name, value] : d.smallest_detectable) out += fmt::format(" {} {:.3g} (SI)", name, value);
  out += "\n";
  if (!d.sensors.empty()) out += "SENSORS\n";
  for (std::size_t i = 0; i < std::min<std::size_t>(4, d.sensors.size()); ++i) {
    const auto& s = d.sensors[i];
    out += fmt::format("  {} {}: {:.4g} ± {:.2g} (SI)\n", s.run.empty() ? "all runs" : s.run, s.what, s.value,
                       s.deviation);
  }
  if (!d.next.empty()) {
    const auto& next = d.next.front();
    out += fmt::format("NEXT  {:.0f} kt, {:.0f} kg,", next.speed / units::kt, next.mass);
    for (const learning::Quantity q : next.sensors) out += " " + learning::name_of(q);
    out += fmt::format("{}: {:.1f} deviations between the two hardest to tell apart; see apc next\n",
                       next.survey ? " and a rut survey" : "", next.separation);
  }
  for (const auto& remark : study.background.data->remarks)
    out += fmt::format("DATA  {} {}: {}\n", remark.run, remark.channel, remark.text);
  return out;
}

}  // namespace apc::cli
