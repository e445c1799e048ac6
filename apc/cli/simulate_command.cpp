/// `apc simulate`: one overrun from names to report, histories and page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <sstream>

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
#include "apc/simulation/sensitivity.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

/// The command's options as typed; empty = not given.
struct Words {
  Choice choice;
  std::string speed, mass, cg, pitch_inertia, braking, braking_in_bed, thrust, headwind, sinking;
  std::string brake_mode = "friction", wheel_spin = "inertial", rut_bearing, rut_rolling;
  std::string method = "reference", rtol, sensitivities;
  fs::path out, effects;
};

double dimensionless(const std::string& option, const std::string& text, double low, double high) {
  const double value = option_quantity(option, text, dimension::none);
  require(value >= low && value <= high, option, ": ", text, " is outside ", low, " to ", high);
  return value;
}

double read_speed(const std::string& text) {
  const double speed = option_quantity("--speed", text, dimension::speed);
  require(speed > simulation::creep_speed, "--speed: \"", text, "\" is not above zero (at ", simulation::creep_speed,
          " m/s an aircraft counts as at rest). Write the speed at the bed's edge, such as \"70 kt\"");
  require(speed <= 200 * units::kt, "--speed: \"", text,
          "\" is beyond any overrun (at most 200 kt). Arrestor beds are entered at 30 to 80 kt");
  return speed;
}

/// A force, or an engine setting by name.
double read_thrust(const std::string& text, const aircraft::Aircraft& plane) {
  if (text == "idle") {
    require(plane.idle_thrust != 0.0, "--thrust: the file of the ", plane.name,
            " gives no idle_thrust. Add it there, with its source, or write a force");
    return plane.idle_thrust;
  }
  require(text != "reverse-idle",
          "--thrust: \"reverse-idle\" has no sourced value: no open document gives the share of the "
          "idle thrust that the reversers turn. Write the net force, reverse negative, such as \"-4 kN\"");
  const double thrust = option_quantity("--thrust", text, dimension::force);
  require(std::abs(thrust) <= plane.mass * units::g0, "--thrust: \"", text, "\" is more than the weight of a ",
          plane.name);
  return thrust;
}

/// Position of `text` among `names`.
std::size_t choice(const std::string& option, const std::string& text, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : " or ") + name;
  require(found != names.end(), option, ": \"", text, "\" is none. Write ", list);
  return static_cast<std::size_t>(found - names.begin());
}

void read_wheels(const Words& words, simulation::Overrun& overrun) {
  using simulation::BrakeMode, simulation::WheelSpin;
  overrun.brake_mode =
      choice("--brake-mode", words.brake_mode, {"friction", "torque"}) == 0 ? BrakeMode::friction : BrakeMode::torque;
  overrun.wheel_spin =
      choice("--wheel-spin", words.wheel_spin, {"inertial", "free"}) == 0 ? WheelSpin::inertial : WheelSpin::free;
  if (!words.rut_bearing.empty())
    overrun.rut_following.bearing_gain = dimensionless("--rut-bearing-gain", words.rut_bearing, 1.0, 10.0);
  if (!words.rut_rolling.empty())
    overrun.rut_following.rolling_resistance = dimensionless("--rut-rolling-resistance", words.rut_rolling, 0.0, 0.5);
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
  if (!words.thrust.empty()) overrun.thrust = read_thrust(words.thrust, plane);
  if (!words.pitch_inertia.empty()) {
    overrun.pitch_inertia = option_quantity("--pitch-inertia", words.pitch_inertia, dimension::inertia);
    require(overrun.pitch_inertia >= 0.2 * plane.pitch_inertia && overrun.pitch_inertia <= 5.0 * plane.pitch_inertia,
            "--pitch-inertia: \"", words.pitch_inertia, "\" is no pitch inertia of a ", plane.name, " (its file says ",
            plane.pitch_inertia, " kg m^2; a fifth to five times that is taken)");
  }
  read_wheels(words, overrun);
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
  if (!words.rtol.empty()) options.rtol = dimensionless("--rtol", words.rtol, 1e-12, simulation::loosest_rtol);
  return options;
}

/// "entry_speed, mass" or "all"; empty: none.
std::vector<simulation::ScalarParameter> read_sensitivities(const std::string& text) {
  const auto known = simulation::parameters::all();
  if (text.empty()) return {};
  if (text == "all") return known;
  std::vector<std::string> names;
  for (const auto& each : known) names.push_back(each.name);
  std::vector<simulation::ScalarParameter> wanted;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    wanted.push_back(known[choice("--sensitivities", word, names)]);
  }
  return wanted;
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
  const auto wanted = read_sensitivities(words.sensitivities);
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
  const auto folder = words.out.empty() ? default_folder(words, overrun.entry_speed) : words.out;
  for (const char* name : {"history.csv", "history.h5", "result.json", "report.html"})
    settings.results.push_back(folder / name);
  Progress progress("overrun of the " + inputs.model.aircraft.name);
  report::OverrunRecord record{std::move(inputs.model), overrun, options, {}, {}, {}};
  record.result = simulation::simulate(record.model, overrun, options);
  for (const auto& parameter : wanted)
    record.sensitivities.push_back(
        {simulation::sensitivity(record.model, overrun, parameter, options), parameter.unit});
  record.manifest = {std::string("apc ") + APC_VERSION, settings.command_line, utc_now(), std::move(inputs.files)};

  // Everything is made before anything is written; each file then appears whole or not at all.
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
  command->add_option("--brake-mode", words->brake_mode, "friction: on the vertical load; torque: by the wheel's slip")
      ->type_name("friction|torque");
  command->add_option("--wheel-spin", words->wheel_spin, "inertial: the tread spins the wheels up and down; free")
      ->type_name("inertial|free");
  command
      ->add_option("--thrust", words->thrust,
                   "net thrust, forward positive (default \"0 kN\"), or idle: the aircraft file's")
      ->type_name("FORCE|idle");
  command->add_option("--pitch-inertia", words->pitch_inertia, "instead of the aircraft file's")->type_name("INERTIA");
  command
      ->add_option("--rut-bearing-gain", words->rut_bearing,
                   "yield load on a rut's floor over virgin ground's (default 2, estimated)")
      ->type_name("NUMBER");
  command
      ->add_option("--rut-rolling-resistance", words->rut_rolling,
                   "drag / vertical on a rut's floor (default 0.02, estimated)")
      ->type_name("NUMBER");
  command
      ->add_option("--sensitivities", words->sensitivities,
                   "derivatives of what the summary prints by these inputs, or all of them")
      ->type_name("LIST|all");
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
