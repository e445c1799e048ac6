/// The only reader of "apc-tire/1".
#include <numbers>

#include "aircraft/aircraft.h"
#include "apc/base/json.h"
#include "apc/base/require.h"

namespace apc::aircraft {
namespace {

void check_positive(const Json& json, const std::string& key, double value) {
  json.check(value > 0.0, key, "must be positive");
}

MonotoneCurve load_curve(const Json& json, const Tire& tire) {
  if (!json.has("curve"))
    return {{0.0, tire.rated_deflection, tire.bottoming_deflection}, {0.0, tire.rated_load, tire.bottoming_load}};
  const auto curve = json.object("curve");
  const auto deflection = curve.quantities("deflection", dimension::length);
  const auto load = curve.quantities("load", dimension::force);
  curve.check(
      deflection.size() == load.size(), "load",
      concat("has ", load.size(), " values for ", deflection.size(), " deflections. Give one load per deflection"));
  curve.check(deflection.size() >= 2 && deflection.front() == 0.0 && load.front() == 0.0, "deflection",
              "must start at zero load and zero deflection and hold at least two points");
  for (std::size_t i = 1; i < load.size(); ++i)
    curve.check(deflection[i] > deflection[i - 1] && load[i] > load[i - 1], "load",
                "must increase strictly with the deflection: a tire that is pressed deeper carries more");
  return {deflection, load};
}

Tire read_tire(const Json& json, const std::string& library_source) {
  Tire tire;
  tire.name = json.text("name");
  tire.source = library_source.empty() ? json.text("source") : json.text("source", library_source);
  tire.diameter = json.quantity("diameter", dimension::length);
  tire.width = json.quantity("width", dimension::length);
  tire.rim_diameter = json.quantity("rim_diameter", dimension::length);
  tire.inflation = json.quantity("inflation", dimension::pressure);
  tire.rated_load = json.quantity("rated_load", dimension::force);
  tire.rated_deflection = json.quantity("rated_deflection", dimension::length);
  tire.bottoming_load = json.quantity("bottoming_load", dimension::force);
  tire.bottoming_deflection = json.quantity("bottoming_deflection", dimension::length);
  json.ignore("sources");
  check_positive(json, "width", tire.width);
  check_positive(json, "rim_diameter", tire.rim_diameter);
  check_positive(json, "inflation", tire.inflation);
  check_positive(json, "rated_load", tire.rated_load);
  check_positive(json, "rated_deflection", tire.rated_deflection);
  json.check(tire.diameter > tire.rim_diameter, "diameter", "is not larger than the rim: there is no tire");
  json.check(tire.bottoming_load > tire.rated_load, "bottoming_load",
             "must exceed the rated load: the tire would bottom at its rated load");
  json.check(tire.bottoming_deflection > tire.rated_deflection, "bottoming_deflection",
             "must exceed the rated deflection");
  json.check(tire.bottoming_deflection < tire.radius(), "bottoming_deflection",
             "reaches the axle: it must be smaller than half the diameter");
  tire.load_curve = load_curve(json, tire);
  return tire;
}

}  // namespace

TireLibrary load_tires(const std::filesystem::path& path) {
  const auto file = read_json(path);
  file.schema("apc-tire/1");
  TireLibrary library;
  if (!file.has("tires")) {
    auto tire = read_tire(file, "");
    library.emplace(tire.name, tire);
  } else {
    const auto source = file.text("source");
    file.text("name", "");
    for (const auto& each : file.objects("tires")) {
      auto tire = read_tire(each, source);
      each.check(!library.contains(tire.name), "name", "is given twice. Give every tire a name of its own");
      library.emplace(tire.name, std::move(tire));
    }
  }
  file.finish();
  return library;
}

}  // namespace apc::aircraft
