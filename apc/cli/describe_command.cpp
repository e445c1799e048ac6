/// `apc describe`: documents a file format, key by key; lists the formats when called bare.
#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/quantity.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/formats.h"
#include "apc/cli/text_table.h"

namespace apc::cli {

std::vector<FormatNote> all_formats() {
  return {describe_aircraft(), describe_tire(),     describe_bed(),    describe_loads(),   describe_material(),
          describe_sph(),      describe_fleet(),    describe_design(), describe_scatter(), describe_site(),
          describe_model(),    describe_manifest(), describe_case(),   describe_run(),     describe_effect()};
}

namespace {

const char* const quantities =
    "A dimensional quantity is a string with its unit, \"70 kt\", \"3.0e6 kg m^2\", or a list {\"unit\": \"in\", "
    "\"values\": [0, 18]}.\nNumbers without dimension are bare. Unknown keys and a missing \"source\" are errors.\n"
    "Units: m mm cm km ft in nmi · s ms min · kg t lb lbm · N kN MN lbf kip · Pa kPa MPa psi psf · m/s kt mph ft/s "
    "km/h\n"
    "· m/s^2 g · deg rad · rad/s rpm · K degC degF · kg/m^3 pcf · J kJ MJ · products, quotients, powers of these.\n";

TextTable overview() {
  TextTable table{{"format", "what it holds"}, {}};
  for (const auto& format : all_formats()) table.rows.push_back({format.schema, format.what});
  return table;
}

/// Takes "apc-bed/1", "apc-bed" and "bed".
FormatNote find_format(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& format : all_formats()) {
    const auto word = format.schema.substr(4, format.schema.find('/') - 4);
    if (name == format.schema || name == word || name == "apc-" + word) return format;
    known.insert(known.end(), {word, format.schema});
  }
  const auto near = nearest(name, known.data(), known.size());
  throw InputError(concat("\"", name, "\" is no format of this program.",
                          near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"),
                          " \"apc describe\" lists them"));
}

TextTable keys_of(const FormatNote& format) {
  TextTable table{{"key", "kind", "need", "example", "meaning"}, {}};
  for (const auto& key : format.keys) table.rows.push_back({key.key, key.kind, key.need, key.example, key.meaning});
  return table;
}

}  // namespace

void add_describe(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand("describe", "documents a file format; lists the formats when called bare");
  const auto name = std::make_shared<std::string>();
  command->add_option("SCHEMA", *name, "such as apc-bed/1, or just bed")->type_name("");
  add_common_options(*command, settings);
  command->callback([name, &settings] {
    std::string text;
    TextTable table;
    if (name->empty()) {
      table = overview();
      text = aligned(table) + "\n" + quantities;
    } else {
      const auto format = find_format(*name);
      table = keys_of(format);
      text = format.schema + ": " + format.what + "\n" + format.general + "\n\n" + aligned(table) + "\n" + quantities;
    }
    if (!settings.json.empty()) write_text(settings.json, table_json(table, "apc-describe/1"));
    if (!settings.quiet) std::fputs(text.c_str(), stdout);
  });
}

}  // namespace apc::cli
