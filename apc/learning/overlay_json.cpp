#include "apc/learning/overlay_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/base/json.h"
#include "apc/base/units.h"
#include "apc/effects/effect_json.h"
#include "apc/learning/quantity_json.h"

namespace apc::learning {
namespace {

using nlohmann::ordered_json;

ordered_json applied_json(const std::vector<effects::Applied>& list) {
  ordered_json result = ordered_json::array();
  for (const auto& applied : list) {
    ordered_json parameters;
    for (std::size_t k = 0; k < applied.values.size(); ++k)
      parameters[applied.effect.parameters[k].name] = quantity(applied.values[k], applied.effect.parameters[k].unit);
    ordered_json one = {{"id", applied.effect.id}, {"parameters", parameters}};
    if (!applied.effect.form.empty()) one["form"] = applied.effect.form;
    result.push_back(std::move(one));
  }
  return result;
}

/// Lowest and highest of two quantities.
std::array<double, 2> range_of(const Json& on, const char* key, const Dimension& dimension) {
  const auto values = on.quantities(key, dimension);
  on.check(values.size() == 2 && values[0] <= values[1], key,
           R"(needs two values, lowest and highest, such as ["40 kt", "70 kt"])");
  return {values[0], values[1]};
}

double strength_in(const Json& file, const char* key, double otherwise) {
  if (!file.has(key)) return otherwise;
  const double factor = file.number(key);
  file.check(factor > 0.3 && factor < 3.0, key, "is a factor on the bed's strength, near 1");
  return factor;
}

}  // namespace

std::string overlay_json(const Study& study, const std::string& command) {
  const Background& b = study.background;
  double slow = 1e9, fast = 0.0, light = 1e9, heavy = 0.0;
  ordered_json runs = ordered_json::array();
  for (std::size_t r = 0; r < b.training; ++r) {
    const auto& o = b.runs[r].overrun;
    slow = std::min(slow, o.entry_speed), fast = std::max(fast, o.entry_speed), light = std::min(light, o.mass),
    heavy = std::max(heavy, o.mass);
    runs.push_back(b.runs[r].id);
  }
  ordered_json file = {{"schema", "apc-model/1"},
                       {"source", "learned from " + b.data->title},
                       {"effects", applied_json(study.diagnosis.augmented)}};
  if (study.free) {
    file["bed_strength"] = quantity(std::exp(study.strength), "");
    file["bed_strength_without_effects"] = quantity(std::exp(study.free->none.strength), "");
  }
  file["learned_on"] = {{"runs", runs},
                        {"speed", {quantity(slow, "kt"), quantity(fast, "kt")}},
                        {"mass", {quantity(light, "kg"), quantity(heavy, "kg")}}};
  file["verdict"] = text(study.diagnosis.verdict);
  file["command"] = command;
  return file.dump(1) + "\n";
}

Overlay load_overlay(const std::filesystem::path& path, const std::vector<effects::Effect>& known) {
  const Json file = read_json(path);
  file.schema("apc-model/1");
  file.text("source");
  for (const auto* key : {"verdict", "command"}) file.ignore(key);
  Overlay overlay;
  overlay.bed_strength = strength_in(file, "bed_strength", 1.0);
  overlay.bed_strength_without_effects = strength_in(file, "bed_strength_without_effects", 1.0);
  if (file.has("learned_on")) {
    const Json on = file.object("learned_on");
    on.ignore("runs");
    const auto speed = range_of(on, "speed", dimension::speed), mass = range_of(on, "mass", dimension::mass);
    overlay.slowest = speed[0], overlay.fastest = speed[1], overlay.lightest = mass[0], overlay.heaviest = mass[1];
  }
  overlay.effects = effects::read_applied(file.objects("effects"), known);
  file.finish();
  return overlay;
}

}  // namespace apc::learning
