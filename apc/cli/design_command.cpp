/// `apc design`: sizes the depth profile of a bed for a fleet.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>

#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/cli/fleet_inputs.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/overlay_json.h"
#include "apc/report/design_record.h"
#include "apc/report/sha256.h"
#include "apc/simulation/together.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  std::string fleet, objective = "length", criterion, length, rtol = "1e-7", pareto;
  Choice choice;
  fs::path out, effects;
  unsigned threads = 0;
};

design::Objective read_objective(const std::string& word) {
  using design::Objective;
  for (const auto each : {Objective::length, Objective::minimax, Objective::volume, Objective::speed})
    if (word == design::text(each)) return each;
  throw InputError("--objective: \"" + word + "\" is no objective. Write length, minimax, volume or speed");
}

void apply_criterion(const std::string& word, design::Fleet& fleet) {
  if (word.empty()) return;
  require(word == "limit" || word == "ultimate", "--criterion: \"", word,
          "\" is no criterion. Write limit or ultimate");
  fleet.limits.criterion = word == "limit" ? design::Criterion::limit : design::Criterion::ultimate;
}

std::vector<double> read_margins(const std::string& text) {
  std::vector<double> out;
  std::string word;
  for (const char letter : text + ",") {
    if (letter != ',') {
      word += letter;
      continue;
    }
    out.push_back(option_quantity("--pareto", word, dimension::none));
    require(out.back() >= 0 && out.back() <= 3, "--pareto: ", word, " is no margin: write shares such as 0,0.1,0.25");
    word.clear();
  }
  return out;
}

/// Every case of the fleet with the effects that were learned; told when a case lies outside what they were learned on.
void add_effects(const fs::path& file, design::Fleet& fleet, FleetModels& loaded) {
  const auto learned = learning::load_overlay(file, effects::catalogue());
  bool outside = false;
  for (auto& each : fleet.cases) {
    each.overrun.alterations.effects = learned.effects;
    each.overrun.alterations.bed_strength *= learned.bed_strength;
    outside |= each.overrun.entry_speed < learned.slowest - 0.5 || each.overrun.entry_speed > learned.fastest + 0.5;
  }
  if (outside)
    std::fprintf(stderr,
                 "warning: %s was learned on runs of %.0f to %.0f kt; cases at other speeds extrapolate its effects\n",
                 file.c_str(), learned.slowest / units::kt, learned.fastest / units::kt);
  loaded.files.push_back({"model", file.string(), report::sha256(read_text(file)), "learned"});
  loaded.identity += loaded.files.back().sha256;
}

