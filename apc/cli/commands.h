/// The commands of `apc`. Each `add_…` hangs one command on the program: its options, its help, and a callback that
/// does the work when the command line is parsed. The callbacks throw InputError, SolveError, Interrupted; main turns
/// them into one message and an exit code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/base/quantity.h"
#include "apc/report/unit_system.h"

namespace CLI {
class App;
}

namespace apc::cli {

/// Exit codes of the program.
namespace exit_code {
inline constexpr int done = 0, not_met = 1, bad_input = 2, gave_up = 3, interrupted = 130;
}

/// What every command understands, and what it hands back.
struct Settings {
  report::UnitSystem units = report::UnitSystem::field;  ///< --units field|si, of the report on stdout
  std::filesystem::path json;                            ///< --json FILE, the full record; empty = none
  bool quiet = false;                                    ///< --quiet: no progress, no report on stdout
  std::string command_line;                              ///< as typed, quoted for a shell; for provenance
  int exit_code = exit_code::done;                       ///< a command sets not_met when a requirement fails
  /// Files the command is about to make. When a solver gives up, former ones of these names are removed: what stands
  /// there after exit 3 would read like this run's result.
  std::vector<std::filesystem::path> results;
};

/// Adds --units, --json and --quiet to a command.
void add_common_options(CLI::App& command, Settings&);

/// SI value of an option's text. InputError "--speed: …" when it is no quantity of this dimension.
double option_quantity(const std::string& option, const std::string& text, const Dimension&);

void add_simulate(CLI::App&, Settings&);
void add_loads(CLI::App&, Settings&);
void add_sph(CLI::App&, Settings&);
void add_study(CLI::App&, Settings&);
void add_design(CLI::App&, Settings&);
void add_reliability(CLI::App&, Settings&);
void add_report(CLI::App&, Settings&);
void add_site(CLI::App&, Settings&);
void add_check(CLI::App&, Settings&);
void add_describe(CLI::App&, Settings&);
void add_list(CLI::App&, Settings&);
void add_effects(CLI::App&, Settings&);
void add_learning(CLI::App&, Settings&);  ///< compare, diagnose, add, verify, learn
void add_next(CLI::App&, Settings&);

}  // namespace apc::cli
