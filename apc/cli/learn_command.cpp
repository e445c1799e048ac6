/// `apc effects`, `apc diagnose`, `apc compare`, `apc add`, `apc verify`, `apc learn`: from measured runs to the
/// missing effect and back into the model.
#include <fmt/format.h>

#include <cmath>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/learn_inputs.h"
#include "apc/effects/other_forms.h"
#include "apc/learning/augment.h"
#include "apc/learning/learn_page.h"
#include "apc/learning/metrics.h"
#include "apc/learning/overlay_json.h"

namespace apc::cli {
namespace {

void say(const Settings& settings, const std::string& text) {
  if (!settings.quiet) fmt::print("{}", text);
}

std::string effect_text(const effects::Effect& e) {
  std::string out = fmt::format("{}: {}\n  law      {}\n  source   {}\n  touches  {}\n  mimics   {}\n", e.id, e.title,
                                e.law, e.source, e.touches, e.confused_with);
  for (const auto& p : e.parameters) {
    const double factor = p.unit.empty() ? 1.0 : parse_unit(p.unit).factor;
    out += fmt::format("  {:<8} {:g} to {:g} {}, usually {:g}\n", p.name, p.low / factor, p.high / factor, p.unit,
                       p.usual / factor);
  }
  return out;
}

/// What a comparison says: for people, for programs, and whether the effects lower the error.
struct Comparison {
  std::string text, json;
  bool better = false;
};

std::string channel_text(const learning::RunError& plain, const learning::RunError& with, bool added) {
  std::string out;
  if (plain.stop)
    out += fmt::format("  stop {:+.1f} m, u_val {:.1f} m{}\n", plain.stop->error, plain.stop->uncertainty,
                       with.stop && added ? fmt::format("; with the effect {:+.1f} m", with.stop->error) : "");
  for (std::size_t c = 0; c < plain.channels.size(); ++c) {
    const auto &a = plain.channels[c], &b = with.channels[c];
    out += fmt::format("  {:<15} rms {:.3g} (SI){}  Sprague–Geers M {:+.0f} % P {:.0f} %  inside 2 sigma {:.0f} %\n",
                       learning::name_of(a.quantity), a.rms, added ? fmt::format(" -> {:.3g}", b.rms) : "",
                       100 * a.sprague_geers.magnitude, 100 * a.sprague_geers.phase, 100 * a.coverage);
  }
  return out;
}

std::string channel_json(const learning::RunError& plain, const learning::RunError& with) {
  std::string json =
      fmt::format("{{\"error\": {:.5g}, \"error_with\": {:.5g}, \"channels\": {{", plain.total, with.total);
  for (std::size_t c = 0; c < plain.channels.size(); ++c) {
    const auto &a = plain.channels[c], &b = with.channels[c];
    json += fmt::format(
        "{}\"{}\": {{\"rms\": {:.6g}, \"rms_with\": {:.6g}, \"normalised\": {:.5g}, \"normalised_with\": {:.5g}, "
        "\"magnitude\": {:.5g}, \"phase\": {:.5g}, \"coverage\": {:.4g}}}",
        c ? ", " : "", learning::name_of(a.quantity), a.rms, b.rms, a.normalised, b.normalised,
        a.sprague_geers.magnitude, a.sprague_geers.phase, a.coverage);
  }
  json += "}";
  if (plain.stop && with.stop)
    json += fmt::format(", \"stop_error\": {:.5g}, \"stop_error_with\": {:.5g}, \"u_val\": {:.5g}", plain.stop->error,
                        with.stop->error, plain.stop->uncertainty);
  return json + "}";
}

Comparison told(const std::vector<std::pair<learning::RunError, learning::RunError>>& runs, bool added) {
  Comparison c{"", "{\n \"schema\": \"apc-comparison/1\",\n \"runs\": {", false};
  double before = 0.0, after = 0.0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& [plain, with] = runs[r];
    before += plain.total * plain.total, after += with.total * with.total;
    c.text +=
        fmt::format("{}  error {:.2f}{}\n", plain.run, plain.total, added ? fmt::format(" -> {:.2f}", with.total) : "");
    c.text += channel_text(plain, with, added);
    c.json += fmt::format("{}\n  \"{}\": {}", r ? "," : "", plain.run, channel_json(plain, with));
  }
  c.json += "\n }\n}\n";
  c.better = after < before;
  return c;
}

/// Error of every run of a case, free runs: the nominal model, or an overlay beside the strength fitted without it.
Comparison comparison(const learning::Case& data, const learning::Overlay& overlay) {
  const learning::Layout layout = learning::make_layout(data, data.runs);
  Eigen::VectorXd eta = learning::prior_mean(layout, data.runs), learned = eta;
  eta[layout.bed_strength] = std::log(overlay.bed_strength_without_effects);
  learned[layout.bed_strength] = std::log(overlay.bed_strength);
  std::vector<std::pair<learning::RunError, learning::RunError>> runs;
  for (std::size_t r = 0; r < data.runs.size(); ++r) {
    const auto plain = learning::compare(data, layout, r, data.runs[r], eta, {});
    runs.emplace_back(plain, overlay.effects.empty()
                                 ? plain
                                 : learning::compare(data, layout, r, data.runs[r], learned, overlay.effects));
  }
  return told(runs, !overlay.effects.empty());
}

void diagnose_case(const LearnWords& words, const Settings& settings) {
  const learning::Case data = load(words);
  learning::Study study = study_of(data, words, settings);
  plan_of(data, study, words, settings);
  say(settings, verdict_text(study));
  if (!settings.json.empty()) write_text(settings.json, learning::diagnosis_json(study));
  if (!words.out.empty()) {
    write_text(words.out / "diagnosis.json", learning::diagnosis_json(study));
    learning::write_predictions(study, words.out / "held");
  }
}

void learn_case(const LearnWords& words, Settings& settings) {
  const learning::Case data = load(words);
  learning::Study study = study_of(data, words, settings);
  const auto plan = plan_of(data, study, words, settings);
  say(settings, verdict_text(study));
  const auto out = words.out.empty() ? std::filesystem::path("learned") : words.out;
  write_text(out / "diagnosis.json", learning::diagnosis_json(study));
  write_text(out / "report.html", learning::learn_page(study, plan ? &*plan : nullptr));
  learning::write_predictions(study, out / "held");
  if (study.held_out.helps())
    write_text(out / "model.json", learning::overlay_json(study, settings.command_line));
  else
    std::filesystem::remove(out / "model.json");  // of a former study: it would read like this one's
  if (!settings.json.empty()) write_text(settings.json, learning::diagnosis_json(study));
  say(settings, fmt::format("report: {}\n", (out / "report.html").string()));
  switch (study.diagnosis.verdict) {
    case learning::Verdict::found:
      settings.exit_code = 0;
      break;
    case learning::Verdict::nothing:
      settings.exit_code = 4;
      break;
    case learning::Verdict::ambiguous:
      settings.exit_code = 5;
      break;
    case learning::Verdict::unexplained:
      settings.exit_code = 6;
      break;
    case learning::Verdict::sensor:
      settings.exit_code = 7;
      break;
  }
}

/// Refuses (exit 1) effects that do not lower the error of runs they were not fitted to, unless forced.
void add_to_model(const LearnWords& words, Settings& settings) {
  require(!words.out.empty(), "-o: apc add writes an overlay; name it, such as -o model.json");
  const learning::Case data = load(words);
  const auto added = learning::effects_of_diagnosis(words.from, known_effects(words));
  require(!added.empty(), words.from.string(), ": this diagnosis names no effect; there is nothing to add.");
  learning::Study study;
  study.background.data = &data;
  study.background.runs = data.runs;
  study.background.training = data.runs.size();
  study.diagnosis.augmented = added;
  study.diagnosis.verdict = learning::Verdict::found;
  study.free.emplace().runs = learning::free_runs(data, words.threads);
  study.free->none = learning::fit_strength(study.free->runs);
  learning::augment(study);
  std::vector<std::pair<learning::RunError, learning::RunError>> runs;
  for (const auto& one : study.held_out.runs) runs.emplace_back(one.before, one.after);
  const Comparison left_out = told(runs, true);
  say(settings, "Every run predicted from the others, without and with the effects:\n" + left_out.text);
  if (!settings.json.empty()) write_text(settings.json, left_out.json);
  if (study.held_out.runs.size() < 2)
    say(settings, "One run alone proves nothing: no other to predict.\n");
  else
    say(settings, fmt::format("all runs: error {:.2f} -> {:.2f}\n", study.held_out.before, study.held_out.after));
  if (!study.held_out.helps() && !words.force) {
    say(settings, study.held_out.runs.empty()
                      ? std::string("Nothing says that it helps: refused. --force adds it all the same.\n")
                      : fmt::format("It must fall by {:.0f} % to be more than the scatter between {} runs: refused. "
                                    "--force adds it all the same.\n",
                                    100.0 * study.held_out.least_fall(), study.held_out.runs.size()));
    settings.exit_code = exit_code::not_met;
    return;
  }
  write_text(words.out, learning::overlay_json(study, settings.command_line));
}

void compare_case(const LearnWords& words, Settings& settings, bool must_improve) {
  const learning::Case data = load(words);
  const Comparison c = comparison(
      data, words.model.empty() ? learning::Overlay{} : learning::load_overlay(words.model, known_effects(words)));
  say(settings, c.text);
  if (!settings.json.empty()) write_text(settings.json, c.json);
  if (must_improve && !c.better) settings.exit_code = exit_code::not_met;
}

}  // namespace