void run_design(const Words& words, Settings& settings) {
  design::SizeOptions size;
  size.objective = read_objective(words.objective);
  const auto margins = words.pareto.empty() ? std::vector<double>() : read_margins(words.pareto);
  require(margins.empty() || size.objective == design::Objective::length || size.objective == design::Objective::volume,
          "--pareto: trades length against volume and margin; use it with --objective length or volume");
  const double rtol = option_quantity("--rtol", words.rtol, dimension::none);
  require(rtol >= 1e-12 && rtol <= 1e-4, "--rtol: ", words.rtol,
          " is outside 1e-12 to 1e-4: gradients by differences need it small");
  const auto fleet_file = resolve(words.fleet, "designs/fleets", "fleet");
  auto fleet = design::load_fleet(fleet_file);
  apply_criterion(words.criterion, fleet);
  if (!words.length.empty()) {
    require(size.objective == design::Objective::speed,
            "--length: is given only with --objective speed; otherwise the length is "
            "what is looked for");
    size.length = option_quantity("--length", words.length, dimension::length);
    require(size.length > 2 * fleet.bed.block_length && size.length <= 1000, "--length: \"", words.length,
            "\" is no length of a bed");
  }
  auto loaded = load_fleet_models(fleet, note("fleet", fleet_file, fleet.source), words.choice);
  if (!words.effects.empty()) add_effects(words.effects, fleet, loaded);

  design::Problem problem;
  problem.fleet = fleet, problem.models = std::move(loaded.models);
  const simulation::Together solve(words.threads);  // trials asked for at the same time run side by side
  problem.solver.rtol = rtol, problem.threads = solve.callers();
  problem.solve = solve, problem.sensitivity = simulation::sensitivity;
  std::unique_ptr<Progress> progress;
  if (!settings.quiet) progress = std::make_unique<Progress>("sizing the bed");
  std::mutex guard;
  if (progress)
    problem.progress = [&](long runs) {
      const std::lock_guard lock(guard);
      progress->show(1.0 - 1.0 / (1.0 + 2e-4 * static_cast<double>(runs)), std::to_string(runs) + " overruns");
    };

  const auto folder = words.out.empty() ? fs::path("out") / ("design_" + fleet_file.stem().string()) : words.out;
  settings.results = {folder / "bed.json", folder / "design.json", folder / "design.html"};
  study::Store store(folder / "design.store",
                     study::fingerprint(loaded.identity + APC_VERSION + words.rtol + "windows and edges"));
  const auto start = std::chrono::steady_clock::now();
  report::DesignRecord record;
  record.design = design::size_bed(problem, store, size);
  if (!margins.empty() && record.design.feasible)
    record.front = design::pareto_front(problem, store, record.design, margins, size.optimiser);
  progress.reset();
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.fleet = fleet, record.fleet_text = read_text(fleet_file), record.threads = words.threads;
  record.manifest = {std::string("apc ") + APC_VERSION, settings.command_line, utc_now(), std::move(loaded.files)};
  record.design.built.bed.name = fleet.name + ", " + words.objective;
  record.design.built.bed.source = record.manifest.version + ": " + settings.command_line;

  const auto json = report::design_json(record), page = report::design_page(record);
  std::error_code ignored;
  fs::remove(folder / "bed.json", ignored);  // of a former design: this one may have none
  if (record.design.feasible) write_text(folder / "bed.json", report::bed_json(record.design.built.bed));
  write_text(folder / "design.json", json);
  write_text(folder / "design.html", page);
  if (!settings.json.empty()) write_text(settings.json, json);
  if (!record.design.feasible) settings.exit_code = exit_code::not_met;
  if (settings.quiet) return;
  std::fputs(report::design_brief(record, settings.units).c_str(), stdout);
  std::printf("  page           %s\n  also           design.json%s beside it\n", (folder / "design.html").c_str(),
              record.design.feasible ? ", bed.json" : "");
}

}  // namespace

void add_design(CLI::App& program, Settings& settings) {
  auto* command =
      program.add_subcommand("design", "sizes a bed's depth profile for a fleet, with a certificate of the optimum");
  const auto words = std::make_shared<Words>();
  command->add_option("--fleet", words->fleet, "aircraft, cases, limits and space of beds: a shipped name or a file")
      ->required()
      ->type_name("NAME|FILE");
  command
      ->add_option(
          "--objective", words->objective,
          "length: shortest (default); volume: least material; minimax: fairest to all; speed: highest in a length")
      ->type_name("WORD");
  command->add_option("--criterion", words->criterion, "limit or ultimate, instead of the fleet file's")
      ->type_name("WORD");
  command
      ->add_option("--length", words->length, "of the bed, with --objective speed (default: the file's maximum_length)")
      ->type_name("LENGTH");
  command
      ->add_option("--pareto", words->pareto,
                   "also the front of length, volume and margin for these margins: 0,0.1,0.25")
      ->type_name("LIST");
  command->add_option("--loads", words->choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command->add_option("--tires", words->choice.tires, "tire library")->type_name("FILE");
  command->add_option("--model", words->effects, "effects added to the model: what apc add wrote (apc-model/1)")
      ->type_name("FILE");
  command->add_option("--rtol", words->rtol, "relative tolerance of the integration (default 1e-7)")
      ->type_name("NUMBER");
  command->add_option("--threads", words->threads, "default: all")->type_name("N");
  command
      ->add_option("-o,--out", words->out,
                   "folder of the files and of the finished overruns (default out/design_FLEET)")
      ->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Exit code 1 when no bed keeps the limits; the report then names what forbids it. Interrupted, the same command\n"
      "continues where it was. Example: apc design --fleet three_aircraft --criterion ultimate");
  command->callback([words, &settings] { run_design(*words, settings); });
}

}  // namespace apc::cli
