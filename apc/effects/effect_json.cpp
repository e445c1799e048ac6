#include "apc/effects/effect_json.h"

#include <algorithm>
#include <array>

#include "apc/base/require.h"
#include "apc/effects/catalogue.h"
#include "apc/effects/formula.h"
#include "apc/effects/other_forms.h"

namespace apc::effects {
namespace {

constexpr std::size_t state_names = 12;

std::vector<FormulaName> names_with(const std::vector<Parameter>& parameters) {
  std::vector<FormulaName> names = {
      {"v", dimension::speed}, {"p", dimension::length},      {"s", dimension::length},   {"h", dimension::length},
      {"t", dimension::time},  {"b", dimension::length},      {"R", dimension::length},   {"rho", dimension::density},
      {"W", dimension::force}, {"T", dimension::temperature}, {"years", dimension::none}, {"x", dimension::length}};
  for (const Parameter& parameter : parameters) names.push_back({parameter.name, parameter.dimension});
  return names;
}

double evaluate(const Formula& formula, const TireState& state, Values q) {
  std::array<double, 24> values{state.speed,    state.penetration, state.bed_distance, state.bed_depth,
                                state.time,     state.tire_width,  state.tire_radius,  state.density,
                                state.vertical, state.temperature, state.years,        state.nose_distance};
  std::copy(q.begin(), q.end(), values.begin() + state_names);
  return formula(values.data());
}

}  // namespace

Effect read_own_effect(const Json& file) {
  file.schema("apc-effect/1");
  Effect effect;
  effect.own = true;
  effect.id = file.text("id");
  for (const Effect& e : catalogue())
    file.check(e.id != effect.id, "id", "is the name of a shipped effect. Choose another.");
  effect.title = file.text("title", effect.id);
  effect.source = file.text("source");
  const std::string acts_on = file.text("acts_on"), formula_text = file.text("formula");
  effect.law = (acts_on == "strength" ? "strength × (1 + " : "Δ" + acts_on + " = ") + formula_text +
               (acts_on == "strength" ? ")" : "");
  const Json parameters = file.object("parameters");
  const auto keys = parameters.keys();
  file.check(!keys.empty() && keys.size() <= 12, "parameters",
             "must hold 1 to 12 parameters; the first is the amplitude.");
  for (const std::string& name : keys) {
    const Json entry = parameters.object(name);
    Parameter parameter;
    parameter.name = name;
    parameter.unit = entry.text("unit", "");
    Unit unit;
    try {
      if (!parameter.unit.empty()) unit = parse_unit(parameter.unit);
    } catch (const InputError& error) {
      entry.refuse("unit", error.what());
    }
    parameter.dimension = unit.dimension;
    parameter.low = entry.number("low") * unit.factor;
    parameter.high = entry.number("high") * unit.factor;
    parameter.usual = entry.number("usual", 0.5 * (entry.number("low") + entry.number("high"))) * unit.factor;
    entry.check(parameter.low < parameter.high, "high", "must be larger than low.");
    effect.parameters.push_back(parameter);
  }
  file.check(acts_on == "drag" || acts_on == "vertical" || acts_on == "strength", "acts_on",
             "must be drag, vertical or strength.");
  try {
    const Formula formula(formula_text, names_with(effect.parameters),
                          acts_on == "strength" ? dimension::none : dimension::force);
    if (acts_on == "strength")
      effect.bed = [formula](const TireState& state, Values q, TireChange& change) {
        change.strength *= 1.0 + evaluate(formula, state, q);
      };
    else if (acts_on == "drag")
      effect.force = [formula](const TireState& state, Values q, TireChange& change) {
        change.drag += evaluate(formula, state, q) * in_bed(state.bed_depth);
      };
    else
      effect.force = [formula](const TireState& state, Values q, TireChange& change) {
        change.vertical += evaluate(formula, state, q) * in_bed(state.bed_depth);
      };
  } catch (const InputError& error) {
    file.refuse("formula", error.what());
  }
  file.finish();
  return effect;
}

Effect load_own_effect(const std::filesystem::path& path) { return read_own_effect(read_json(path)); }

std::vector<Applied> read_applied(const std::vector<Json>& entries, const std::vector<Effect>& known) {
  std::vector<Applied> result;
  for (const Json& entry : entries) {
    const std::string id = entry.text("id");
    const std::string form = entry.text("form", "");
    const std::vector<Effect>& laws = form.empty() ? known : other_forms();
    const auto found =
        std::find_if(laws.begin(), laws.end(), [&](const Effect& e) { return e.id == id && e.form == form; });
    entry.check(found != laws.end() || !form.empty(), "id",
                "is no effect of the catalogue or of this file. 'apc effects list' shows them.");
    entry.check(found != laws.end(), "form", "is no form of this effect. 'apc effects list' shows them.");
    Applied one{*found, {}};
    const Json parameters = entry.object("parameters");
    for (const Parameter& parameter : found->parameters)
      one.values.push_back(parameters.quantity(parameter.name, parameter.dimension, parameter.usual));
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace apc::effects
