#include <CLI/CLI.hpp>

#include "apc/base/require.h"
#include "apc/cli/commands.h"

namespace apc::cli {

void add_common_options(CLI::App& command, Settings& settings) {
  command
      .add_option_function<std::string>(
          "--units",
          [&settings](const std::string& word) {
            require(word == "field" || word == "si", "--units: \"", word,
                    "\" is no system of units. Write field or si");
            settings.units = word == "si" ? report::UnitSystem::si : report::UnitSystem::field;
          },
          "units of the report: field (kt, ft, in, lbf, g; the default) or si")
      ->type_name("field|si");
  command.add_option("--json", settings.json, "write the full record to this file (SI)")->type_name("FILE");
  command.add_flag("--quiet", settings.quiet, "print neither report nor progress; messages of failure stay");
}

double option_quantity(const std::string& option, const std::string& text, const Dimension& wanted) {
  try {
    return parse_quantity(text, wanted);
  } catch (const InputError& reason) {
    throw InputError(option + ": " + reason.what());
  }
}

}  // namespace apc::cli
