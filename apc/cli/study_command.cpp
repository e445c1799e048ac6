/// `apc study`: what-if sweeps over exit speed, mass, braking and strength, with design envelope and tornado.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/cli/inputs.h"
#include "apc/report/sha256.h"
#include "apc/report/study_record.h"
#include "apc/simulation/together.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  std::string aircraft, bed, speeds, masses, braking = "0", strengths = "1", braking_in_bed, rtol = "1e-6";
  Choice choice;  ///< loads and tires
  fs::path out;
  bool envelope = false, tornado = false;
  unsigned threads = 0;
};

std::vector<std::string> split(const std::string& option, const std::string& text, char at) {
  std::vector<std::string> out{""};
  for (const char letter : text)
    if (letter == at)
      out.emplace_back();
    else
      out.back() += letter;
  for (auto& word : out) {
    while (!word.empty() && word.front() == ' ') word.erase(0, 1);
    while (!word.empty() && word.back() == ' ') word.pop_back();
    require(!word.empty(), option, ": \"", text, "\" has an empty entry. Write values with commas between them");
  }
  return out;
}

/// "40:80:5", "40 kt, 55 kt", "0, 0.25": a range or a list. A bare number is taken in `bare` (0 = not allowed).
std::vector<double> values(const std::string& option, const std::string& text, const Dimension& dimension,
                           double bare) {
  const auto one = [&](const std::string& word) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (bare > 0 && end && *end == '\0' && std::isfinite(number)) return number * bare;
    return option_quantity(option, word, dimension);
  };
  if (text.find(':') == std::string::npos) {
    std::vector<double> out;
    for (const auto& word : split(option, text, ',')) out.push_back(one(word));
    return out;
  }
  const auto parts = split(option, text, ':');
  require(parts.size() == 3, option, ": \"", text, "\" is no range. Write from:to:step, such as 40:80:5");
  const double from = one(parts[0]), to = one(parts[1]), step = one(parts[2]);
  require(step > 0 && to >= from, option, ": \"", text,
          "\" does not rise from its first value in positive steps to its second");
  require((to - from) / step <= 1000, option, ": \"", text, "\" has more than 1000 values");
  std::vector<double> out;
  const auto count = static_cast<int>(std::floor((to - from) / step + 1e-9));
  for (int i = 0; i <= count; ++i) out.push_back(from + i * step);
  return out;
}

void check_range(const std::string& option, const std::vector<double>& list, double low, double high, double unit,
                 const char* name) {
  for (const double value : list)
    require(value >= low && value <= high, option, ": ", value / unit, " ", name, " is outside ", low / unit, " to ",
            high / unit);
}

study::Axes read_axes(const Words& words) {
  study::Axes axes;
  axes.speeds = values("--speeds", words.speeds, dimension::speed, units::kt);
  check_range("--speeds", axes.speeds, 5 * units::kt, 150 * units::kt, units::kt, "kt");
  axes.brakings = values("--braking", words.braking, dimension::none, 1.0);
  check_range("--braking", axes.brakings, 0.0, 1.0, 1.0, "(friction coefficient)");
  axes.strengths = values("--strengths", words.strengths, dimension::none, 1.0);
  check_range("--strengths", axes.strengths, 0.2, 3.0, 1.0, "(share of the nominal strength)");
  if (!words.braking_in_bed.empty()) {
    axes.braking_in_bed = option_quantity("--braking-in-bed", words.braking_in_bed, dimension::none);
    check_range("--braking-in-bed", {axes.braking_in_bed}, 0.0, 1.0, 1.0, "(friction coefficient)");
  }
  axes.mass_factors = {1.0};
  if (words.masses.empty()) return axes;
  // Bare numbers are shares of each aircraft's own mass; quantities are masses.
  const bool shares = words.masses.find_first_not_of("0123456789.,: +eE") == std::string::npos;
  if (shares) {
    axes.mass_factors = values("--masses", words.masses, dimension::none, 1.0);
    check_range("--masses", axes.mass_factors, 0.4, 1.6, 1.0,
                "(share of the aircraft file's mass; write \"66 t\" for a mass)");
  } else {
    axes.masses = values("--masses", words.masses, dimension::mass, 0.0);
  }
  return axes;
}

