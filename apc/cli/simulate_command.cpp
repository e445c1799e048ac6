/// `apc simulate`: one overrun from names to report, histories and page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/cli/inputs.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/overlay_json.h"
#include "apc/report/brief.h"
#include "apc/report/history_table.h"
#include "apc/report/page.h"
#include "apc/report/result_json.h"
#include "apc/report/sha256.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

/// The command's options as typed; empty = not given.
struct Words {
  Choice choice;
  std::string speed, mass, cg, braking, braking_in_bed, thrust, headwind, sinking, method = "reference", rtol;
  fs::path out, effects;
};

double dimensionless(const std::string& option, const std::string& text, double low, double high) {
  const double value = option_quantity(option, text, dimension::none);
  require(value >= low && value <= high, option, ": ", text, " is outside ", low, " to ", high);
  return value;
}

double read_speed(const std::string& text) {
  const double speed = option_quantity("--speed", text, dimension::speed);
  require(speed > 0, "--speed: \"", text, "\" is not above zero. Write the speed at the bed's edge, such as \"70 kt\"");
  require(speed <= 200 * units::kt, "--speed: \"", text,
          "\" is beyond any overrun (at most 200 kt). Arrestor beds are entered at 30 to 80 kt");
  return speed;
}

simulation::Overrun read_overrun(const Words& words, const aircraft::Aircraft& plane) {
  simulation::Overrun overrun;
  overrun.entry_speed = read_speed(words.speed);
  if (!words.mass.empty()) {
    overrun.mass = option_quantity("--mass", words.mass, dimension::mass);
    require(overrun.mass >= 0.4 * plane.mass && overrun.mass <= 1.6 * plane.mass, "--mass: \"", words.mass,
            "\" is no mass of a ", plane.name, " (its file says ", plane.mass, " kg; 40 to 160 % of that is taken)");
  }
  if (!words.cg.empty()) {
    overrun.cg_behind_nose_gear = option_quantity("--cg", words.cg, dimension::length);
    double last = 0.0;
    for (const auto& gear : plane.gears) last = std::max(last, gear.behind_nose_gear);
    require(overrun.cg_behind_nose_gear > 0 && overrun.cg_behind_nose_gear < last, "--cg: \"", words.cg,
            "\" does not lie between the nose gear and the rearmost gear (", last, " m behind it), so the ", plane.name,
            " would tip over");
  }
  if (!words.braking.empty()) overrun.braking = dimensionless("--braking", words.braking, 0.0, 1.0);
  if (!words.braking_in_bed.empty())
    overrun.braking_in_bed = dimensionless("--braking-in-bed", words.braking_in_bed, 0.0, 1.0);
  if (!words.sinking.empty()) overrun.sinking.vertical = dimensionless("--sinking", words.sinking, 0.0, 3.0);
  if (!words.thrust.empty()) {
    overrun.thrust = option_quantity("--thrust", words.thrust, dimension::force);
    require(std::abs(overrun.thrust) <= plane.mass * units::g0, "--thrust: \"", words.thrust,
            "\" is more than the weight of a ", plane.name);
  }
  if (!words.headwind.empty()) {
    overrun.headwind = option_quantity("--headwind", words.headwind, dimension::speed);
    require(std::abs(overrun.headwind) <= 120 * units::kt, "--headwind: \"", words.headwind,
            "\" is beyond any wind (at most 120 kt)");
  }
  return overrun;
}

simulation::Options read_options(const Words& words) {
  simulation::Options options;
  require(words.method == "reference" || words.method == "fast", "--method: \"", words.method,
          "\" is no method. Write reference or fast");
  if (words.method == "fast") options.method = simulation::Method::fast;
  if (!words.rtol.empty()) options.rtol = dimensionless("--rtol", words.rtol, 1e-12, 1e-2);
  return options;
}

/// "out/B737-800_demo_70kt": names with nothing in them that a file system minds.
fs::path default_folder(const Words& words, double speed) {
  const auto plain = [](const std::string& name_or_path) {
    const auto name = fs::path(name_or_path).filename();
    return name.extension() == ".json" ? name.stem().string() : name.string();
  };
  return fs::path("out") /
         fmt::format("{}_{}_{:.4g}kt", plain(words.choice.aircraft), plain(words.choice.bed), speed / units::kt);
}

