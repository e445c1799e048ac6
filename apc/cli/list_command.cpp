/// `apc list`: the shipped data by name, with the figures one chooses by.
#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/inputs.h"
#include "apc/cli/text_table.h"
#include "loadtables/find_tables.h"
#include "sph_backend/material_json.h"

namespace apc::cli {
namespace {

using report::shown;
using report::UnitSystem;
namespace measure = report::measure;

TextTable list_aircraft(UnitSystem units) {
  TextTable table{{"name", "mass", "nose to main", "gears", "nose tire", "main tire"}, {}};
  for (const auto& name : shipped_names("aircraft/data")) {
    const auto path = resolve(name, "aircraft/data", "aircraft");
    std::vector<report::InputFile> read;
    const auto plane = aircraft::load_aircraft(path, read_tires({}, path, read));
    const auto& last = plane.gears.back();
    std::string gears;
    for (const auto& gear : plane.gears)
      gears += (gears.empty() ? "" : ", ") +
               concat(gear.name, " ", gear.struts, "×", gear.wheels_per_axle * gear.axles, " wheels");
    table.rows.push_back({name, shown(plane.mass, measure::mass, units),
                          shown(last.behind_nose_gear, measure::distance, units), gears, plane.gears.front().tire,
                          last.tire});
  }
  return table;
}

TextTable list_tires(UnitSystem units) {
  TextTable table{{"name", "diameter", "width", "inflation", "rated load", "deflection", "bottoming load"}, {}};
  for (const auto& [name, tire] : aircraft::load_tires(shipped("aircraft/data/tires.json")))
    table.rows.push_back(
        {name, shown(tire.diameter, measure::depth, units), shown(tire.width, measure::depth, units),
         shown(tire.inflation, measure::pressure, units), shown(tire.rated_load, measure::force, units),
         shown(tire.rated_deflection, measure::depth, units), shown(tire.bottoming_load, measure::force, units)});
  return table;
}

TextTable list_beds(UnitSystem units) {
  TextTable table{{"name", "length", "depth", "width", "setback", "material", "volume", "flush"}, {}};
  for (const auto& name : shipped_names("designs/beds")) {
    const auto each = bed::load_bed(resolve(name, "designs/beds", "bed"));
    table.rows.push_back(
        {name, shown(each.length(), measure::distance, units), shown(each.maximum_depth(), measure::depth, units),
         shown(each.width, measure::distance, units), shown(each.setback, measure::distance, units), each.material,
         shown(each.volume(), measure::volume, units), each.flush == bed::Flush::top ? "top" : "base"});
  }
  return table;
}

TextTable list_loads(UnitSystem units) {
  TextTable table{{"tire", "material", "runs", "speed", "bed depth", "drag error", "vertical error", "file"}, {}};
  for (const auto& file : loadtables::list_tables(shipped("loadtables/data"))) {
    if (file.path.extension() != ".h5") continue;
    const auto each = loadtables::load_table(file.path);
    const auto range = [&](const std::array<double, 2>& ends, const report::Measure& in) {
      return report::number(ends[0] / in.in(units).factor, in.in(units).digits) + " to " + shown(ends[1], in, units);
    };
    const auto loo = [&](const char* response) {
      for (const auto& quality : each.quality())
        if (quality.response == response) return report::percent(quality.loo_rms_relative, 1);
      return std::string("-");
    };
    table.rows.push_back({each.tire().name, each.provenance().material, std::to_string(each.provenance().runs),
                          range(each.speed_range(), measure::speed), range(each.depth_range(), measure::depth),
                          loo("drag"), loo("vertical"), file.path.filename().string()});
  }
  return table;
}

TextTable list_materials(UnitSystem units) {
  TextTable table{{"name", "strength", "density", "full at", "tension cutoff"}, {}};
  for (const auto& name : shipped_names("designs/materials")) {
    const auto each = sph::load_foam(resolve(name, "designs/materials", "material"));
    table.rows.push_back({name, shown(each.nominal_strength, measure::pressure, units),
                          shown(each.nominal_density, measure::density, units), report::percent(each.bottoming_strain),
                          shown(each.foam.tension_cutoff, measure::pressure, units)});
  }
  return table;
}

TextTable list_named(const std::string& what, UnitSystem units) {
  if (what == "aircraft") return list_aircraft(units);
  if (what == "tires") return list_tires(units);
  if (what == "beds") return list_beds(units);
  if (what == "materials") return list_materials(units);
  if (what == "loads") return list_loads(units);
  const std::vector<std::string> known{"aircraft", "tires", "beds", "materials", "loads"};
  const auto near = nearest(what, known.data(), known.size());
  throw InputError(concat("\"", what, "\" is no kind of shipped data.",
                          near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"),
                          " Kinds: aircraft, tires, beds, materials, loads"));
}

}  // namespace

void add_list(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand("list", "shipped data: aircraft, tires, beds, materials, loads");
  const auto what = std::make_shared<std::string>();
  command->add_option("KIND", *what, "aircraft, tires, beds, materials or loads")->required()->type_name("");
  add_common_options(*command, settings);
  command->callback([what, &settings] {
    const auto table = list_named(*what, settings.units);
    if (!settings.json.empty()) write_text(settings.json, table_json(table, "apc-list/1"));
    if (!settings.quiet) std::fputs(aligned(table).c_str(), stdout);
  });
}

}  // namespace apc::cli
