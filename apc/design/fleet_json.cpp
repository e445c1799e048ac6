/// Schema "apc-fleet/1": reading, and refusing what no bed could satisfy.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/design/fleet.h"

namespace apc::design {
namespace {

/// Positive and at most `most`, else refused with what it is.
double positive(const Json& json, const std::string& key, const Dimension& dimension, double most, const char* what) {
  const double value = json.quantity(key, dimension);
  json.check(value > 0 && value <= most, key,
             concat("is no ", what, ": it must be above 0 and at most ", most, " (SI)"));
  return value;
}

FleetCase read_case(const Json& json, const std::string& aircraft, std::size_t number) {
  FleetCase each;
  each.aircraft = aircraft;
  each.name = json.text("name", concat("case ", number));
  auto& run = each.overrun;
  run.entry_speed = positive(json, "speed", dimension::speed, 100.0, "exit speed of an overrun");
  run.mass = json.quantity("mass", dimension::mass, 0.0);
  json.check(run.mass >= 0, "mass", "is negative");
  run.cg_behind_nose_gear = json.quantity("cg_behind_nose_gear", dimension::length, 0.0);
  json.check(run.cg_behind_nose_gear >= 0, "cg_behind_nose_gear",
             "is negative: it counts backwards from the nose gear");
  for (const auto& [key, value] : {std::pair{"braking", &run.braking}, {"braking_in_bed", &run.braking_in_bed}}) {
    if (!json.has(key)) continue;
    *value = json.number(key);
    json.check(*value >= 0 && *value <= 1, key, "is no friction coefficient: write a number from 0 to 1, such as 0.25");
  }
  run.thrust = json.quantity("thrust", dimension::force, 0.0);
  run.headwind = json.quantity("headwind", dimension::speed, 0.0);
  json.check(std::abs(run.headwind) <= 60, "headwind", "is beyond any wind (at most 60 m/s)");
  return each;
}

void read_aircraft(const Json& json, Fleet& fleet) {
  const auto name = json.text("aircraft");
  const auto cases = json.objects("cases");
  json.check(!cases.empty(), "cases",
             concat("is empty: \"", name,
                    "\" has no case. Give at least one, such as {\"speed\": \"70 kt\"}, or remove the "
                    "aircraft"));
  std::set<std::string> names;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    fleet.cases.push_back(read_case(cases[i], name, i + 1));
    cases[i].check(names.insert(fleet.cases.back().name).second, "name", "is used twice for this aircraft");
  }
}

Limits read_limits(const Json& json) {
  Limits limits;
  const auto word = json.text("criterion", "limit");
  json.check(word == "limit" || word == "ultimate", "criterion",
             "is unknown. Write \"limit\" (no damage) or \"ultimate\" (no collapse)");
  limits.criterion = word == "limit" ? Criterion::limit : Criterion::ultimate;
  for (const auto& [key, value] :
       {std::pair{"deceleration", &limits.deceleration}, {"deceleration_100ms", &limits.deceleration_100ms}})
    if (json.has(key)) *value = positive(json, key, dimension::acceleration, 100.0, "limit of deceleration");
  json.check(limits.deceleration == 0 || limits.deceleration_100ms <= limits.deceleration, "deceleration_100ms",
             "is above \"deceleration\": a mean over 0.1 s never exceeds the peak, so it would limit nothing");
  if (json.has("loads")) {
    limits.loads = json.texts("loads");
    json.check(!limits.loads.empty(), "loads",
               "is empty: without a load limit any bed would do. Leave it out to count all");
    for (const auto& load : limits.loads)
      json.check(load == "nose drag" || load == "nose vertical" || load == "main drag" || load == "main vertical",
                 "loads", concat("holds \"", load, "\"; known are nose drag, nose vertical, main drag, main vertical"));
  }
  limits.table_range = json.flag("table_range", true);
  return limits;
}

void read_range(const Json& json, const std::string& key, double most, double& low, double& high) {
  const auto range = json.object(key);
  low = range.quantity("minimum", dimension::length);
  range.check(low > 0, "minimum", "is not above 0");
  high = range.quantity("maximum", dimension::length);
  range.check(high >= low, "maximum", "is below \"minimum\": these limits contradict each other");
  range.check(high <= most, "maximum", concat("is more than ", most, " m. Check its unit"));
}

BedSpace read_bed(const Json& json) {
  BedSpace bed;
  bed.material = json.text("material");
  const auto flush = json.text("flush", "top");
  json.check(flush == "top" || flush == "base", "flush",
             "is unknown. Write \"top\" (surface level with the pavement) or \"base\" (base level with it)");
  bed.flush = flush == "top" ? bed::Flush::top : bed::Flush::base;
  bed.setback = json.quantity("setback", dimension::length);
  json.check(bed.setback >= 0, "setback", "is negative. The bed begins at or behind the pavement end");
  bed.width = positive(json, "width", dimension::length, 300.0, "width of a bed");
  bed.grade = json.number("grade", 0.0);
  json.check(std::abs(bed.grade) <= 0.1, "grade", "is steeper than 1 in 10");
  read_range(json, "depth", 2.0, bed.minimum_depth, bed.maximum_depth);
  read_range(json, "ramp", 200.0, bed.minimum_ramp, bed.maximum_ramp);
  bed.maximum_slope = json.number("maximum_slope", 0.1);
  json.check(bed.maximum_slope > 0 && bed.maximum_slope <= 1, "maximum_slope",
             "is no slope: write the change of depth per length, such as 0.05");
  json.check(
      bed.maximum_slope * bed.maximum_ramp >= bed.minimum_depth, "maximum_slope",
      "contradicts the other limits: even the longest ramp cannot reach the smallest depth at this slope. Allow a "
      "steeper slope, a longer ramp or a smaller depth");
  bed.maximum_length = positive(json, "maximum_length", dimension::length, 1000.0, "length of a bed");
  json.check(bed.maximum_length > bed.minimum_ramp, "maximum_length",
             "is not longer than the shortest ramp: these limits contradict each other");
  bed.nodes = json.integer("nodes", 4);
  json.check(bed.nodes >= 1 && bed.nodes <= 12, "nodes", "is outside 1 to 12");
  const auto blocks = json.object("blocks");
  bed.block_length = positive(blocks, "length", dimension::length, 20.0, "length of a block");
  bed.block_width = positive(blocks, "width", dimension::length, 20.0, "width of a block");
  bed.step = positive(blocks, "depth_step", dimension::length, 0.5, "step of block depths");
  return bed;
}

}  // namespace