void add_effects(CLI::App& program, Settings& settings) {
  CLI::App* effects = program.add_subcommand("effects", "the catalogue of effects that may be missing from a model");
  effects->require_subcommand(1);
  CLI::App* list = effects->add_subcommand("list", "ids and laws");
  list->callback([&settings] {
    for (const auto& e : effects::catalogue()) {
      say(settings, fmt::format("{:<16} {}\n", e.id, e.law));
      for (const auto& form : effects::other_forms())
        if (form.id == e.id) say(settings, fmt::format("  or {:<11} {}\n", form.form, form.law));
    }
  });
  CLI::App* show = effects->add_subcommand("show", "law, source, parameters and ranges of one effect");
  const auto id = std::make_shared<std::string>();
  show->add_option("id", *id, "such as seams")->required();
  show->callback([&settings, id] {
    say(settings, effect_text(effects::find_effect(effects::catalogue(), *id)));
    for (const auto& form : effects::other_forms())
      if (form.id == *id) say(settings, fmt::format("\nform {}: ", form.form) + effect_text(form));
  });
}

void add_learning(CLI::App& program, Settings& settings) {
  const auto command = [&](const char* name, const char* help) {
    CLI::App* made = program.add_subcommand(name, help);
    add_common_options(*made, settings);
    const auto words = std::make_shared<LearnWords>();
    add_case_options(*made, words);
    return std::make_pair(made, words);
  };
  const auto [compare, compare_words] = command("compare", "model against measured runs: errors per run and channel");
  compare->add_option("--model", compare_words->model, "overlay with effects (apc-model/1)");
  compare->callback([&settings, w = compare_words] { compare_case(*w, settings, false); });

  const auto [diagnose, diagnose_words] =
      command("diagnose", "which effect is missing (experimental: probabilities not calibrated)");
  diagnose->add_option("-o,--out", diagnose_words->out, "folder for diagnosis and predictions of held-out runs");
  diagnose->callback([&settings, w = diagnose_words] { diagnose_case(*w, settings); });

  const auto [add, add_words] =
      command("add", "adds what a diagnosis found to the model, as an overlay (experimental)");
  add->add_option("--from", add_words->from, "diagnosis.json")->required();
  add->add_option("-o,--out", add_words->out, "overlay to write");
  add->add_flag("--force", add_words->force, "even when the error of runs left out falls too little");
  add->callback([&settings, w = add_words] { add_to_model(*w, settings); });

  const auto [verify, verify_words] = command("verify", "does an overlay lower the error? exit 1 when not");
  verify->add_option("--model", verify_words->model, "overlay (apc-model/1)")->required();
  verify->callback([&settings, w = verify_words] { compare_case(*w, settings, true); });

  const auto [learn, learn_words] = command(
      "learn",
      "compare, diagnose, add, predict; one report (experimental: probabilities not calibrated). Exit 0 found, 4 "
      "nothing, 5 ambiguous, 6 unexplained, 7 sensor");
  learn->add_option("-o,--out", learn_words->out, "folder for the report");
  learn->callback([&settings, w = learn_words] { learn_case(*w, settings); });
}

}  // namespace apc::cli
