/// `apc loads run`: makes the runs of a plan with the SPH rig, here or as a job array.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/loads_commands.h"
#include "sph_backend/material_json.h"
#include "sph_backend/tire_rig.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct RunWords {
  fs::path folder, tires;
  int jobs = 1, runs = 0;
  std::string spacing, engine = "local";
  double friction = 0.3;
  bool friction_given = false;
};

sph::TireShape tire_shape(const aircraft::Tire& tire) {
  return {tire.name,       tire.diameter,         tire.width,          tire.rim_diameter,        tire.inflation,
          tire.rated_load, tire.rated_deflection, tire.bottoming_load, tire.bottoming_deflection};
}

loadtables::RunOutcome as_outcome(const sph::RollingResult& result) {
  loadtables::RunOutcome outcome;
  outcome.state = sph::name_of(result.state);
  outcome.message = result.state == sph::RunState::steady ? std::string() : result.message;
  outcome.load = {result.drag, result.vertical, result.rut_depth, result.spin_ratio};
  outcome.wall_s = result.wall_s;
  outcome.facts = {{"tire_deflection_m", result.tire_deflection},
                   {"drag_change", result.drag_change},
                   {"vertical_change", result.vertical_change},
                   {"spin_change", result.spin_change},
                   {"internal_energy_rate_J_per_m", result.internal_energy_rate},
                   {"energy_residual", result.residual},
                   {"particles", result.particles},
                   {"steps", result.steps}};
  return outcome;
}

void write_job_array(const RunWords& words, std::size_t runs, double spacing) {
  const auto script = words.folder / "campaign.sbatch";
  write_text(script, fmt::format("#!/bin/sh\n"
                                 "#SBATCH --job-name=apc-loads --ntasks=1 --cpus-per-task=1 --array=1-{}\n"
                                 "# Every task takes the next run that no other has; results appear in {}/results.\n"
                                 "apc loads run {} --jobs 1 --runs 1 --spacing \"{:.9g} m\" --friction {:g}\n",
                                 runs, words.folder.string(), words.folder.string(), spacing, words.friction));
  fmt::print("{} runs are left. Submit them with: sbatch {}\n", runs, script.string());
}

void run(RunWords words, const Settings& settings) {
  require(words.jobs >= 1 && words.jobs <= 1024, "--jobs: ", words.jobs, ". Between 1 and 1024 are possible");
  require(words.friction >= 0.0 && words.friction <= 2.0, "--friction: ", words.friction,
          " is no friction coefficient. Write a number such as 0.3");
  require(words.engine == "local" || words.engine == "slurm", "--engine: \"", words.engine,
          "\" is unknown. Write local or slurm");
  const auto plan = loadtables::read_plan(words.folder);
  const auto started = loadtables::campaign_settings(words.folder);
  if (started && !words.friction_given) words.friction = started->friction;
  sph::RollingCase rig;
  rig.tire = tire_shape(find_tire(plan.tire.name, words.tires));
  rig.foam = sph::load_foam(resolve(plan.material, "designs/materials", "material")).foam;
  rig.friction = words.friction;
  const double deep = plan.options.bed_depth[1];
  double spacing = started ? started->spacing : sph::recommended_spacing(rig.tire, deep);
  if (!words.spacing.empty()) spacing = option_quantity("--spacing", words.spacing, dimension::length);
  require(spacing > 0.0 && spacing <= 0.5 * plan.tire.width, "--spacing: ", spacing, " m does not resolve a tire of ",
          plan.tire.width, " m width. An eighth of the width is usual");

  std::size_t left = 0;
  for (const auto& status : loadtables::campaign_status(words.folder)) left += !status.outcome;
  if (words.engine == "slurm") {
    write_job_array(words, left, spacing);
    return;
  }
  const auto make = [&](const loadtables::PlannedRun& planned) {
    auto one = rig;
    one.speed = planned.contact.speed;
    one.bed_depth = planned.contact.bed_depth;
    one.penetration = planned.contact.penetration;
    one.spacing = std::min(spacing, one.bed_depth / 5.0);  // thin beds need particles enough to be crushed
    sph::RollOptions options;
    options.stop = stop_requested;
    auto outcome = as_outcome(sph::roll(one, options));
    outcome.facts["spacing_m"] = one.spacing;
    return outcome;
  };
  std::unique_ptr<Progress> line;
  if (!settings.quiet) line = std::make_unique<Progress>(fmt::format("SPH runs of {}", plan.tire.name));
  loadtables::CampaignOptions options;
  options.jobs = static_cast<unsigned>(words.jobs);
  options.first = words.runs;
  options.stop = stop_requested;
  if (line) options.progress = [&](double share, const std::string& remark) { line->show(share, remark); };
  const int made =
      run_campaign(words.folder, {words.friction, spacing, concat("apc ", APC_VERSION, " sph"), settings.command_line},
                   make, options);
  line.reset();
  const auto status = loadtables::campaign_status(words.folder);
  if (!settings.quiet) fmt::print("{} runs made now.\n{}", made, status_report(status, words.folder));
  if (!settings.json.empty()) write_text(settings.json, status_record(status));
}

}  // namespace

void add_loads_run(CLI::App& loads, Settings& settings) {
  auto* command = loads.add_subcommand("run", "makes the runs of a campaign that have no result yet");
  const auto words = std::make_shared<RunWords>();
  command->add_option("DIR", words->folder, "folder of the campaign")->required();
  command->add_option("--jobs", words->jobs, "runs at a time")->capture_default_str();
  command->add_option("--runs", words->runs, "make at most this many now; 0 = all")->capture_default_str();
  command->add_option("--spacing", words->spacing,
                      "largest, of the particles; thin beds get less by themselves. Default: for the tire");
  auto* friction = command->add_option("--friction", words->friction, "of tire on foam")->capture_default_str();
  command->add_option("--engine", words->engine, "local, or slurm: writes a job array")->capture_default_str();
  command->add_option("--tires", words->tires, "tire library (JSON); default: the shipped one");
  add_common_options(*command, settings);
  command->footer(
      "Finished runs are kept whatever happens; the same command goes on with the rest. Several processes may\n"
      "work on one folder.");
  command->callback([words, friction, &settings] {
    words->friction_given = friction->count() > 0;
    run(*words, settings);
  });
}

}  // namespace apc::cli
