#include "apc/cli/inputs.h"

#include <chrono>
#include <ctime>
#include <set>

#include "apc/base/file.h"
#include "apc/base/quantity.h"
#include "apc/base/require.h"
#include "apc/report/sha256.h"
#include "apc/simulation/table_tire.h"
#include "loadtables/find_tables.h"

namespace apc::cli {
namespace fs = std::filesystem;

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

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

/// One table per tire of the aircraft, in the bed's material.
std::vector<loadtables::LoadTable> choose_tables(const fs::path& folder, const fs::path& bed_file,
                                                 const aircraft::Aircraft& plane, const std::string& material,
                                                 std::vector<report::InputFile>& files) {
  const auto known = loadtables::list_tables(folder);
  std::set<std::string> materials, needed;
  for (const auto& file : known) materials.insert(file.material);
  if (!known.empty() && !materials.contains(material)) {
    std::string list;
    for (const auto& each : materials) list += (list.empty() ? "" : ", ") + each;
    const std::vector<std::string> names(materials.begin(), materials.end());
    const auto near = nearest(material, names.data(), names.size());
    throw InputError(concat(bed_file.string(), " /material: \"", material, "\" has no load tables in ", folder.string(),
                            ".", near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"),
                            " There are tables for: ", list));
  }
  std::vector<loadtables::LoadTable> chosen;
  for (const auto& gear : plane.gears) {
    if (!needed.insert(gear.tire).second) continue;
    chosen.push_back(loadtables::find_table(folder, material, simulation::table_tire(plane.tires.at(gear.tire))));
    for (const auto& file : known)
      if (file.tire == gear.tire && file.material == material) {
        files.push_back(note("load table", file.path, chosen.back().provenance().source));
        break;
      }
  }
  return chosen;
}

}  // namespace

Inputs read_inputs(const Choice& choice) {
  resolve(choice.aircraft, "aircraft/data", "aircraft");  // the first name is the first to be told wrong
  const auto bed_file = resolve(choice.bed, "designs/beds", "bed");
  auto bed = bed::load_bed(bed_file);
  const auto from = note("bed", bed_file, bed.source);
  return read_inputs(choice, std::move(bed), from);
}

Inputs read_inputs(const Choice& choice, bed::Bed bed, const report::InputFile& from) {
  Inputs inputs;
  const auto aircraft_file = resolve(choice.aircraft, "aircraft/data", "aircraft");
  std::vector<report::InputFile> tires;
  auto plane = aircraft::load_aircraft(aircraft_file, read_tires(choice.tires, aircraft_file, tires));
  inputs.files.push_back(note("aircraft", aircraft_file, plane.source));
  inputs.files.insert(inputs.files.end(), tires.begin(), tires.end());
  inputs.files.push_back(from);
  const auto folder = choice.loads.empty() ? shipped("loadtables/data") : choice.loads;
  const auto tables = choose_tables(folder, from.path, plane, bed.material, inputs.files);
  inputs.model = simulation::make_model(std::move(plane), std::move(bed), tables);
  return inputs;
}

}  // namespace apc::cli