void simulate_overrun(const Words& words, Settings& settings) {
  read_speed(words.speed);  // the cheapest mistakes are told before any file is read
  const auto options = read_options(words);
  auto inputs = read_inputs(words.choice);
  auto overrun = read_overrun(words, inputs.model.aircraft);
  if (!words.effects.empty()) {
    const auto learned = learning::load_overlay(words.effects, effects::catalogue());
    overrun.alterations.effects = learned.effects, overrun.alterations.bed_strength *= learned.bed_strength;
    if (overrun.entry_speed < learned.slowest - 0.5 || overrun.entry_speed > learned.fastest + 0.5)
      std::fprintf(stderr, "warning: %s was learned on runs of %.0f to %.0f kt; at %s its effects are extrapolated\n",
                   words.effects.c_str(), learned.slowest / units::kt, learned.fastest / units::kt,
                   words.speed.c_str());
    inputs.files.push_back({"model", words.effects.string(), report::sha256(read_text(words.effects)), "learned"});
  }
  Progress progress("overrun of the " + inputs.model.aircraft.name);
  report::OverrunRecord record{std::move(inputs.model), overrun, options, {}, {}};
  record.result = simulation::simulate(record.model, overrun, options);
  record.manifest = {std::string("apc ") + APC_VERSION, settings.command_line, utc_now(), std::move(inputs.files)};

  // Everything is made before anything is written; each file then appears whole or not at all.
  const auto folder = words.out.empty() ? default_folder(words, overrun.entry_speed) : words.out;
  const auto json = report::result_json(record), csv = report::history_csv(record), page = report::page(record);
  if (stop_requested()) throw Interrupted();
  write_text(folder / "history.csv", csv);
  report::save_history(record, folder / "history.h5");
  write_text(folder / "result.json", json);
  write_text(folder / "report.html", page);
  if (!settings.json.empty()) write_text(settings.json, json);
  if (settings.quiet) return;
  const auto text = report::brief(record, settings.units);
  std::fputs(text.c_str(), stdout);
  std::printf("\n  page           %s\n  also           result.json, history.csv, history.h5 beside it\n",
              (folder / "report.html").c_str());
}

}  // namespace

void add_simulate(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand("simulate", "one overrun: report, time histories (CSV, HDF5), HTML page");
  const auto words = std::make_shared<Words>();
  command->add_option("--aircraft", words->choice.aircraft, "shipped name (apc list aircraft) or file")
      ->required()
      ->type_name("NAME|FILE");
  command->add_option("--bed", words->choice.bed, "shipped name (apc list beds) or file")
      ->required()
      ->type_name("NAME|FILE");
  command->add_option("--speed", words->speed, "speed of the nose wheel at the bed's leading edge, \"70 kt\"")
      ->required()
      ->type_name("SPEED");
  command->add_option("--loads", words->choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command
      ->add_option("--tires", words->choice.tires,
                   "tire library (default: shipped, and tires.json beside the"
                   " aircraft's file)")
      ->type_name("FILE");
  command->add_option("--mass", words->mass, "instead of the aircraft file's")->type_name("MASS");
  command->add_option("--cg", words->cg, "centre of gravity behind the nose gear")->type_name("LENGTH");
  command->add_option("--braking", words->braking, "friction coefficient of the braked wheels (default 0)")
      ->type_name("NUMBER");
  command->add_option("--braking-in-bed", words->braking_in_bed, "the same inside the bed (default: as before it)")
      ->type_name("NUMBER");
  command->add_option("--thrust", words->thrust, "net thrust, forward positive (default \"0 kN\")")->type_name("FORCE");
  command->add_option("--headwind", words->headwind, "along the runway (default \"0 kt\")")->type_name("SPEED");
  command
      ->add_option("--sinking", words->sinking,
                   "response to the rate of sinking: 0 = steady tables (default), 1 = rigid wheel")
      ->type_name("NUMBER");
  command->add_option("--model", words->effects, "effects added to the model: what apc add wrote (apc-model/1)")
      ->type_name("FILE");
  command->add_option("--method", words->method, "reference (CVODE) or fast (Rosenbrock)")->type_name("reference|fast");
  command->add_option("--rtol", words->rtol, "relative tolerance of the integration (default 1e-6)")
      ->type_name("NUMBER");
  command->add_option("-o,--out", words->out, "folder of the files (default out/AIRCRAFT_BED_SPEED)")->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Writes report.html, result.json, history.csv and history.h5.\n"
      "Example: apc simulate --aircraft B737-800 --bed BED --speed \"70 kt\" --braking 0.25");
  command->callback([words, &settings] { simulate_overrun(*words, settings); });
}

}  // namespace apc::cli
