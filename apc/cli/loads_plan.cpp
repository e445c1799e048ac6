/// `apc loads plan` and `apc loads status`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/inputs.h"
#include "apc/cli/loads_commands.h"
#include "apc/simulation/table_tire.h"
#include "loadtables/infill.h"

namespace apc::cli {
namespace fs = std::filesystem;

aircraft::Tire find_tire(const std::string& name, const fs::path& library) {
  const auto tires = aircraft::load_tires(library.empty() ? shipped("aircraft/data/tires.json") : library);
  if (const auto found = tires.find(name); found != tires.end()) return found->second;
  std::vector<std::string> names;
  std::string list;
  for (const auto& [each, tire] : tires) {
    names.push_back(each);
    list += (list.empty() ? "" : ", ") + each;
  }
  const auto near = nearest(name, names.data(), names.size());
  throw InputError(concat("--tire: no such tire: \"", name, "\".",
                          near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"), " There are: ", list,
                          ". Another library: --tires FILE"));
}

std::string today() { return utc_now().substr(0, 10); }

namespace {

struct PlanWords {
  std::string tire, material;
  fs::path tires, out;
  int runs = 60, seed = 1, add = 0;
  std::vector<std::string> speeds, depths;
  std::vector<double> penetrations;
};

void plan(const PlanWords& words, const Settings& settings) {
  require(!words.tire.empty() && !words.material.empty(),
          "a new plan needs --tire and --material, such as --tire H44.5x16.5-21 --material foam_50psi");
  loadtables::PlanOptions options;
  options.runs = words.runs;
  require(words.seed >= 0, "--seed: ", words.seed, " is negative");
  options.seed = static_cast<unsigned>(words.seed);
  for (std::size_t i = 0; i < words.speeds.size(); ++i)
    options.speed[i] = option_quantity("--speeds", words.speeds[i], dimension::speed);
  for (std::size_t i = 0; i < words.depths.size(); ++i)
    options.bed_depth[i] = option_quantity("--depths", words.depths[i], dimension::length);
  for (std::size_t i = 0; i < words.penetrations.size(); ++i) options.relative_penetration[i] = words.penetrations[i];
  std::error_code error;
  require(!fs::exists(words.out / "plan.json", error), words.out.string(),
          ": already holds a plan. Go on with it (apc loads run), or choose another folder with -o");
  const auto made = make_plan(simulation::table_tire(find_tire(words.tire, words.tires)), words.material, options);
  write_plan(made, words.out);
  if (settings.quiet) return;
  fmt::print(
      "{} runs for {} in {}: {:.0f} to {:.0f} kt, bed {:.0f} to {:.0f} in, {:.0f} to {:.0f} % of the largest "
      "penetration\nNext: apc loads run {}\n",
      made.runs.size(), made.tire.name, made.material, options.speed[0] / units::kt, options.speed[1] / units::kt,
      options.bed_depth[0] / units::in, options.bed_depth[1] / units::in, 100.0 * options.relative_penetration[0],
      100.0 * options.relative_penetration[1], words.out.string());
}

/// Appends runs to a campaign that has some, where they teach most.
void extend(const PlanWords& words, const Settings& settings) {
  auto made = loadtables::read_plan(words.out);
  const auto further = loadtables::further_runs(made, loadtables::campaign_status(words.out), words.add);
  made.runs.insert(made.runs.end(), further.begin(), further.end());
  write_plan(made, words.out);
  if (settings.quiet) return;
  for (const auto& run : further)
    fmt::print("run {}: {:.0f} kt, bed {:.0f} in, {:.0f} % of the largest penetration\n", run.id,
               run.contact.speed / units::kt, run.contact.bed_depth / units::in, 100.0 * run.relative_penetration);
  fmt::print("Next: apc loads run {}\n", words.out.string());
}

}  // namespace

void add_loads_plan(CLI::App& loads, Settings& settings) {
  auto* command = loads.add_subcommand("plan", "lays out the runs of a campaign in a new folder");
  const auto words = std::make_shared<PlanWords>();
  command->add_option("--tire", words->tire, "tire by name");
  command->add_option("--material", words->material, "bed material by name, such as foam_50psi");
  command->add_option("--runs", words->runs, "number of runs, corners of the box included")->capture_default_str();
  command->add_option("--seed", words->seed, "of the sample plan")->capture_default_str();
  command->add_option("--tires", words->tires, "tire library (JSON); default: the shipped one");
  command->add_option("--speeds", words->speeds, R"(lowest and highest, default "10 kt" "70 kt")")->expected(2);
  command->add_option("--depths", words->depths, R"(thinnest and deepest bed, default "3 in" "36 in")")->expected(2);
  command->add_option("--penetrations", words->penetrations, "relative to the largest one, default 0.1 1.0")
      ->expected(2);
  command->add_option("--add", words->add, "adds this many runs to a campaign, where its errors are largest");
  command->add_option("-o,--out", words->out, "folder of the campaign")->required();
  add_common_options(*command, settings);
  command->callback([words, &settings] { words->add > 0 ? extend(*words, settings) : plan(*words, settings); });
}

void add_loads_status(CLI::App& loads, Settings& settings) {
  auto* command = loads.add_subcommand("status", "what the runs of a campaign have come to");
  const auto folder = std::make_shared<fs::path>();
  command->add_option("DIR", *folder, "folder of the campaign")->required();
  add_common_options(*command, settings);
  command->callback([folder, &settings] {
    const auto status = loadtables::campaign_status(*folder);
    if (!settings.quiet) fmt::print("{}", status_report(status, *folder));
    if (!settings.json.empty()) write_text(settings.json, status_record(status));
  });
}

}  // namespace apc::cli