struct Loaded {
  std::vector<simulation::Model> models;
  std::vector<report::InputFile> files;
};

Loaded load(const Words& words) {
  Loaded out;
  for (const auto& aircraft : split("--aircraft", words.aircraft, ','))
    for (const auto& bed : split("--bed", words.bed, ',')) {
      auto choice = words.choice;
      choice.aircraft = aircraft, choice.bed = bed;
      auto inputs = read_inputs(choice);
      out.models.push_back(std::move(inputs.model));
      for (const auto& file : inputs.files) {
        const bool known = std::any_of(out.files.begin(), out.files.end(),
                                       [&](const report::InputFile& other) { return other.path == file.path; });
        if (!known) out.files.push_back(file);
      }
    }
  return out;
}

/// A name for everything the cases of this study depend on, apart from the axes: more speeds continue the same store.
std::string identity(const Loaded& loaded, const Words& words) {
  std::string all = APC_VERSION;
  for (const auto& file : loaded.files) all += file.sha256;
  for (const auto& model : loaded.models) all += model.aircraft.name + "/" + model.bed.name + ";";
  return study::fingerprint(all + words.rtol);
}

study::Envelope envelope_of(const simulation::Model& model, const study::Axes& axes, const study::Solve& solve,
                            study::Store& store, const study::SweepOptions& options) {
  study::EnvelopeInput input;
  input.model = model;
  input.overrun.braking = axes.brakings.front(), input.overrun.braking_in_bed = axes.braking_in_bed;
  for (int inches = 6; inches <= 30; inches += 2) input.depths.push_back(inches * units::in);
  for (int knots = 40; knots <= 80; knots += 10) input.speeds.push_back(knots * units::kt);
  return study::envelope(input, solve, store, options);
}

/// The files hold what was solved; that some was not must not pass for done.
void report_failures(const report::StudyRecord& record) {
  constexpr std::size_t named = 5;
  std::size_t failed = 0;
  std::string which;
  for (const auto& each : record.results) {
    if (each.failure.empty() || ++failed > named) continue;
    const auto& model = record.models[each.input.model];
    const auto& run = each.input.overrun;
    which += fmt::format("\n  {} in {}, {:.4g} kt, {:.0f} kg, braking {:.3g}, strength {:.3g}: {}", model.aircraft.name,
                         model.bed.name, run.entry_speed / units::kt, run.mass, run.braking,
                         run.alterations.bed_strength, each.failure);
  }
  if (failed == 0) return;
  if (failed > named) which += fmt::format("\n  and {} more (outcome gave_up in study.csv)", failed - named);
  throw SolveError(concat("the solver gave up in ", failed, " of ", record.results.size(), " cases:", which));
}

