/// Schema "apc-scatter/1": any of the numbers of Scatter, with a source.
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/reliability/scatter.h"

namespace apc::reliability {
namespace {

double share(const Json& json, const std::string& key, double otherwise, double most) {
  const double value = json.number(key, otherwise);
  json.check(value >= 0 && value <= most, key, concat("is outside 0 to ", most));
  return value;
}

/// `[low, high]` within 0 to `most`.
void range(const Json& json, const std::string& key, double most, const std::string& example, double& low,
           double& high) {
  if (!json.has(key)) return;
  const auto ends = json.numbers(key);
  json.check(ends.size() == 2 && ends[0] >= 0 && ends[1] >= ends[0] && ends[1] <= most, key,
             concat("is no range within 0 to ", most, ": write two numbers, such as ", example));
  low = ends[0], high = ends[1];
}

}  // namespace

Scatter read_scatter(const Json& json) {
  json.schema("apc-scatter/1");
  Scatter out;
  out.source = json.text("source");
  out.mass = share(json, "mass", out.mass, 0.3), out.cg = share(json, "cg", out.cg, 0.1);
  out.strength = share(json, "strength", out.strength, 0.3), out.depth = share(json, "depth", out.depth, 0.3);
  out.block_strength = share(json, "block_strength", out.block_strength, 0.5);
  out.correlation = json.quantity("correlation", dimension::length, out.correlation);
  json.check(out.correlation > 0, "correlation", "is not above 0");
  range(json, "braking", 1.0, "[0, 0.25]", out.braking_low, out.braking_high);
  out.temperature = json.quantity("temperature", dimension::temperature, out.temperature);
  out.temperature_scatter = json.quantity("temperature_scatter", dimension::temperature, out.temperature_scatter);
  json.check(out.temperature_scatter >= 0 && out.temperature_scatter <= 50, "temperature_scatter",
             "is no standard deviation of a temperature: write kelvins, such as \"12 K\"");
  out.per_kelvin = share(json, "per_kelvin", out.per_kelvin, 0.02);
  out.per_year = share(json, "per_year", out.per_year, 0.05);
  range(json, "years", 100.0, "[0, 20]", out.years_low, out.years_high);
  json.check(out.per_year * out.years_high < 0.9, "years",
             "with this \"per_year\" leave nothing of the bed's strength");
  json.finish();
  return out;
}

Scatter load_scatter(const std::filesystem::path& path) { return read_scatter(read_json(path)); }

}  // namespace apc::reliability
