/// `apc sph verify|converge|bench`: the published cases by particles and elements, their convergence, what their unsaid
/// choices move, and the throughput of this machine.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/cli/sph_deck.h"
#include "apc/cli/sph_studies.h"

namespace apc::cli {
namespace {

struct StudyWords {
  std::string study, spacing, sizes, method, form = "mass", spin = "free", entry, elements = "one_point",
                                             hourglass = "stiffness";
  std::filesystem::path checkpoints;
  double friction = -1.0, hourglass_factor = 0.05;
  bool span = false, quick = false;
  unsigned threads = 0;
};

/// What a word stands for; InputError naming the choices.
template <class T>
T choice(const std::string& option, const std::string& word, const std::vector<std::pair<std::string, T>>& choices) {
  std::string known;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw InputError(concat(option, ": \"", word, "\" is none of ", known));
}

/// A published case by its name, or a deck by its path.
sph::Study study_of(const StudyWords& words) {
  return words.study.ends_with(".json") ? sph::Study::deck : sph::study_of(words.study);
}

sph::StudyOptions options_of(const StudyWords& words, Progress* line) {
  require(words.threads <= 1024, "--threads: ", words.threads, ". Between 1 and 1024 are possible, 0 takes all");
  require(words.friction <= 2.0, "--friction: ", words.friction, ". Between 0 and 2 are possible");
  require(words.hourglass_factor >= 0.0 && words.hourglass_factor <= 1.0,
          "--hourglass-factor: ", words.hourglass_factor, ". Between 0 and 1 are possible");
  sph::StudyOptions options;
  if (study_of(words) == sph::Study::deck) {
    require(!words.span && words.spin == "free" && words.entry.empty(), words.study,
            ": a deck says itself how the wheel spins and enters. Leave out --span, --spin and --entry");
    options.deck = read_deck(words.study).rig;
  }
  options.friction = words.friction;
  options.form =
      choice<sph::PairForm>("--form", words.form, {{"mass", sph::PairForm::mass}, {"volume", sph::PairForm::volume}});
  options.spin = choice<sph::WheelSpin>(
      "--spin", words.spin,
      {{"free", sph::WheelSpin::free}, {"driven", sph::WheelSpin::driven}, {"locked", sph::WheelSpin::locked}});
  if (!words.entry.empty()) {
    options.entry = option_quantity("--entry", words.entry, dimension::length);
    require(options.entry > 0.0 && options.entry < 10.0, "--entry: \"", words.entry,
            "\" is no way to roll in. Try \"50 in\"");
  }
  options.elements.integration = choice<sph::fem::Integration>(
      "--elements", words.elements,
      {{"one_point", sph::fem::Integration::one_point}, {"full", sph::fem::Integration::full}});
  options.elements.hourglass = choice<sph::fem::Hourglass>(
      "--hourglass", words.hourglass,
      {{"stiffness", sph::fem::Hourglass::stiffness}, {"viscosity", sph::fem::Hourglass::viscosity}});
  options.elements.hourglass_factor = words.hourglass_factor;
  options.checkpoint = words.checkpoints;
  options.threads = words.threads == 0 ? hardware_threads() : words.threads;
  options.stop = stop_requested;
  if (line) options.progress = [line](double share, const std::string& remark) { line->show(share, remark); };
  return options;
}

std::vector<sph::Method> methods_of(const StudyWords& words) {
  using Methods = std::vector<sph::Method>;
  return choice<Methods>("--method", words.method,
                         {{"sph", Methods{sph::Method::sph}},
                          {"fem", Methods{sph::Method::fem}},
                          {"both", Methods{sph::Method::sph, sph::Method::fem}}});
}

double read_size(const std::string& option, const std::string& text) {
  const double size = option_quantity(option, text, dimension::length);
  require(size >= 2 * units::mm && size <= 8 * units::in, option, ": \"", text,
          "\" does not resolve the case. The published sizes are 1 to 4 in");
  return size;
}

std::unique_ptr<Progress> line_of(const Settings& settings, const std::string& what) {
  return settings.quiet ? nullptr : std::make_unique<Progress>(what);
}

void verify(const StudyWords& words, Settings& settings) {
  const auto study = study_of(words);
  auto line = line_of(settings, concat("SPH case ", words.study));
  auto options = options_of(words, line.get());
  const double spacing = !words.spacing.empty()      ? read_size("--h", words.spacing)
                         : study == sph::Study::deck ? options.deck.spacing
                                                     : 2 * units::in;
  std::vector<sph::Verification> runs;
  std::vector<sph::SpanRow> span;
  for (const auto method : methods_of(words)) {
    options.method = method;
    runs.push_back(sph::verify(study, spacing, options));
  }
  if (words.span) {
    options.method = runs.front().method;
    span = sph::span(study, spacing, options);
  }
  line.reset();
  if (!settings.json.empty()) write_text(settings.json, verification_json(runs, span, settings.command_line));
  if (!settings.quiet) {
    std::fputs(verification_text(runs, settings.units).c_str(), stdout);
    if (!span.empty()) std::fputs(span_text(span, settings.units).c_str(), stdout);
  }
  for (const auto& run : runs)
    if (run.state != "steady" && run.state != "done")
      throw SolveError(concat(words.study, ": ", run.state, ": ", run.message, ". Try other sizes"));
}

void converge(const StudyWords& words, Settings& settings) {
  const auto study = study_of(words);
  std::vector<double> sizes;
  for (std::size_t start = 0; start < words.sizes.size();) {
    const auto comma = std::min(words.sizes.find(',', start), words.sizes.size());
    sizes.push_back(read_size("--sizes", words.sizes.substr(start, comma - start)));
    start = comma + 1;
  }
  auto line = line_of(settings, concat("convergence of ", words.study));
  auto options = options_of(words, line.get());
  if (sizes.empty() && study == sph::Study::deck)
    for (const double share : {1.0, 0.75, 0.5}) sizes.push_back(share * options.deck.spacing);
  if (sizes.empty()) sizes = sph::published_sizes(study);
  require(sizes.size() >= 3, "--sizes: \"", words.sizes, "\" holds fewer than three sizes. Write \"4 in, 2 in, 1 in\"");
  std::vector<sph::Convergence> studies;
  const auto methods = methods_of(words);
  const double elements = 10.0;  // their work in that of particles, about
  const double whole = methods.size() > 1 ? 1.0 + elements : 1.0;
  double done = 0.0;
  for (const auto method : methods) {
    options.method = method;
    const bool fem = method == sph::Method::fem;
    const double part = methods.size() > 1 && fem ? elements : 1.0;
    if (line)
      options.progress = [&](double share, const std::string& remark) {
        line->show((done + part * share) / whole, concat(fem ? "elements " : "particles ", remark));
      };
    studies.push_back(sph::converge(study, sizes, options));
    done += part;
  }
  line.reset();
  if (!settings.json.empty()) write_text(settings.json, convergence_json(studies, settings.command_line));
  if (!settings.quiet) std::fputs(convergence_text(studies, settings.units).c_str(), stdout);
}

void bench(const StudyWords& words, Settings& settings) {
  require(words.threads <= 1024, "--threads: ", words.threads, ". Between 1 and 1024 are possible, 0 takes all");
  sph::BenchOptions options;
  options.threads = words.threads == 0 ? hardware_threads() : words.threads;
  options.quick = words.quick;
  options.stop = stop_requested;
  auto line = line_of(settings, "bench");
  if (line) options.progress = [&](double share, const std::string& remark) { line->show(share, remark); };
  const auto result = sph::measure_throughput(options);
  line.reset();
  if (!settings.json.empty()) write_text(settings.json, bench_json(result, settings.command_line));
  if (!settings.quiet) std::fputs(bench_text(result).c_str(), stdout);
}

}  // namespace

void add_sph_studies(CLI::App& sph, Settings& settings) {
  const auto add = [&](const char* name, const char* what, void (*work)(const StudyWords&, Settings&)) {
    auto* command = sph.add_subcommand(name, what);
    const auto words = std::make_shared<StudyWords>();
    command->add_option("--threads", words->threads, "0 = all")->type_name("N")->capture_default_str();
    add_common_options(*command, settings);
    command->callback([words, work, &settings] { work(*words, settings); });
    return std::pair{command, words};
  };
  const auto add_case = [](CLI::App& command, StudyWords& words, const char* method) {
    command.add_option("CASE", words.study, "platen_1d, roller_2d, tire_3d, punch_2d, or a deck (FILE.json)")
        ->required()
        ->type_name("");
    words.method = method;
    command.add_option("--method", words.method, "sph, fem or both")->capture_default_str();
    command
        .add_option("--form", words.form, "pair sums of the particles: mass, or volume for comparison (decisions.md)")
        ->capture_default_str();
    command.add_option("--friction", words.friction, "of tire on foam (default 0 roller, 0.3 tire)");
    command.add_option("--spin", words.spin, "free, driven (at v/R) or locked")->capture_default_str();
    command.add_option("--entry", words.entry, "roll in at full speed over this way (default: pressed in)")
        ->type_name("LENGTH");
    command.add_option("--elements", words.elements, "one_point or full integration")->capture_default_str();
    command.add_option("--hourglass", words.hourglass, "stiffness or viscosity")->capture_default_str();
    command.add_option("--hourglass-factor", words.hourglass_factor, "of that control")->capture_default_str();
    command.add_option("--checkpoints", words.checkpoints, "folder; an interrupted particle run continues from there")
        ->type_name("DIR");
  };
  const auto [verified, verify_words] = add("verify", "a published case beside the published values", verify);
  add_case(*verified, *verify_words, "sph");
  verified->add_option("--h", verify_words->spacing, "particle spacing (default \"2 in\", or the deck's)")
      ->type_name("LENGTH");
  verified->add_flag("--span", verify_words->span,
                     "also vary what the study leaves unsaid: friction, spin, entry, ...");
  const auto [converged, converge_words] =
      add("converge", "a published case over several sizes: order, limit, GCI", converge);
  add_case(*converged, *converge_words, "both");
  converged->footer(
      "On one idle core: platen_1d and roller_2d within a minute, punch_2d two minutes, tire_3d one minute with "
      "particles\n"
      "and ten more with elements; --method sph leaves these out. A line on stderr says how long it will still take.");
  converged
      ->add_option("--sizes", converge_words->sizes, "default: the published ones, or 1, 3/4 and 1/2 of the deck's")
      ->type_name("\"4 in, 2 in, 1 in\"");
  const auto [benched, bench_words] =
      add("bench", "throughput of this machine on the published tire case, beside its limits", bench);
  benched->add_flag("--quick", bench_words->quick, "a small bed: to see that it works, not to quote");
  benched->footer("About a minute on an idle machine. Other work on it shows in the figures.");
}

}  // namespace apc::cli
