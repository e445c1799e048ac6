/// The same aircraft, tires and bed with every quantity in the other system of units (kilograms in pounds, feet in
/// metres): conversion happens in the readers, so that the numbers inside agree to rounding, and the stop with them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/shipped_models.h"

namespace apc::simulation {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A metric unit's imperial counterpart, and how many of the metric one it is.
struct Counterpart {
  const char *metric, *imperial;
  double size;
};
constexpr double lb = 0.45359237, ft = 0.3048, in = 0.0254, lbf = lb * 9.80665;
constexpr Counterpart counterparts[] = {{"kg", "lb", lb},
                                        {"m", "ft", ft},
                                        {"cm", "in", in * 1e2},
                                        {"m^2", "ft^2", ft* ft},
                                        {"m^3", "in^3", in* in* in},
                                        {"kN", "lbf", lbf / 1e3},
                                        {"N", "lbf", lbf},
                                        {"MPa", "psi", lbf / (in * in) / 1e6},
                                        {"kg m^2", "lb ft^2", lb* ft* ft},
                                        {"N s^2/m^2", "lbf s^2/ft^2", lbf / (ft * ft)},
                                        {"MN/m", "lbf/in", lbf / in / 1e6}};

/// What a number in `unit` has to be multiplied by, and its unit then; nothing for units of both systems.
std::pair<double, std::string> other_system(const std::string& unit) {
  for (const auto& each : counterparts) {
    if (unit == each.metric) return {1.0 / each.size, each.imperial};
    if (unit == each.imperial) return {each.size, each.metric};
  }
  return {1.0, ""};
}

/// Every quantity "number unit" and column {unit, values} changes its system; returns how many.
int change_system(json& value) {
  if (value.is_object() && value.contains("unit") && value.contains("values")) {
    const auto [factor, unit] = other_system(value["unit"]);
    if (unit.empty()) return 0;
    for (auto& each : value["values"]) each = each.get<double>() * factor;
    value["unit"] = unit;
    return 1;
  }
  if (value.is_object() || value.is_array()) {
    int count = 0;
    for (auto& [key, each] : value.items())
      if (key != "sources" && key != "source") count += change_system(each);
    return count;
  }
  if (!value.is_string()) return 0;
  std::istringstream words(value.get<std::string>());
  double number = 0.0;
  std::string unit;
  if (!(words >> number) || !std::getline(words >> std::ws, unit)) return 0;
  const auto [factor, other] = other_system(unit);
  if (other.empty()) return 0;
  std::ostringstream out;
  out.precision(17);
  out << number * factor << " " << other;
  value = out.str();
  return 1;
}

struct Decks {
  aircraft::Aircraft plane;
  bed::Bed bed;
};

enum class As { shipped, in_other_units };

/// The shipped files of an aircraft and a bed, as they are or in the other units.
Decks decks(const std::string& aircraft_name, const std::string& bed_name, As as) {
  const auto folder = fs::temp_directory_path() / ("units_test_" + std::to_string(::getpid()));
  const auto deck = [&](const fs::path& path) {
    auto file = json::parse(read_text(shipped(path)));
    if (as == As::in_other_units) {
      EXPECT_GE(change_system(file), path.parent_path() == "designs/beds" ? 4 : 30) << path;
    }
    const auto out = folder / path.filename();
    write_text(out, file.dump());
    return out;
  };
  const auto tires = aircraft::load_tires(deck("aircraft/data/tires.json"));
  Decks result{aircraft::load_aircraft(deck("aircraft/data/" + aircraft_name + ".json"), tires),
               bed::load_bed(deck("designs/beds/" + bed_name + ".json"))};
  fs::remove_all(folder);
  return result;
}

std::vector<double> numbers(const Decks& decks) {
  const auto& plane = decks.plane;
  std::vector<double> all{plane.mass,         plane.pitch_inertia, plane.ramp_mass,
                          plane.takeoff_mass, plane.landing_mass,  plane.aero.area,
                          plane.idle_thrust,  plane.cg_height,     plane.cg_behind_nose_gear};
  for (const auto& gear : plane.gears)
    for (const double each :
         {gear.behind_nose_gear, gear.unsprung_mass, gear.wheel_inertia, gear.axle_spacing, gear.bogie_inertia,
          gear.strut.stroke, gear.strut.piston_area, gear.strut.extended_pressure, gear.strut.extended_gas_volume,
          gear.strut.damping_compression, gear.strut.damping_rebound, gear.strut.friction, gear.strut.bearing_upper,
          gear.strut.bearing_lower, gear.strut.end_stop, gear.strut.rake})
      all.push_back(each);
  for (const auto* column : {&decks.bed.distance, &decks.bed.depth})
    all.insert(all.end(), column->begin(), column->end());
  all.push_back(decks.bed.setback);
  return all;
}

TEST(Units, DecksInTheOtherSystemGiveTheSameStop) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto shipped_decks = decks(name, "emas_18in_50psi", As::shipped),
               other = decks(name, "emas_18in_50psi", As::in_other_units);
    const auto a = numbers(shipped_decks), b = numbers(other);
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i], b[i], 1e-12 * std::abs(a[i])) << name << " " << i;
      if (a[i] != 0.0) worst = std::max(worst, std::abs(b[i] / a[i] - 1.0));
    }
    const auto stop = [&](const Decks& of) {
      Overrun overrun;
      overrun.entry_speed = 60 * units::kt;
      overrun.braking = 0.25;
      Options options;
      options.rtol = 1e-8;
      options.sampling = 0.0;
      return simulate(make_model(of.plane, of.bed, testing::shipped_tables(of.plane)), overrun, options).stop_distance;
    };
    const double metres = stop(shipped_decks), same = stop(other);
    std::printf("V12 %s: inputs within %.1e, stop %.6f m within %.1e m\n", name, worst, metres,
                std::abs(metres - same));
    EXPECT_NEAR(metres, same, 1e-7 * metres) << name;
  }
}

}  // namespace
}  // namespace apc::simulation
