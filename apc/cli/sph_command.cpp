/// `apc sph run`: one tire through foam, from a deck to loads, report and page.
#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/inputs.h"
#include "apc/cli/sph_deck.h"
#include "apc/cli/sph_studies.h"
#include "apc/report/rolling_record.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct RunWords {
  fs::path deck, out, snapshots, checkpoint;
  std::string checkpoint_every = "60 s";
  unsigned threads = 0;
};

report::RollingRecord as_record(const SphDeck& deck, const sph::RollingResult& result) {
  report::RollingRecord record;
  record.name = deck.name;
  record.source = deck.source;
  record.tire = deck.rig.tire.name;
  record.material = deck.material;
  record.speed = deck.rig.speed;
  record.bed_depth = deck.rig.bed_depth;
  record.penetration = deck.rig.penetration;
  record.maximum_penetration = sph::maximum_penetration(deck.rig.tire, deck.rig.bed_depth);
  record.tire_diameter = deck.rig.tire.diameter;
  record.tire_width = deck.rig.tire.width;
  record.spacing = deck.rig.spacing;
  record.friction = deck.rig.friction;
  record.fall = deck.rig.fall;
  record.state = sph::name_of(result.state);
  record.message = result.message;
  record.steady = result.state == sph::RunState::steady;
  record.drag = result.drag;
  record.vertical = result.vertical;
  record.rut_depth = result.rut_depth;
  record.surface_left = result.rut_left;
  record.spin_ratio = result.spin_ratio;
  record.tire_deflection = result.tire_deflection;
  record.drag_change = result.drag_change;
  record.vertical_change = result.vertical_change;
  record.spin_change = result.spin_change;
  record.internal_energy_rate = result.internal_energy_rate;
  record.residual = result.residual;
  for (const auto& [name, joule] : sph::energy_in(result.energy)) record.energy_in.emplace_back(name, joule);
  for (const auto& [name, joule] : sph::energy_out(result.energy)) record.energy_out.emplace_back(name, joule);
  record.compaction = result.compaction;
  record.partition_min = result.partition_min;
  record.partition_mean = result.partition_mean;
  record.particles = result.particles;
  record.steps = result.steps;
  record.particle_steps = result.particle_steps;
  record.particle_steps_per_s = result.particle_steps_per_s;
  record.wall_s = result.wall_s;
  record.bytes_per_particle = result.bytes_per_particle;
  record.time = result.history.time;
  record.distance = result.history.distance;
  record.drag_history = result.history.drag;
  record.vertical_history = result.history.vertical;
  record.spin_history = result.history.spin_ratio;
  record.deflection_history = result.history.deflection;
  record.section_y = result.section_y;
  record.section_z = result.section_z;
  for (double& z : record.section_z) z -= deck.rig.bed_depth;  // the rig counts from the rigid plane upwards
  record.section_compaction = result.section_compaction;
  const double axle_height = deck.rig.bed_depth - deck.rig.penetration + 0.5 * deck.rig.tire.diameter;
  const sph::FurrowWheel wheel{sph::section(deck.rig.tire), axle_height};
  for (int k = 0; k <= 60; ++k) {
    record.wheel_z.push_back(-deck.rig.penetration * (1.0 - k * k / 3600.0));
    record.wheel_y.push_back(wheel.flank(deck.rig.bed_depth + record.wheel_z.back()));
  }
  for (const auto& line : sph::lines_of(result.shape)) record.shape.push_back({line.key, line.name, line.value});
  return record;
}

void run_deck(const RunWords& words, Settings& settings) {
  const auto deck = read_deck(words.deck);
  require(words.threads <= 1024, "--threads: ", words.threads, ". Between 1 and 1024 are possible, 0 takes all");
  sph::RollOptions options;
  options.threads = words.threads == 0 ? hardware_threads() : words.threads;
  options.stop = stop_requested;
  options.snapshots = words.snapshots;
  options.checkpoint = words.checkpoint;
  options.checkpoint_every_s = option_quantity("--checkpoint-every", words.checkpoint_every, dimension::time);
  require(options.checkpoint_every_s >= 0.0, "--checkpoint-every: \"", words.checkpoint_every, "\" is in the past");
  const auto folder = words.out.empty() ? fs::path("out") / ("sph_" + words.deck.stem().string()) : words.out;
  settings.results = {folder / "history.csv", folder / "result.json", folder / "report.html"};
  sph::RollingResult result;
  {
    std::unique_ptr<Progress> line;
    if (!settings.quiet) line = std::make_unique<Progress>("SPH run of " + deck.rig.tire.name);
    if (line) options.progress = [&](double share, const std::string& remark) { line->show(share, remark); };
    result = sph::roll(deck.rig, options);
  }
  auto record = as_record(deck, result);
  record.manifest = {concat("apc ", APC_VERSION), settings.command_line, utc_now(), deck.files};

  const auto json = report::rolling_json(record), csv = report::rolling_csv(record),
             page = report::rolling_page(record);
  if (stop_requested()) throw Interrupted();
  write_text(folder / "history.csv", csv);
  write_text(folder / "result.json", json);
  write_text(folder / "report.html", page);
  settings.results.clear();  // made, and said below where the loads are none
  if (!settings.json.empty()) write_text(settings.json, json);
  if (!settings.quiet) {
    std::fputs(report::rolling_brief(record, settings.units).c_str(), stdout);
    std::printf("\n  page            %s\n  also            result.json, history.csv beside it\n",
                (folder / "report.html").c_str());
  }
  if (!record.steady)
    throw SolveError(concat(words.deck.string(), ": ", record.state, ": ", record.message,
                            record.message.ends_with('.') ? " " : ". ",
                            "Its loads are not to be used; the report shows what it had"));
}

void add_run(CLI::App& sph, Settings& settings) {
  auto* command = sph.add_subcommand("run", "rolls a tire through foam as a deck (apc describe sph) says");
  const auto words = std::make_shared<RunWords>();
  command->add_option("FILE", words->deck, "deck, JSON of schema apc-sph/1")->required()->type_name("");
  command->add_option("--threads", words->threads, "0 = all; the result does not depend on it")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--snapshots", words->snapshots, "folder for particle snapshots (VTU)")->type_name("DIR");
  command
      ->add_option("--checkpoint", words->checkpoint,
                   "file of the run's state; after an interruption the same command goes on from it, to the same bits")
      ->type_name("FILE");
  command->add_option("--checkpoint-every", words->checkpoint_every, "how often it is renewed")
      ->type_name("TIME")
      ->capture_default_str();
  command->add_option("-o,--out", words->out, "folder of the files (default out/sph_FILE)")->type_name("DIR");
  add_common_options(*command, settings);
  command->footer("Exit code 3 when the loads did not become steady: the report then names the state and why.");
  command->callback([words, &settings] { run_deck(*words, settings); });
}

}  // namespace

void add_sph(CLI::App& program, Settings& settings) {
  auto* sph = program.add_subcommand("sph", "the particle back end: runs, published cases, convergence, throughput");
  sph->require_subcommand(1);
  add_run(*sph, settings);
  add_sph_studies(*sph, settings);
}

}  // namespace apc::cli
