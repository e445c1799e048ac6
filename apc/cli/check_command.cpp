/// `apc check`: reads files as the other commands would and says what is wrong, without running anything.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/csv.h"
#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/formats.h"
#include "apc/cli/inputs.h"
#include "apc/cli/report_run.h"
#include "apc/cli/sph_deck.h"
#include "apc/cli/text_table.h"
#include "apc/effects/catalogue.h"
#include "apc/effects/effect_json.h"
#include "apc/learning/overlay_json.h"
#include "apc/reliability/scatter.h"
#include "apc/site/site.h"
#include "loadtables/samples.h"
#include "sph_backend/material_json.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;
using report::shown;
namespace measure = report::measure;

std::string check_aircraft(const fs::path& path, report::UnitSystem units) {
  std::vector<report::InputFile> read;
  const auto plane = aircraft::load_aircraft(path, read_tires({}, path, read));
  return concat(plane.name, ", ", shown(plane.mass, measure::mass, units), ", ", plane.gears.size(), " gears");
}

std::string check_bed(const fs::path& path, report::UnitSystem units) {
  const auto bed = bed::load_bed(path);
  return concat(bed.name, ", ", shown(bed.length(), measure::distance, units), " long, up to ",
                shown(bed.maximum_depth(), measure::depth, units), " of ", bed.material);
}

std::string check_fleet(const fs::path& path, report::UnitSystem units) {
  const auto fleet = design::load_fleet(path);
  load_fleet_models(fleet, note("fleet", path, fleet.source), {});  // aircraft, tables, masses, centres of gravity
  return concat(fleet.name, ", ", design::aircraft_names(fleet).size(), " aircraft, ", fleet.cases.size(),
                " cases, beds up to ", shown(fleet.bed.maximum_length, measure::distance, units));
}

std::string check_design(const fs::path& path, report::UnitSystem units) {
  OfDesign words;
  words.design = path.string();
  const auto loaded = load_design_models(words);
  return concat(loaded.design.bed.name, ", ", shown(loaded.design.bed.length(), measure::distance, units), ", ",
                loaded.models.size(), " cases");
}

std::string check_model(const fs::path& path, report::UnitSystem units) {
  const auto added = learning::load_overlay(path, effects::catalogue());
  std::string names;
  for (const auto& each : added.effects) names += (names.empty() ? "" : ", ") + each.effect.id;
  if (names.empty()) names = "no effects";
  if (!(added.slowest > 0.0)) return names;
  return concat(names, ", learned from ", shown(added.slowest, measure::speed, units), " to ",
                shown(added.fastest, measure::speed, units));
}

std::string check_case(const fs::path& path) {
  const auto data = learning::load_case(path);
  std::string text = concat(data.title, ", ", data.runs.size(), " runs, ", data.held_out.size(), " to predict");
  for (const auto& remark : data.remarks) text += concat("; ", remark.run, " ", remark.channel, " ", remark.text);
  return text;
}

std::string check_effect(const fs::path& path) {
  const auto effect = effects::load_own_effect(path);
  return concat(effect.id, ", ", effect.title, ", ", effect.parameters.size(), " parameters");
}

std::string check_manifest(const fs::path& path) {
  const auto ask = read_manifest(path);  // version of the program, files unchanged
  return concat("report of ", ask.of.design, "; the files it was made from are unchanged");
}

std::string check_json(const fs::path& path, report::UnitSystem units) {
  const auto file = read_json(path);
  const auto schema = file.text("schema");
  if (schema == "apc-aircraft/1") return schema + ": " + check_aircraft(path, units);
  if (schema == "apc-bed/1") return schema + ": " + check_bed(path, units);
  if (schema == "apc-tire/1") return concat(schema, ": ", aircraft::load_tires(path).size(), " tires");
  if (schema == "apc-material/1") {
    const auto data = sph::load_foam(path);
    return concat(schema, ": ", data.foam.name, ", ", shown(data.nominal_strength, measure::pressure, units), ", ",
                  shown(data.nominal_density, measure::density, units));
  }
  if (schema == "apc-sph/1") {
    const auto deck = read_deck(path);
    return concat(schema, ": ", deck.rig.tire.name, " in ", deck.material, " at ",
                  shown(deck.rig.speed, measure::speed, units));
  }
  if (schema == "apc-fleet/1") return schema + ": " + check_fleet(path, units);
  if (schema.starts_with("apc-design/")) return schema + ": " + check_design(path, units);
  if (schema == "apc-scatter/1") return schema + ": from " + reliability::load_scatter(path).source;
  if (schema == "apc-site/1") {
    const auto place = site::load_site(path);
    return concat(schema, ": ", place.name, ", safety area ", shown(place.safety_length, measure::distance, units));
  }
  if (schema == "apc-model/1") return schema + ": " + check_model(path, units);
  if (schema == "apc-case/1") return schema + ": " + check_case(path);
  if (schema == "apc-effect/1") return schema + ": " + check_effect(path);
  require(schema != "apc-run/1", path.string(), ": a run is checked with its aircraft and bed: check its case.json");
  if (schema == "apc-manifest/1") return schema + ": " + check_manifest(path);
  std::vector<std::string> known;
  for (const auto& format : all_formats()) known.push_back(format.schema);
  const auto near = nearest(schema, known.data(), known.size());
  throw InputError(concat(path.string(), " /schema: \"", schema, "\" is unknown to this program.",
                          near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"),
                          " \"apc describe\" lists the formats"));
}

std::string check_csv(const fs::path& path) {
  const auto table = read_csv(path);
  const auto schema = table.remarks.find("schema");
  if (schema == table.remarks.end())  // signals, surveys: any columns of numbers
    return concat("CSV: ", table.columns.size(), " columns, ", table.rows(), " rows");
  require(schema->second == "apc-loads/1", path.string(), ": \"# schema: ", schema->second,
          "\" is unknown to this program. Load samples are \"apc-loads/1\"");
  const auto samples = loadtables::read_loads_csv(path);
  return concat("apc-loads/1: ", samples.samples.size(), " samples of ", samples.tire, " in ", samples.material);
}

std::string check_file(const fs::path& path, report::UnitSystem units) {
  if (path.extension() == ".h5" || path.extension() == ".hdf5") {
    const auto table = loadtables::load_table(path);
    return concat("apc-loads/1: table of ", table.tire().name, " in ", table.provenance().material, ", ",
                  table.provenance().runs, " runs");
  }
  return path.extension() == ".csv" ? check_csv(path) : check_json(path, units);
}

}  // namespace

void add_check(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand("check", "validates files without running anything");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "files of any format of apc describe (JSON, CSV, HDF5)")
      ->required()
      ->type_name("");
  add_common_options(*command, settings);
  command->footer("One line per file; exit code 2 when any of them is bad.");
  command->callback([files, &settings] {
    TextTable table{{"file", "verdict", "message"}, {}};
    for (const auto& file : *files) {
      try {
        const auto what = check_file(file, settings.units);
        table.rows.push_back({file, "good", what});
        if (!settings.quiet) std::printf("good  %s: %s\n", file.c_str(), what.c_str());
      } catch (const InputError& error) {
        table.rows.push_back({file, "bad", error.what()});
        settings.exit_code = exit_code::bad_input;
        std::fprintf(stderr, "bad   %s\n", error.what());
      }
    }
    if (!settings.json.empty()) write_text(settings.json, table_json(table, "apc-check/1"));
  });
}

}  // namespace apc::cli
