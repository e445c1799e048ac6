/// `apc reliability`: the probability that a designed bed arrests, and arrests without damage, over everything that
/// scatters.
#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <mutex>

#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/fleet_inputs.h"
#include "apc/design/design_file.h"
#include "apc/report/study_reliability.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  std::string design, scatter;
  Choice choice;
  fs::path out;
  long samples = 1000, seed = 1;
  unsigned threads = 0;
};

double share(const Json& json, const std::string& key, double otherwise, double most) {
  const double value = json.number(key, otherwise);
  json.check(value >= 0 && value <= most, key, concat("is outside 0 to ", most));
  return value;
}

/// Schema "apc-scatter/1": any of the numbers of study::Scatter, with a source.
study::Scatter read_scatter(const fs::path& path) {
  const auto json = read_json(path);
  json.schema("apc-scatter/1");
  study::Scatter out;
  out.source = json.text("source");
  out.mass = share(json, "mass", out.mass, 0.3), out.cg = share(json, "cg", out.cg, 0.1);
  out.strength = share(json, "strength", out.strength, 0.3), out.depth = share(json, "depth", out.depth, 0.3);
  out.block_strength = share(json, "block_strength", out.block_strength, 0.5);
  out.correlation = json.quantity("correlation", dimension::length, out.correlation);
  json.check(out.correlation > 0, "correlation", "is not above 0");
  if (json.has("braking")) {
    const auto range = json.numbers("braking");
    json.check(range.size() == 2 && range[0] >= 0 && range[1] >= range[0] && range[1] <= 1, "braking",
               "is no range of friction coefficients: write two numbers, such as [0, 0.25]");
    out.braking_low = range[0], out.braking_high = range[1];
  }
  out.temperature = json.quantity("temperature", dimension::temperature, out.temperature);
  out.temperature_scatter = json.quantity("temperature_scatter", dimension::temperature, out.temperature_scatter);
  out.per_kelvin = share(json, "per_kelvin", out.per_kelvin, 0.02),
  out.per_year = share(json, "per_year", out.per_year, 0.05);
  if (json.has("years")) {
    const auto range = json.numbers("years");
    json.check(range.size() == 2 && range[0] >= 0 && range[1] >= range[0], "years",
               "is no range: write two numbers, such as [0, 20]");
    out.years_low = range[0], out.years_high = range[1];
  }
  json.finish();
  return out;
}

void run_reliability(const Words& words, Settings& settings) {
  require(words.samples >= 100 && words.samples <= 1000000, "--samples: ", words.samples, " is outside 100 to 1000000");
  const fs::path file = words.design;
  const auto design = design::load_design(file);
  report::ReliabilityRecord record;
  if (!words.scatter.empty()) record.scatter = read_scatter(words.scatter);
  auto loaded =
      load_fleet_models(design.fleet, note("design", file, design.program + ": " + design.command), words.choice);
  if (!words.scatter.empty()) loaded.files.push_back(note("scatter", words.scatter, record.scatter.source));
  std::string identity = APC_VERSION;
  for (const auto& each : loaded.files) identity += each.sha256;
  const auto folder = words.out.empty() ? fs::path("out") / "reliability" : words.out;

  study::ReliabilityOptions options;
  const auto cases = design.fleet.cases.size();
  options.samples = std::max<std::size_t>(100, (static_cast<std::size_t>(words.samples) + cases - 1) / cases);
  options.seed = static_cast<std::uint64_t>(words.seed), options.threads = words.threads;
  std::unique_ptr<Progress> progress;
  if (!settings.quiet) progress = std::make_unique<Progress>("samples", static_cast<double>(options.samples * cases));
  std::mutex guard;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < cases; ++k) {
    const auto& each = design.fleet.cases[k];
    study::ReliabilityInput input{
        loaded.models[k], each.overrun,      each.overrun.entry_speed * design.speed_factor, {},
        record.scatter,   record.exit_speeds};
    input.model.bed = design.bed;
    auto limits = design.fleet.limits;
    limits.loads.clear();        // damage asks for every known gear limit, whatever the design counted
    limits.table_range = false;  // leaving the tables' range is a warning about the model, no damage
    input.use = [&input, limits](const simulation::Result& result) {
      return design::worst_use(result, input.model, limits);
    };
    if (progress)
      options.finished = [&](std::size_t finished) {
        const std::lock_guard lock(guard);
        progress->show(static_cast<double>(k * options.samples + finished), each.aircraft + ", " + each.name);
      };
    study::Store store(folder / ("case_" + std::to_string(k + 1) + ".store"), study::fingerprint(identity));
    record.results.push_back(study::reliability(input, simulation::simulate, store, options));
    record.cases.push_back(each.aircraft + ", " + each.name);
    record.asked_speeds.push_back(input.asked_speed);
  }
  progress.reset();
  record.design = design.bed.name, record.criterion = study::text(design.fleet.limits.criterion);
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.manifest = {std::string("apc ") + APC_VERSION, settings.command_line, "", std::move(loaded.files)};
  const auto json = report::reliability_json(record), page = report::reliability_page(record);
  write_text(folder / "reliability.json", json);
  write_text(folder / "reliability.html", page);
  if (!settings.json.empty()) write_text(settings.json, json);
  if (settings.quiet) return;
  std::fputs(report::reliability_brief(record, settings.units).c_str(), stdout);
  std::printf("  page      %s\n", (folder / "reliability.html").c_str());
}

}  // namespace

void add_reliability(CLI::App& program, Settings& settings) {
  auto* command =
      program.add_subcommand("reliability", "probability of arrest, and of arrest without damage, over all scatter");
  const auto words = std::make_shared<Words>();
  command->add_option("--design", words->design, "design.json of apc design")->required()->type_name("FILE");
  command->add_option("--samples", words->samples, "over all cases together (default 1000)")->type_name("N");
  command->add_option("--seed", words->seed, "of the samples (default 1)")->type_name("N");
  command->add_option("--scatter", words->scatter, "apc-scatter/1 file (default: estimates, listed in the record)")
      ->type_name("FILE");
  command->add_option("--loads", words->choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command->add_option("--tires", words->choice.tires, "tire library")->type_name("FILE");
  command->add_option("--threads", words->threads, "default: all")->type_name("N");
  command
      ->add_option("-o,--out", words->out, "folder of the files and of the finished samples (default out/reliability)")
      ->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Interrupted, the same command continues where it was.\nExample: apc reliability --design "
      "out/design_acrp29_fleet/"
      "design.json --samples 10000");
  command->callback([words, &settings] { run_reliability(*words, settings); });
}

}  // namespace apc::cli