void run_study(const Words& words, Settings& settings) {
  const auto axes = read_axes(words);
  const double rtol = option_quantity("--rtol", words.rtol, dimension::none);
  require(rtol >= 1e-12 && rtol <= simulation::loosest_rtol, "--rtol: ", words.rtol, " is outside 1e-12 to ",
          simulation::loosest_rtol);
  auto loaded = load(words);
  const auto folder = words.out.empty() ? fs::path("out") / "study" : words.out;
  settings.results = {folder / "study.csv", folder / "study.json", folder / "study.html"};
  const auto id = identity(loaded, words);
  study::Store store(folder / "cases.store", id);
  const auto cases = study::combinations(loaded.models, axes);
  const auto start = std::chrono::steady_clock::now();

  study::SweepOptions options;
  const simulation::Together solve(words.threads);  // overruns asked for at the same time run side by side
  options.solver.rtol = rtol, options.threads = solve.callers();
  std::unique_ptr<Progress> progress;
  if (!settings.quiet) progress = std::make_unique<Progress>("overruns", static_cast<double>(cases.size()));
  std::mutex guard;
  if (progress)
    options.finished = [&](std::size_t finished) {
      const std::lock_guard lock(guard);
      progress->show(static_cast<double>(finished));
    };
  report::StudyRecord record;
  record.axes = axes;
  record.results = study::run(loaded.models, cases, solve, store, options);
  options.finished = {};
  // One envelope store per aircraft: the cases of an envelope count their models from 0.
  if (words.envelope)
    for (std::size_t m = 0; m < loaded.models.size(); ++m) {
      const bool known =
          std::any_of(record.envelopes.begin(), record.envelopes.end(),
                      [&](const study::Envelope& each) { return each.aircraft == loaded.models[m].aircraft.name; });
      if (known) continue;
      study::Store own(folder / fmt::format("envelope_{}.store", m), id);
      record.envelopes.push_back(envelope_of(loaded.models[m], axes, solve, own, options));
    }
  if (words.tornado)
    for (std::size_t m = 0; m < loaded.models.size(); ++m) {
      simulation::Overrun centre;
      centre.entry_speed = axes.speeds.back(), centre.braking = axes.brakings.front();
      centre.braking_in_bed = axes.braking_in_bed;
      study::Store own(folder / fmt::format("tornado_{}.store", m), id);
      record.tornados.push_back(study::tornado(loaded.models[m], centre, solve, own, options));
    }
  progress.reset();
  record.models = std::move(loaded.models);
  record.remembered = std::min(store.found(), cases.size());
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.manifest = {std::string("apc ") + APC_VERSION, settings.command_line, utc_now(), std::move(loaded.files)};

  const auto json = report::study_json(record), csv = report::study_csv(record), page = report::study_page(record);
  write_text(folder / "study.csv", csv);
  write_text(folder / "study.json", json);
  write_text(folder / "study.html", page);
  settings.results.clear();  // made; a case that failed is told below, and stands in the table
  if (!settings.json.empty()) write_text(settings.json, json);
  if (!settings.quiet) {
    std::fputs(report::study_brief(record, settings.units).c_str(), stdout);
    std::printf("  page      %s\n  also      study.json, study.csv beside it\n", (folder / "study.html").c_str());
  }
  report_failures(record);
}

}  // namespace

void add_study(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand(
      "study", "what-if sweeps: exit speed, mass, braking, strength; carpets, envelope, tornado");
  const auto words = std::make_shared<Words>();
  command->add_option("--aircraft", words->aircraft, "one or more, with commas between")->required()->type_name("A,B");
  command->add_option("--bed", words->bed, "one or more, with commas between")->required()->type_name("B,C");
  command->add_option("--speeds", words->speeds, "exit speeds: 40:80:5 (kt) or \"40 kt, 55 kt\"")
      ->required()
      ->type_name("RANGE");
  command
      ->add_option("--masses", words->masses, "shares of the file's mass (0.8,1) or masses (\"60 t, 66 t\"); default 1")
      ->type_name("LIST");
  command->add_option("--braking", words->braking, "friction coefficients of the braked wheels (default 0)")
      ->type_name("LIST");
  command->add_option("--braking-in-bed", words->braking_in_bed, "the same inside the bed (default: as before it)")
      ->type_name("NUMBER");
  command
      ->add_option("--strengths", words->strengths,
                   "shares of the material's crushing strength: 0.8:1.2:0.1 (default 1)")
      ->type_name("LIST");
  command->add_flag("--envelope", words->envelope, "also contours of exit speed over depth and length");
  command->add_flag("--tornado", words->tornado, "also what each input's uncertainty does, at the highest speed");
  command->add_option("--loads", words->choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command->add_option("--tires", words->choice.tires, "tire library")->type_name("FILE");
  command->add_option("--rtol", words->rtol, "relative tolerance of the integration (default 1e-6)")
      ->type_name("NUMBER");
  command->add_option("--threads", words->threads, "default: all")->type_name("N");
  command->add_option("-o,--out", words->out, "folder of the files and of the finished cases (default out/study)")
      ->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Every combination is one overrun by the fast method. Interrupted, the same command continues where it was.\n"
      "Example: apc study --aircraft B737-800,CRJ-200 --bed emas_18in_50psi --speeds 40:80:5 --masses 0.8,1 --tornado");
  command->callback([words, &settings] { run_study(*words, settings); });
}

}  // namespace apc::cli
