/// `apc loads fit`, `show`, `import`, `export`, `check`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/loads_commands.h"
#include "apc/simulation/table_tire.h"
#include "loadtables/fit.h"
#include "loadtables/load_table_data.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  fs::path input, out, tires;
  std::string name, speed = "50 kt", points = "samples";
  std::vector<fs::path> files;
};

void report(const loadtables::LoadTable& table, const Settings& settings) {
  const auto check = loadtables::check_table(table);
  if (!settings.quiet) fmt::print("{}", table_report(table, check));
  if (!settings.json.empty()) write_text(settings.json, table_record(table, check));
}

void fit_campaign(const Words& words, const Settings& settings) {
  const auto samples = loadtables::campaign_samples(words.input);
  const auto plan = loadtables::read_plan(words.input);
  const auto made = loadtables::campaign_settings(words.input);
  loadtables::Provenance from;
  from.material = samples.set.material;
  from.source = samples.set.source;
  const auto added = plan.runs.size() - static_cast<std::size_t>(plan.options.runs);
  from.command = fmt::format(
      "apc loads plan --tire {0} --material {1} --runs {2} --seed {3} -o DIR && apc loads run DIR --spacing \"{4:g} "
      "mm\" "
      "--friction {5:g}{6} && apc loads fit DIR -o {0}_{1}.h5",
      plan.tire.name, plan.material, plan.options.runs, plan.options.seed, 1e3 * made->spacing, made->friction,
      added > 0 ? fmt::format(" && apc loads plan --add {} -o DIR && apc loads run DIR", added) : std::string());
  from.date = today();
  from.version = concat("apc ", APC_VERSION);
  from.friction = made->friction;
  from.spacing = made->spacing;
  from.runs = samples.runs;
  from.refused = samples.refused;
  const auto table = loadtables::fit(samples.set, plan.tire, from);
  save_table(table, words.out);
  report(table, settings);
}

void import_samples(const Words& words, const Settings& settings) {
  const auto samples = loadtables::read_loads_csv(words.input);
  const auto beside = words.input.parent_path() / "tires.json";
  std::error_code error;
  const auto library = !words.tires.empty() || !fs::is_regular_file(beside, error) ? words.tires : beside;
  const auto tire = simulation::table_tire(find_tire(words.name.empty() ? samples.tire : words.name, library));
  loadtables::Provenance from;
  from.material = samples.material;
  from.source = samples.source;
  from.command = fmt::format("apc loads import {} -o {}", words.input.filename().string(), words.out.string());
  from.date = today();
  from.version = concat("apc ", APC_VERSION);
  from.runs = static_cast<int>(samples.samples.size());
  const auto table = loadtables::fit(samples, tire, from);
  save_table(table, words.out);
  report(table, settings);
}

/// The table itself as samples on a grid, for programs that interpolate on their own.
loadtables::SampleSet grid_samples(const loadtables::LoadTable& table) {
  loadtables::SampleSet set = table.data().samples;
  set.samples.clear();
  set.source = concat("load table fitted to: ", set.source);
  set.has_rut = set.has_spin = true;
  for (const auto& quality : table.quality()) {
    if (quality.response == "drag") set.drag_rms = quality.loo_rms_relative;
    if (quality.response == "vertical") set.vertical_rms = quality.loo_rms_relative;
  }
  constexpr int speeds = 7, depths = 24, ratios = 20;
  const auto v = table.speed_range(), h = table.depth_range();
  for (int i = 0; i < speeds; ++i)
    for (int j = 1; j <= depths; ++j)
      for (int k = 1; k <= ratios; ++k) {
        const double depth = h[1] * j / depths;
        const TireContact at{v[0] + (v[1] - v[0]) * i / (speeds - 1), depth,
                             table.maximum_penetration(depth) * k / ratios};
        set.samples.push_back({at, table.load(at)});
      }
  return set;
}

/// A file, or the name of a shipped table with or without its material.
fs::path table_path(const std::string& name) {
  std::error_code error;
  if (!fs::is_regular_file(name, error))
    for (const auto& each : shipped_names("loadtables/data", ".h5"))
      if (each.rfind(name + "_", 0) == 0) return shipped("loadtables/data") / (each + ".h5");
  return resolve(name, "loadtables/data", "load table", ".h5");
}

