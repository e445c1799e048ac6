#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "loadtables/plan.h"

namespace apc::loadtables {
namespace {

using Value = nlohmann::ordered_json;

/// Sixteen digits: a plan read back is the plan that was written.
std::string written(double value, const char* unit) { return fmt::format("{:.16g} {}", value, unit); }

Value range(const std::array<double, 2>& values, const char* unit) {
  return {{"unit", unit}, {"values", {values[0], values[1]}}};
}

std::array<double, 2> read_range(const Json& json, const std::string& key, const Dimension& dimension) {
  const auto values = json.quantities(key, dimension);
  json.check(values.size() == 2, key, "is not a lowest and a highest value");
  return {values[0], values[1]};
}

}  // namespace

void write_plan(const Plan& plan, const std::filesystem::path& folder) {
  const auto& tire = plan.tire;
  const auto& options = plan.options;
  Value json{{"schema", "apc-load-plan/1"}, {"material", plan.material}};
  json["tire"] = {{"name", tire.name},
                  {"diameter", written(tire.diameter, "m")},
                  {"width", written(tire.width, "m")},
                  {"rated_load", written(tire.rated_load, "N")},
                  {"rated_deflection", written(tire.rated_deflection, "m")},
                  {"bottoming_load", written(tire.bottoming_load, "N")},
                  {"bottoming_deflection", written(tire.bottoming_deflection, "m")},
                  {"curve",
                   {{"deflection", {{"unit", "m"}, {"values", tire.curve_deflection}}},
                    {"load", {{"unit", "N"}, {"values", tire.curve_load}}}}}};
  json["design"] = {{"runs", options.runs},
                    {"seed", options.seed},
                    {"speed", range(options.speed, "m/s")},
                    {"bed_depth", range(options.bed_depth, "m")},
                    {"relative_penetration", {options.relative_penetration[0], options.relative_penetration[1]}},
                    {"depth_increment", written(options.depth_increment, "m")}};
  json["runs"] = Value::array();
  for (const auto& run : plan.runs)
    json["runs"].push_back({{"id", run.id},
                            {"speed", written(run.contact.speed, "m/s")},
                            {"bed_depth", written(run.contact.bed_depth, "m")},
                            {"penetration", written(run.contact.penetration, "m")},
                            {"relative_penetration", run.relative_penetration}});
  write_text(folder / "plan.json", json.dump(1) + "\n");
}

Plan read_plan(const std::filesystem::path& folder) {
  std::error_code error;
  require(std::filesystem::is_regular_file(folder / "plan.json", error), folder.string(),
          ": holds no plan.json. Make a plan first: apc loads plan --tire T --material M -o ", folder.string());
  const auto json = read_json(folder / "plan.json");
  json.schema("apc-load-plan/1");
  Plan plan;
  plan.material = json.text("material");
  const auto tire = json.object("tire");
  plan.tire.name = tire.text("name");
  for (const auto& [key, value] : {std::pair{"diameter", &plan.tire.diameter},
                                   {"width", &plan.tire.width},
                                   {"rated_deflection", &plan.tire.rated_deflection},
                                   {"bottoming_deflection", &plan.tire.bottoming_deflection}})
    *value = tire.quantity(key, dimension::length);
  plan.tire.rated_load = tire.quantity("rated_load", dimension::force);
  plan.tire.bottoming_load = tire.quantity("bottoming_load", dimension::force);
  const auto curve = tire.object("curve");
  plan.tire.curve_deflection = curve.quantities("deflection", dimension::length);
  plan.tire.curve_load = curve.quantities("load", dimension::force);

  const auto design = json.object("design");
  plan.options.seed = static_cast<unsigned>(design.integer("seed"));
  plan.options.speed = read_range(design, "speed", dimension::speed);
  plan.options.bed_depth = read_range(design, "bed_depth", dimension::length);
  const auto ratios = design.numbers("relative_penetration");
  design.check(ratios.size() == 2, "relative_penetration", "is not a lowest and a highest value");
  plan.options.relative_penetration = {ratios[0], ratios[1]};
  plan.options.depth_increment = design.quantity("depth_increment", dimension::length);
  for (const auto& each : json.objects("runs")) {
    PlannedRun run;
    run.id = each.integer("id");
    run.contact = {each.quantity("speed", dimension::speed), each.quantity("bed_depth", dimension::length),
                   each.quantity("penetration", dimension::length)};
    run.relative_penetration = each.number("relative_penetration");
    each.check(run.contact.speed > 0.0, "speed", "is not positive");
    each.check(run.contact.bed_depth > 0.0 && run.contact.bed_depth <= 3.0, "bed_depth", "is not between 0 and 3 m");
    each.check(run.contact.penetration > 0.0, "penetration", "is not positive");
    each.check(run.id == static_cast<int>(plan.runs.size()) + 1, "id", "is out of order. Runs count from 1");
    plan.runs.push_back(run);
  }
  plan.options.runs = design.integer("runs", static_cast<int>(plan.runs.size()));
  json.check(!plan.runs.empty(), "runs", "is empty");
  json.finish();
  return plan;
}

}  // namespace apc::loadtables