Fleet read_fleet(const Json& json) {
  json.schema("apc-fleet/1");
  Fleet fleet;
  fleet.name = json.text("name");
  fleet.source = json.text("source");
  const auto planes = json.objects("aircraft");
  json.check(!planes.empty(), "aircraft", "is empty. Name at least one aircraft with its cases");
  std::set<std::string> names;
  for (const auto& plane : planes) {
    plane.check(names.insert(plane.text("aircraft")).second, "aircraft",
                "is listed twice. Put all its cases under one entry");
    read_aircraft(plane, fleet);
  }
  fleet.floor_speed = json.quantity("floor_speed", dimension::speed, 0.0);
  json.check(fleet.floor_speed >= 0, "floor_speed", "is negative");
  for (const auto& each : fleet.cases)
    json.check(each.overrun.entry_speed >= fleet.floor_speed, "floor_speed",
               concat("contradicts the case \"", each.aircraft, ", ", each.name,
                      "\": the speed it shall be stopped from is lower than the floor"));
  if (json.has("limits")) fleet.limits = read_limits(json.object("limits"));
  fleet.bed = read_bed(json.object("bed"));
  json.finish();
  return fleet;
}

Fleet load_fleet(const std::filesystem::path& path) { return read_fleet(read_json(path)); }

bool counts(const Limits& limits, const std::string& gear, const std::string& load) {
  const auto name = std::string(gear == "nose" ? "nose " : "main ") + load;
  return limits.loads.empty() || std::find(limits.loads.begin(), limits.loads.end(), name) != limits.loads.end();
}

std::string counted_loads(const Limits& limits) {
  std::string out;
  for (const auto& load : limits.loads) out += (out.empty() ? "" : ", ") + load;
  return out.empty() ? "all known gear loads" : out;
}

std::vector<std::string> aircraft_names(const Fleet& fleet) {
  std::vector<std::string> names;
  for (const auto& each : fleet.cases)
    if (std::find(names.begin(), names.end(), each.aircraft) == names.end()) names.push_back(each.aircraft);
  return names;
}

}  // namespace apc::design
