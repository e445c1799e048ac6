#include <algorithm>
#include <set>

#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/learning/data_check.h"
#include "apc/learning/run_json.h"
#include "apc/simulation/table_tire.h"
#include "loadtables/fit.h"
#include "loadtables/samples.h"

namespace apc::learning {
namespace {

void read_tables(const Json& file, Case& data) {
  std::vector<loadtables::LoadTable> tables;
  std::map<std::string, std::array<double, 2>> quoted;
  for (const std::string& name : file.texts("loads")) {
    const auto path = data.folder / name;
    if (path.extension() == ".csv") {
      const loadtables::SampleSet samples = loadtables::read_loads_csv(path);
      const auto tire = data.aircraft.tires.find(samples.tire);
      file.check(tire != data.aircraft.tires.end(), "loads",
                 "holds a table for the tire " + samples.tire + ", which no gear of the aircraft carries.");
      loadtables::Provenance provenance;
      provenance.material = samples.material;
      provenance.source = samples.source;
      loadtables::FitOptions options;
      if (data.bed.nominal) options.strength = data.bed.nominal->strength;
      tables.push_back(loadtables::fit(samples, simulation::table_tire(tire->second), provenance, options));
      quoted[samples.tire] = {samples.drag_rms, samples.vertical_rms};
    } else {
      tables.push_back(loadtables::load_table(path));
    }
  }
  const simulation::Model model = simulation::make_model(data.aircraft, data.bed, tables);
  data.tables = model.tables;
  for (const auto& table : data.tables) {
    const auto rms = quoted.contains(table.tire().name) ? quoted[table.tire().name] : std::array<double, 2>{0.0, 0.0};
    data.drag_rms.push_back(rms[0] > 0.0 ? rms[0] : 0.04);
    data.vertical_rms.push_back(rms[1] > 0.0 ? rms[1] : 0.04);
  }
}

}  // namespace

Case load_case(const std::filesystem::path& folder_or_file, const std::optional<std::filesystem::path>& alias_file) {
  const auto path = std::filesystem::is_directory(folder_or_file) ? folder_or_file / "case.json" : folder_or_file;
  const Json file = read_json(path);
  file.schema("apc-case/1");
  Case data;
  data.folder = path.parent_path();
  data.title = file.text("title", data.folder.filename().string());
  data.aircraft = aircraft::load_aircraft(data.folder / file.text("aircraft"),
                                          aircraft::load_tires(data.folder / file.text("tires")));
  data.bed = bed::load_bed(data.folder / file.text("bed"));
  read_tables(file, data);
  if (file.has("scatter")) {
    const Json scatter = file.object("scatter");
    data.block_strength = scatter.number("block_strength", data.block_strength);
    data.correlation = scatter.quantity("correlation", dimension::length, data.correlation);
    data.bed_strength = scatter.number("bed_strength", data.bed_strength);
    scatter.check(data.bed_strength > 0.0 && data.bed_strength <= 1.0, "bed_strength",
                  "is no standard deviation of a logarithm (above 0, up to 1). A certified bed has 0.04.");
  }
  std::optional<Aliases> aliases;
  if (alias_file) aliases = load_aliases(*alias_file);
  std::vector<std::string> failures;
  const auto read_runs = [&](const std::string& key, std::vector<Run>& runs) {
    if (!file.has(key)) return;
    for (const std::string& name : file.texts(key)) {
      try {
        runs.push_back(
            load_run(data.folder / name, data.aircraft, data.bed, aliases ? &*aliases : nullptr, data.remarks));
      } catch (const InputError& error) {
        failures.push_back(error.what());
        data.remarks.push_back(
            {std::filesystem::path(name).stem().string(), "", error.what(), DataRemark::Action::run_set_aside});
      }
    }
  };
  read_runs("runs", data.runs);
  read_runs("held_out", data.held_out);
  check_runs(data);
  require(!data.runs.empty(), path.string(), ": no usable run is left. ",
          !failures.empty()      ? failures.front()
          : data.remarks.empty() ? std::string("Name at least one under \"runs\".")
                                 : data.remarks.back().run + " " + data.remarks.back().text + ".");
  return data;
}

}  // namespace apc::learning
