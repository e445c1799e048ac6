#include "apc/learning/diagnosis_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/base/csv.h"
#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/effects/effect_json.h"
#include "apc/learning/quantity_json.h"

namespace apc::learning {
namespace {

using nlohmann::ordered_json;

ordered_json claim_json(const Claim& claim) {
  ordered_json parameters, interval, work;
  for (std::size_t k = 0; k < claim.applied.values.size(); ++k) {
    const effects::Parameter& p = claim.applied.effect.parameters[k];
    parameters[p.name] = quantity(claim.applied.values[k], p.unit);
    if (k < claim.deviation.size() && std::isfinite(claim.deviation[k]))
      interval[p.name] = {quantity(claim.applied.values[k] - 1.96 * claim.deviation[k], p.unit),
                          quantity(claim.applied.values[k] + 1.96 * claim.deviation[k], p.unit)};
  }
  for (const auto& [run, energy] : claim.work) work[run] = short_number(energy / units::kJ) + " kJ";
  ordered_json result = {{"id", claim.id},
                         {"probability", std::stod(short_number(claim.probability))},
                         {"p_family_wise", std::stod(short_number(claim.p_family_wise))},
                         {"parameters", parameters},
                         {"interval95", interval},
                         {"work", work}};
  if (const std::string& form = claim.applied.effect.form; !form.empty()) result["form"] = form;
  return result;
}

/// Time, distance and the channels of one free run, instruments at their prior mean.
std::string prediction_csv(const Background& b, std::size_t r, const Eigen::VectorXd& eta,
                           const std::vector<effects::Applied>& added) {
  const Run& run = b.runs[r];
  const Trace trace = simulate_run(*b.data, b.layout, r, run, eta, added);
  const auto& h = trace.result.history;
  std::vector<CsvColumn> columns = {{"time", "s", {}}, {"nose_distance", "m", {}}};
  for (std::size_t i = 0; i < h.time.size(); ++i) {
    if (h.time[i] < -0.5) continue;
    columns[0].values.push_back(h.time[i]);
    columns[1].values.push_back(h.distance[i]);
  }
  for (const Channel& channel : run.channels) {
    const Signal signal(h, channel, b.data->aircraft);
    const Unit unit = channel.unit.empty() ? Unit{} : parse_unit(channel.unit);
    CsvColumn column{channel.column, channel.unit, {}};
    for (const double time : columns[0].values)
      column.values.push_back((signal(time - 0.8 * channel.lag) - unit.offset) / unit.factor);
    columns.push_back(std::move(column));
  }
  std::map<std::string, std::string> remarks;
  if (trace.result.exit_speed <= 0.0) remarks["stop_distance"] = short_number(trace.stop) + " m";
  return csv_text(remarks, columns, 6);
}

}  // namespace

std::string diagnosis_json(const Study& study) {
  const Diagnosis& d = study.diagnosis;
  ordered_json file = {{"schema", "apc-diagnosis/1"}, {"verdict", text(d.verdict)}, {"effects", ordered_json::array()}};
  const bool speaks = d.verdict != Verdict::nothing && d.verdict != Verdict::sensor;
  for (const Claim& claim : d.claims)
    if (speaks || claim.probability < 0.5) file["effects"].push_back(claim_json(claim));
  file["set90"] = d.set90;
  file["rivals"] = ordered_json::array();
  for (const Rival& r : d.rivals)
    file["rivals"].push_back({{"a", r.a},
                              {"b", r.b},
                              {"correlation", std::stod(short_number(r.correlation))},
                              {"separability", std::stod(short_number(r.separability))}});
  if (!study.held_out.runs.empty()) {
    ordered_json runs = ordered_json::array(), gain = ordered_json::array();
    for (const LeftOut& one : study.held_out.runs) {
      runs.push_back(one.run);
      gain.push_back(std::stod(short_number(one.gain)));
    }
    file["held_out"] = {{"base", std::stod(short_number(study.held_out.before))},
                        {"augmented", std::stod(short_number(study.held_out.after))},
                        {"runs", runs},
                        {"delta_elpd", gain}};
  }
  file["smallest_detectable"] = ordered_json::object();
  for (const auto& [name, value] : d.smallest_detectable)
    file["smallest_detectable"][name] = std::stod(short_number(value));
  file["unexplained_share"] = std::stod(short_number(d.unexplained_share));
  file["learned"] = d.learned.empty() ? ordered_json(nullptr) : ordered_json(d.learned);
  file["sensors"] = ordered_json::object();
  for (std::size_t i = 0; i < std::min<std::size_t>(5, d.sensors.size()); ++i) {
    const SensorClaim& s = d.sensors[i];
    file["sensors"][s.run.empty() ? "all" : s.run][s.what] = short_number(s.value) + " +- " + short_number(s.deviation);
  }
  file["next"] = ordered_json::array();
  for (const NextRun& n : d.next) {
    ordered_json sensors = ordered_json::array();
    for (const Quantity q : n.sensors) sensors.push_back(name_of(q));
    file["next"].push_back({{"speed", short_number(n.speed / units::kt) + " kt"},
                            {"mass", short_number(n.mass) + " kg"},
                            {"sensors", sensors},
                            {"survey", n.survey},
                            {"separation", std::stod(short_number(n.separation))}});
  }
  file["explanations"] = ordered_json::array();
  for (std::size_t i = 0; i < std::min<std::size_t>(12, d.explanations.size()); ++i) {
    const Explanation& x = d.explanations[i];
    file["explanations"].push_back({{"effects", x.ids},
                                    {"label", x.label},
                                    {"log_evidence", std::stod(short_number(x.log_evidence))},
                                    {"free_evidence", std::stod(short_number(x.free_evidence))},
                                    {"probability", std::stod(short_number(x.probability))}});
  }
  file["data_remarks"] = ordered_json::array();
  for (const DataRemark& r : study.background.data->remarks)
    file["data_remarks"].push_back(r.run + (r.channel.empty() ? "" : " " + r.channel) + ": " + r.text);
  file["seconds"] = std::stod(short_number(d.seconds));
  return file.dump(1) + "\n";
}

std::vector<effects::Applied> effects_of_diagnosis(const std::filesystem::path& path,
                                                   const std::vector<effects::Effect>& known) {
  const Json file = read_json(path);
  file.schema("apc-diagnosis/1");
  const std::string verdict = file.text("verdict");
  if (verdict == "nothing" || verdict == "sensor") return {};
  std::vector<Json> chosen;
  for (const Json& effect : file.objects("effects"))
    if (effect.number("probability") >= 0.5 || chosen.empty()) chosen.push_back(effect);
  return effects::read_applied(chosen, known);
}

void write_predictions(const Study& study, const std::filesystem::path& folder) {
  const Background& b = study.background;
  // Both are the nominal model with one strength for the bed; the effects are what is between them. Effects that do not
  // help runs they were not fitted to are left out.
  const auto nominal = [&](double strength) {
    Eigen::VectorXd eta = prior_mean(b.layout, b.runs);
    eta[b.layout.bed_strength] = strength;
    return eta;
  };
  for (std::size_t r = b.training; r < b.runs.size(); ++r) {
    const std::string base = prediction_csv(b, r, nominal(study.free ? study.free->none.strength : 0.0), {});
    write_text(folder / (b.runs[r].id + ".base.csv"), base);
    write_text(
        folder / (b.runs[r].id + ".augmented.csv"),
        study.held_out.helps() ? prediction_csv(b, r, nominal(study.strength), study.diagnosis.augmented) : base);
  }
}

}  // namespace apc::learning
