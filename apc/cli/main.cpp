/// apc - the Arrestor Prediction Code: reads the command line, runs one command, turns failures into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"

namespace apc::cli {
namespace {

/// The command as a shell would take it again.
std::string quoted(const std::vector<std::string>& words) {
  std::string line = "apc";
  for (const auto& word : words) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789-_./:,=+") == std::string::npos;
    line += plain ? " " + word : " \"" + word + "\"";
  }
  return line;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto near = nearest(word, known.data(), known.size());
  return near.empty() ? "" : ". Did you mean \"" + near + "\"?";
}

/// Refuses the first word that is neither a command nor an option of the command it follows, before the parser
/// complains about what is missing because of it.
void refuse_unknown_words(CLI::App& program, const std::vector<std::string>& words) {
  CLI::App* command = &program;
  std::string called = "apc";
  for (const auto& word : words) {
    if (word == "--") return;
    if (word.starts_with("--") && word.size() > 2) {
      const auto name = word.substr(0, word.find('='));
      if (command->get_option_no_throw(name)) continue;
      std::vector<std::string> known;
      for (const auto* option : command->get_options({}))
        for (const auto& each : option->get_lnames()) known.push_back("--" + each);
      throw InputError(
          concat(name, ": unknown option of \"", called, "\"", did_you_mean(name, known), " See ", called, " --help"));
    }
    if (word.starts_with("-")) continue;
    const auto children = command->get_subcommands({});
    std::vector<std::string> names;
    for (const auto* each : children) names.push_back(each->get_name());
    if (names.empty()) continue;  // a value or a positional argument
    const auto next = std::find(names.begin(), names.end(), word);
    if (next != names.end()) {
      command = children[static_cast<std::size_t>(next - names.begin())], called += " " + word;
      continue;
    }
    std::string list;
    for (const auto& each : names) list += (list.empty() ? "" : ", ") + each;
    throw InputError(
        concat("\"", word, "\" is no command of \"", called, "\"", did_you_mean(word, names), " Commands: ", list));
  }
}

/// After a run without a result there is none, not the one of a former run.
void withdraw(const Settings& settings) {
  std::error_code ignored;
  for (const auto& path : settings.results) std::filesystem::remove(path, ignored);
  if (!settings.results.empty() && !settings.json.empty()) std::filesystem::remove(settings.json, ignored);
}

int run(const std::vector<std::string>& words) {
  CLI::App program{"Arrestor Prediction Code: aircraft in crushable arrestor beds", "apc"};
  program.set_version_flag("--version", std::string("apc ") + APC_VERSION, "print the version");
  program.set_help_flag("-h,--help", "print this help");
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 done, 1 a requirement is not met, 2 bad input, 3 a solver gave up, 130 interrupted.\n"
      "Quantities carry units: --speed \"70 kt\". Names such as B737-800 are shipped data; paths work too.");
  Settings settings;
  settings.command_line = quoted(words);
  add_simulate(program, settings);
  add_study(program, settings);
  add_design(program, settings);
  add_reliability(program, settings);
  add_report(program, settings);
  add_site(program, settings);
  add_loads(program, settings);
  add_sph(program, settings);
  add_check(program, settings);
  add_describe(program, settings);
  add_list(program, settings);
  add_effects(program, settings);
  add_learning(program, settings);
  add_next(program, settings);

  try {
    refuse_unknown_words(program, words);
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    program.parse(std::move(reversed));
    return settings.exit_code;
  } catch (const CLI::CallForHelp& request) {
    return program.exit(request);
  } catch (const CLI::CallForVersion& request) {
    return program.exit(request);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "apc: %s. See apc --help\n", error.what());
  } catch (const InputError& error) {
    std::fprintf(stderr, "apc: %s\n", error.what());
  } catch (const SolveError& error) {
    withdraw(settings);
    std::fprintf(stderr, "apc: %s\n", error.what());
    return exit_code::gave_up;
  } catch (const Interrupted&) {
    std::fprintf(stderr, "apc: interrupted; nothing half-written was left\n");
    return exit_code::interrupted;
  }
  return exit_code::bad_input;
}

}  // namespace
}  // namespace apc::cli

int main(int argc, char** argv) {
  apc::catch_interrupts();
  return apc::cli::run({argv + 1, argv + argc});
}
