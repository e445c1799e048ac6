#include "apc/cli/inputs.h"

#include <algorithm>
#include <set>

#include "apc/base/file.h"
#include "apc/base/quantity.h"
#include "apc/base/require.h"
#include "apc/report/sha256.h"
#include "loadtables/fit.h"

namespace apc::cli {
namespace fs = std::filesystem;

report::InputFile note(const std::string& role, const fs::path& path, const std::string& source) {
  return {role, path.string(), report::sha256(read_text(path)), source};
}

aircraft::TireLibrary read_tires(const fs::path& tires, const fs::path& aircraft_file,
                                 std::vector<report::InputFile>& files) {
  aircraft::TireLibrary library;
  const auto add = [&](const fs::path& path) {
    for (auto& [name, tire] : aircraft::load_tires(path)) library.insert_or_assign(name, tire);
    files.push_back(note("tires", path, ""));
  };
  if (!tires.empty()) {
    add(tires);
    return library;
  }
  std::error_code error;
  const auto shipped_library = shipped("aircraft/data/tires.json"), beside = aircraft_file.parent_path() / "tires.json";
  if (fs::is_regular_file(shipped_library, error)) add(shipped_library);
  if (fs::is_regular_file(beside, error) && !fs::equivalent(beside, shipped_library, error)) add(beside);
  require(!library.empty(), "no tire library was found. Name one with --tires FILE");
  return library;
}

namespace {

loadtables::TableTire table_tire(const aircraft::Tire& tire) {
  return {tire.name,
          tire.diameter,
          tire.width,
          tire.rated_load,
          tire.rated_deflection,
          tire.bottoming_load,
          tire.bottoming_deflection,
          tire.load_curve.x(),
          tire.load_curve.y()};
}

/// A table among the candidates of a folder, with where it came from.
struct Candidate {
  loadtables::LoadTable table;
  fs::path file;
};

std::vector<Candidate> read_tables(const fs::path& folder, const aircraft::Aircraft& plane) {
  std::error_code error;
  require(fs::is_directory(folder, error), folder.string(),
          ": no such folder of load tables. Name one with --loads DIR");
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Candidate> found;
  for (const auto& path : paths) {
    if (path.extension() == ".h5") {
      found.push_back({loadtables::load_table(path), path});
    } else if (path.extension() == ".csv" && read_text(path).find("apc-loads/1") != std::string::npos) {
      const auto samples = loadtables::read_loads_csv(path);
      const auto tire = plane.tires.find(samples.tire);
      if (tire == plane.tires.end()) continue;  // samples of a tire this aircraft does not have
      loadtables::Provenance provenance;
      provenance.material = samples.material;
      provenance.source = samples.source;
      provenance.runs = static_cast<int>(samples.samples.size());
      found.push_back({loadtables::fit(samples, table_tire(tire->second), provenance), path});
    }
  }
  require(!found.empty(), folder.string(), ": holds no load tables (.h5, or .csv of schema apc-loads/1)");
  return found;
}

std::vector<loadtables::LoadTable> choose_tables(const fs::path& folder, const fs::path& bed_file,
                                                 const aircraft::Aircraft& plane, const std::string& material,
                                                 std::vector<report::InputFile>& files) {
  const auto candidates = read_tables(folder, plane);
  std::set<std::string> materials;
  for (const auto& each : candidates) materials.insert(each.table.provenance().material);
  if (!materials.contains(material)) {
    std::string list;
    for (const auto& each : materials) list += (list.empty() ? "" : ", ") + each;
    const std::vector<std::string> known(materials.begin(), materials.end());
    const auto near = nearest(material, known.data(), known.size());
    throw InputError(concat(bed_file.string(), " /material: \"", material, "\" has no load tables in ", folder.string(),
                            near.empty() ? std::string() : concat(". Did you mean \"", near, "\"?"),
                            " Materials there: ", list,
                            ". Make tables for it with \"apc loads\", or name a folder with"
                            " --loads DIR"));
  }
  std::set<std::string> needed;
  for (const auto& gear : plane.gears) needed.insert(gear.tire);
  std::vector<loadtables::LoadTable> chosen;
  for (const auto& name : needed) {
    const auto match = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& each) {
      return each.table.tire().name == name && each.table.provenance().material == material;
    });
    require(match != candidates.end(), folder.string(), ": holds no load table of tire \"", name, "\" in \"", material,
            "\". Make it with \"apc loads\", or name a folder with --loads DIR");
    chosen.push_back(match->table);
    files.push_back(note("load table", match->file, match->table.provenance().source));
  }
  return chosen;
}

}  // namespace

Inputs read_inputs(const Choice& choice) {
  Inputs inputs;
  const auto aircraft_file = resolve(choice.aircraft, "aircraft/data", "aircraft");
  const auto bed_file = resolve(choice.bed, "designs/beds", "bed");
  auto bed = bed::load_bed(bed_file);
  std::vector<report::InputFile> tires;
  auto plane = aircraft::load_aircraft(aircraft_file, read_tires(choice.tires, aircraft_file, tires));
  inputs.files.push_back(note("aircraft", aircraft_file, plane.source));
  inputs.files.insert(inputs.files.end(), tires.begin(), tires.end());
  inputs.files.push_back(note("bed", bed_file, bed.source));
  const auto folder = choice.loads.empty() ? shipped("loadtables/data") : choice.loads;
  const auto tables = choose_tables(folder, bed_file, plane, bed.material, inputs.files);
  inputs.model = simulation::make_model(std::move(plane), std::move(bed), tables);
  return inputs;
}

}  // namespace apc::cli