CLI::App* subcommand(CLI::App& loads, Settings& settings, const std::string& name, const std::string& what) {
  auto* command = loads.add_subcommand(name, what);
  add_common_options(*command, settings);
  return command;
}

}  // namespace

void add_loads_fit(CLI::App& loads, Settings& settings) {
  auto* command = subcommand(loads, settings, "fit", "fits the finished runs of a campaign and writes their table");
  const auto words = std::make_shared<Words>();
  command->add_option("DIR", words->input, "folder of the campaign")->required();
  command->add_option("-o,--out", words->out, "table to write (.h5)")->required();
  command->callback([words, &settings] { fit_campaign(*words, settings); });
}

void add_loads_show(CLI::App& loads, Settings& settings) {
  auto* command = subcommand(loads, settings, "show", "what a table holds: origin, errors, loads at one speed");
  const auto words = std::make_shared<Words>();
  command->add_option("TABLE", words->name, "file, or a shipped table by its tire")->required();
  command->add_option("--speed", words->speed, "of the listed loads")->capture_default_str();
  command->callback([words, &settings] {
    const double speed = option_quantity("--speed", words->speed, dimension::speed);
    require(speed >= 0.0, "--speed: \"", words->speed, "\" is negative");
    const auto table = loadtables::load_table(table_path(words->name));
    report(table, settings);
    if (!settings.quiet) fmt::print("\n{}", table_slices(table, speed, settings.units));
  });
}

void add_loads_import(CLI::App& loads, Settings& settings) {
  auto* command = subcommand(loads, settings, "import", "fits load samples made elsewhere (CSV, apc-loads/1)");
  const auto words = std::make_shared<Words>();
  command->add_option("FILE", words->input, "samples (.csv)")->required();
  command->add_option("-o,--out", words->out, "table to write (.h5)")->required();
  command->add_option("--tire", words->name, "tire by name; default: the one the file names");
  command->add_option("--tires", words->tires,
                      "tire library (JSON); default: tires.json beside FILE, or the shipped one");
  command->callback([words, &settings] { import_samples(*words, settings); });
}

void add_loads_export(CLI::App& loads, Settings& settings) {
  auto* command = subcommand(loads, settings, "export", "writes a table's samples, or itself on a grid, as CSV");
  const auto words = std::make_shared<Words>();
  command->add_option("TABLE", words->name, "file, or a shipped table by its tire")->required();
  command->add_option("-o,--out", words->out, "CSV to write (apc-loads/1)")->required();
  command->add_option("--points", words->points, "samples (what was fitted) or grid (the table itself)")
      ->capture_default_str();
  command->callback([words, &settings] {
    require(words->points == "samples" || words->points == "grid", "--points: \"", words->points,
            "\" is unknown. Write samples or grid");
    const auto table = loadtables::load_table(table_path(words->name));
    const auto set = words->points == "grid" ? grid_samples(table) : table.data().samples;
    write_loads_csv(set, words->out);
    if (!settings.quiet) fmt::print("{} samples written to {}\n", set.samples.size(), words->out.string());
  });
}

void add_loads_check(CLI::App& loads, Settings& settings) {
  auto* command =
      subcommand(loads, settings, "check", "checks tables: errors as stated, loads never negative or falling");
  const auto words = std::make_shared<Words>();
  command->add_option("TABLE", words->files, "files, or shipped tables by their tires")->required();
  command->footer("Exit code 1 when a table does not hold what it must.");
  command->callback([words, &settings] {
    for (const auto& file : words->files) {
      const auto table = loadtables::load_table(table_path(file.string()));
      const auto check = loadtables::check_table(table);
      if (!settings.quiet)
        fmt::print("{}  {} in {}: {} points, vertical load falls by at most {:.1f} %\n",
                   check.failures.empty() ? "good" : "bad ", table.tire().name, table.provenance().material,
                   check.points, 100.0 * check.largest_fall);
      for (const auto& failure : check.failures) fmt::print(stderr, "bad   {}: {}\n", file.string(), failure);
      if (!check.failures.empty()) settings.exit_code = exit_code::not_met;
      if (!settings.json.empty()) write_text(settings.json, table_record(table, check));
    }
  });
}

}  // namespace apc::cli
