/// A case of our own making as the files a user would have: shipped aircraft, load tables as samples of the crush law,
/// bed, runs with signals, surveys and stops. What is written is rounded as instruments and drawings are.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apc/base/csv.h"
#include "apc/learning/measured.h"
#include "loadtables/samples.h"
#include "tests/support/simulation_models.h"

namespace apc::testing {

/// What a case's files say beside the numbers.
struct CaseTexts {
  std::string title, aircraft, bed_name, bed_source, material;
};

inline std::string quantity_text(double value, const std::string& unit, int digits = 5) {
  return fmt::format("{:.{}g} {}", value / parse_unit(unit).factor, digits, unit);
}

/// The crush law at speeds × depths × penetrations as a batch of single-wheel runs would give it: three digits.
inline void write_law_samples(const aircraft::Tire& tire, const loadtables::CrushBalance& law,
                              const std::string& material, double quoted_rms, const std::filesystem::path& path) {
  loadtables::SampleSet set;
  set.material = material, set.tire = tire.name, set.source = "closed-form balance of tire and foam";
  set.has_rut = set.has_spin = true, set.drag_rms = set.vertical_rms = quoted_rms;
  const auto scale = loadtables::penetration_scale(simulation::table_tire(tire));
  const auto rounded = [](double value) { return std::stod(fmt::format("{:.4g}", value)); };
  for (const double speed : {10.0, 40.0, 70.0})
    for (const double depth : {3.0, 9.0, 14.0, 18.0, 21.0})
      for (const double share : {0.05, 0.15, 0.3, 0.5, 0.7, 0.8, 0.9, 1.0}) {
        const double h = depth * units::in;
        const TireContact contact{speed * units::kt, h, share * scale.at(h)};
        TireLoad load = law.load(contact);
        load.drag = rounded(load.drag), load.vertical = rounded(load.vertical);
        set.samples.push_back({contact, load});
      }
  loadtables::write_loads_csv(set, path);
}

inline nlohmann::ordered_json bed_file(const bed::Bed& bed, const CaseTexts& texts) {
  nlohmann::ordered_json distance = {{"unit", "m"}, {"values", bed.distance}},
                         depth = {{"unit", "in"}, {"values", nlohmann::ordered_json::array()}};
  for (const double h : bed.depth) depth["values"].push_back(std::stod(fmt::format("{:.5g}", h / units::in)));
  return {
      {"schema", "apc-bed/1"},
      {"name", texts.bed_name},
      {"source", texts.bed_source},
      {"setback", quantity_text(bed.setback, "m")},
      {"width", quantity_text(bed.width, "m")},
      {"material", texts.material},
      {"nominal",
       {{"strength", quantity_text(bed.nominal->strength, "psi")},
        {"density", quantity_text(bed.nominal->density, "kg/m^3")},
        {"bottoming_strain", bed.nominal->bottoming_strain}}},
      {"flush", "top"},
      {"profile", {{"distance", distance}, {"depth", depth}}},
      {"blocks", {{"length", quantity_text(bed.block_length, "m")}, {"width", quantity_text(bed.block_length, "m")}}},
      {"grade", bed.grade}};
}

/// All channels on the times of the fastest one; empty cells where a slower one has no sample.
inline std::string signals_text(const learning::Run& run) {
  std::map<long, std::vector<double>> rows;  // by hundredths of a second
  for (std::size_t c = 0; c < run.channels.size(); ++c)
    for (std::size_t i = 0; i < run.channels[c].time.size(); ++i) {
      auto& row = rows[std::lround(run.channels[c].time[i] * 100.0)];
      row.resize(run.channels.size(), std::nan(""));
      row[c] = run.channels[c].value[i];
    }
  std::vector<CsvColumn> columns = {{"time", "s", {}}};
  for (const auto& c : run.channels) columns.push_back({c.column, c.unit, {}});
  for (const auto& [time, row] : rows) {
    columns[0].values.push_back(static_cast<double>(time) / 100.0);
    for (std::size_t c = 0; c < row.size(); ++c)
      columns[c + 1].values.push_back(row[c] / parse_unit(run.channels[c].unit).factor);
  }
  return csv_text({}, columns, 4);
}

inline void write_run(const learning::Run& run, const std::filesystem::path& folder) {
  using learning::Quantity;
  nlohmann::ordered_json file = {{"schema", "apc-run/1"},
                                 {"id", run.id},
                                 {"mass", quantity_text(run.overrun.mass, "kg")},
                                 {"cg_behind_nose_gear", quantity_text(run.overrun.cg_behind_nose_gear, "m")},
                                 {"pitch_inertia", quantity_text(run.overrun.pitch_inertia, "kg m^2")},
                                 {"entry", {{"speed", quantity_text(run.overrun.entry_speed, "m/s")}}},
                                 {"braking", run.overrun.braking},
                                 {"thrust", quantity_text(run.overrun.thrust, "N")},
                                 {"wind", "0 m/s"},
                                 {"lane", run.lane},
                                 {"uncertainty",
                                  {{"mass", quantity_text(run.uncertainty.mass, "kg")},
                                   {"cg_behind_nose_gear", quantity_text(run.uncertainty.cg, "m")},
                                   {"pitch_inertia", quantity_text(run.uncertainty.pitch_inertia, "kg m^2")},
                                   {"entry_speed", quantity_text(run.uncertainty.entry_speed, "m/s")},
                                   {"wind", quantity_text(run.uncertainty.wind, "m/s")}}}};
  for (const auto& c : run.channels) {
    nlohmann::ordered_json channel = {{"quantity", learning::name_of(c.quantity)},
                                      {"noise", quantity_text(c.noise, c.unit)},
                                      {"bias", quantity_text(c.bias, c.unit)},
                                      {"lag", quantity_text(c.lag, "s")}};
    file["channels"][c.column + " [" + c.unit + "]"] = channel;
  }
  if (!run.channels.empty()) {
    file["signals"] = run.id + ".csv";
    write_text(folder / (run.id + ".csv"), signals_text(run));
  }
  if (run.survey) {
    file["survey"] = run.id + "_rut.csv";
    write_text(folder / (run.id + "_rut.csv"), csv_text({},
                                                        {{"distance", "m", run.survey->distance},
                                                         {"nose_rut", "m", run.survey->nose_rut},
                                                         {"main_rut", "m", run.survey->main_rut}},
                                                        3));
  }
  if (run.stop)
    file["stop"] = {{"quantity", "nose_distance"},
                    {"value", quantity_text(*run.stop, "m")},
                    {"noise", quantity_text(run.stop_noise, "m")}};
  write_text(folder / (run.id + ".json"), file.dump(1) + "\n");
}

/// `law`: of each tire the aircraft carries.
template <class LawOf>
void write_case(const learning::Case& data, const CaseTexts& texts, const LawOf& law, double quoted_rms,
                const std::filesystem::path& folder) {
  nlohmann::ordered_json loads = nlohmann::ordered_json::array(), runs = loads;
  for (const auto& [name, tire] : data.aircraft.tires) {
    const std::string file = fmt::format("loads_{}.csv", loads.size() + 1);
    write_law_samples(tire, law(tire), texts.material, quoted_rms, folder / file);
    loads.push_back(file);
  }
  write_text(folder / "bed.json", bed_file(data.bed, texts).dump(1) + "\n");
  for (const auto& run : data.runs) {
    write_run(run, folder / "runs");
    runs.push_back("runs/" + run.id + ".json");
  }
  nlohmann::ordered_json scatter = {{"block_strength", data.block_strength},
                                    {"correlation", quantity_text(data.correlation, "m")}};
  if (data.bed_strength != 0.04) scatter["bed_strength"] = data.bed_strength;
  const std::string shipped = "../../../aircraft/data/";
  const nlohmann::ordered_json file = {{"schema", "apc-case/1"},
                                       {"title", texts.title},
                                       {"aircraft", shipped + texts.aircraft + ".json"},
                                       {"tires", shipped + "tires.json"},
                                       {"bed", "bed.json"},
                                       {"loads", loads},
                                       {"runs", runs},
                                       {"scatter", scatter}};
  write_text(folder / "case.json", file.dump(1) + "\n");
}

}  // namespace apc::testing
