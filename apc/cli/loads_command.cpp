/// `apc loads`: from a plan over SPH runs to a load table, and everything one does with tables.
#include <CLI/CLI.hpp>

#include "apc/cli/loads_commands.h"

namespace apc::cli {

void add_loads(CLI::App& program, Settings& settings) {
  auto* loads = program.add_subcommand("loads", "load campaign: sample plan, resumable runs, metamodels, tables");
  loads->require_subcommand(1);
  loads->footer(
      "A table from nothing, in three steps:\n"
      "  apc loads plan --tire H44.5x16.5-21 --material foam_50psi --runs 60 -o DIR\n"
      "  apc loads run DIR --jobs 2\n"
      "  apc loads fit DIR -o H44.5x16.5-21_foam_50psi.h5");
  add_loads_plan(*loads, settings);
  add_loads_run(*loads, settings);
  add_loads_status(*loads, settings);
  add_loads_fit(*loads, settings);
  add_loads_show(*loads, settings);
  add_loads_import(*loads, settings);
  add_loads_export(*loads, settings);
  add_loads_check(*loads, settings);
}

}  // namespace apc::cli
