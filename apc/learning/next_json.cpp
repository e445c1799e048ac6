#include "apc/learning/next_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/base/json.h"
#include "apc/effects/effect_json.h"

namespace apc::learning {
namespace {

using nlohmann::ordered_json;

/// Five digits: more would be noise.
ordered_json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return std::stod(text);
}

ordered_json expectation_json(const Expectation& e, const std::string& name) {
  return {{"explanation", name},
          {"stop_distance", rounded(e.stop)},
          {"exit_speed", rounded(e.exit_speed)},
          {"peak_deceleration", rounded(e.peak_deceleration)},
          {"mean_deceleration", rounded(e.mean_deceleration)},
          {"peak_nose_drag", rounded(e.peak_nose_drag)},
          {"mean_nose_drag", rounded(e.mean_nose_drag)},
          {"nose_rut", rounded(e.nose_rut)},
          {"main_rut", rounded(e.main_rut)}};
}

ordered_json candidate_json(const NextPlan& plan, const CandidateRun& c) {
  ordered_json expects = ordered_json::array();
  for (std::size_t i = 0; i < c.expects.size(); ++i)
    expects.push_back(expectation_json(c.expects[i], plan.contenders[i].name()));
  ordered_json separation = ordered_json::array();
  for (const double s : c.separation) separation.push_back(rounded(s));
  return {{"speed", rounded(c.speed)}, {"mass", rounded(c.mass)},  {"simulated", c.simulated},
          {"stops", c.stops},          {"separation", separation}, {"expects", expects}};
}

}  // namespace

std::string next_json(const NextPlan& plan) {
  ordered_json file = {{"schema", "apc-next/1"},
                       {"purpose", plan.sharpens ? "sharpen" : "separate"},
                       {"explanations", ordered_json::array()},
                       {"sensor_sets", ordered_json::array()},
                       {"next", ordered_json::array()},
                       {"runs", ordered_json::array()}};
  for (const Contender& c : plan.contenders) {
    ordered_json parameters = ordered_json::object();
    for (const auto& applied : c.effects)
      for (std::size_t k = 0; k < applied.values.size(); ++k)
        parameters[applied.effect.id + "." + applied.effect.parameters[k].name] = rounded(applied.values[k]);
    file["explanations"].push_back({{"name", c.name()}, {"parameters", parameters}, {"misfit", rounded(c.misfit)}});
  }
  for (const SensorSet& set : plan.sets) file["sensor_sets"].push_back(set.names());
  if (plan.sharpens) file["separation_now"] = rounded(plan.sharpness_now);
  for (std::size_t i = 0; i < plan.best.size(); ++i) {
    const CandidateRun& c = plan.candidates[plan.best[i]];
    ordered_json one = {{"speed", rounded(c.speed)},
                        {"mass", rounded(c.mass)},
                        {"sensors", plan.sets[plan.best_set[i]].names()},
                        {"separation", rounded(c.separation[plan.best_set[i]])}};
    if (!plan.sharpens) one["hardest"] = {plan.contenders[c.a].name(), plan.contenders[c.b].name()};
    file["next"].push_back(one);
  }
  file["inseparable"] = ordered_json::array();
  for (std::size_t p = 0; p < plan.hopeless.size(); ++p)
    if (plan.hopeless[p])
      file["inseparable"].push_back(
          {plan.contenders[plan.pairs[p][0]].name(), plan.contenders[plan.pairs[p][1]].name()});
  for (const CandidateRun& c : plan.candidates) file["runs"].push_back(candidate_json(plan, c));
  return file.dump(1) + "\n";
}

std::vector<std::vector<effects::Applied>> contenders_of_file(const std::filesystem::path& path,
                                                              const std::vector<effects::Effect>& known) {
  const Json file = read_json(path);
  file.schema("apc-diagnosis/1");
  // Nothing, or an instrument: the bed stands as it is, and the next run should see smaller effects.
  const std::string verdict = file.text("verdict", "");
  if (verdict == "nothing" || verdict == "sensor") return {{}};
  const auto claims = effects::read_applied(file.objects("effects"), known);
  file.check(file.has("set90") && file.raw().at("set90").is_array(), "set90",
             R"(needs the explanations that stand, such as [["seams"], ["seams", "debris"], []])");
  std::vector<std::vector<std::string>> set90;
  for (const auto& member : file.raw().at("set90")) {
    file.check(member.is_array(), "set90", R"(: every member is a list of effects, such as ["seams"])");
    std::vector<std::string>& ids = set90.emplace_back();
    for (const auto& id : member) {
      file.check(id.is_string(), "set90", R"(: an effect is named by its id, such as "seams")");
      ids.push_back(id.get<std::string>());
    }
  }
  std::vector<Rival> rivals;
  if (file.has("rivals"))
    for (const Json& r : file.objects("rivals"))
      rivals.push_back({r.text("a"), r.text("b"), r.number("correlation"), r.number("separability")});
  return contenders_of(set90, rivals, claims, known);
}

}  // namespace apc::learning
