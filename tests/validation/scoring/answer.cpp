#include "answer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apc/base/csv.h"
#include "apc/base/quantity.h"
#include "apc/base/require.h"

namespace scoring {
namespace {

using nlohmann::json;

double number(const json& value) {
  if (value.is_number()) return value.get<double>();
  return value.is_string() ? si(value.get<std::string>()) : std::nan("");
}

json read(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) return {};
  return json::parse(file, nullptr, false);
}

}  // namespace

std::set<std::string> Truth::ids() const {
  std::set<std::string> result;
  for (const TrueEffect& e : effects) result.insert(e.id);
  return result;
}

double si(const std::string& text) {
  std::size_t end = 0;
  double value = 0.0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    return std::nan("");
  }
  while (end < text.size() && text[end] == ' ') ++end;
  if (end == text.size()) return value;
  const apc::Unit unit = apc::parse_unit(text.substr(end));
  return value * unit.factor + unit.offset;
}

Answer read_answer(const std::filesystem::path& folder, const std::string& name) {
  Answer answer;
  json file = read(folder / name / "diagnosis.json");
  if (!file.is_object()) file = read(folder / (name + ".json"));
  if (!file.is_object() || !file.contains("verdict")) return answer;
  answer.readable = true;
  answer.verdict = file["verdict"];
  for (const json list = file.value("effects", json::array()); const json& e : list) {
    Claim claim;
    claim.id = e.value("id", "");
    claim.probability = e.value("probability", 0.0);
    for (const json part = e.value("parameters", json::object()); const auto& [key, value] : part.items())
      claim.parameters[key] = number(value);
    for (const json part = e.value("interval95", json::object()); const auto& [key, value] : part.items())
      claim.interval[key] = {number(value[0]), number(value[1])};
    for (const json part = e.value("work", json::object()); const auto& [key, value] : part.items())
      claim.work[key] = number(value);
    answer.effects.push_back(claim);
  }
  std::stable_sort(answer.effects.begin(), answer.effects.end(),
                   [](const Claim& a, const Claim& b) { return a.probability > b.probability; });
  if (file.contains("set90")) {
    for (const json& member : file["set90"]) answer.set90.push_back(member.get<std::set<std::string>>());
  } else {
    std::set<std::string> likely;
    for (const Claim& c : answer.effects)
      if (c.probability >= 0.5) likely.insert(c.id);
    answer.set90.push_back(likely);
  }
  if (file.contains("seconds")) answer.seconds = file["seconds"].get<double>();
  return answer;
}

Truth read_truth(const std::filesystem::path& folder) {
  const json file = read(folder / "truth" / "truth.json"), oracle = read(folder / "truth" / "oracle.json");
  Truth truth;
  truth.name = folder.filename().string();
  truth.kind = file.at("class");
  truth.verdict = file.at("verdict");
  truth.remark = file.value("remark", "");
  truth.decidable = oracle.value("decidable", false);
  for (const json& e : file.at("effects")) {
    TrueEffect effect;
    effect.id = e.at("id");
    effect.law = e.value("law", "");
    effect.amplitude = e.value("amplitude", "");
    for (const auto& [key, value] : e.at("parameters").items()) effect.parameters[key] = number(value);
    for (const json list = oracle.value("effects", json::array()); const json& o : list)
      if (o.at("id") == effect.id)
        effect.detectability = o.at("detectability"), effect.after_worst_rival = o.at("after_worst_rival");
    truth.effects.push_back(effect);
  }
  for (const json part = oracle.value("work", json::object()); const auto& [run, work] : part.items())
    for (const auto& [id, value] : work.items()) truth.work[run][id] = number(value);
  for (const json part = oracle.value("held_out_error", json::object()); const auto& [run, error] : part.items())
    if (error.contains("base")) truth.held[run] = {error["base"], error["ideal"]};
  return truth;
}

namespace {

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto after = std::upper_bound(x.begin(), x.end(), at);
  if (after == x.begin()) return y.front();
  if (after == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(after - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / std::max(1e-12, x[i] - x[i - 1]);
}

/// Finite samples only.
std::pair<std::vector<double>, std::vector<double>> samples(const std::vector<double>& x,
                                                            const std::vector<double>& y) {
  std::pair<std::vector<double>, std::vector<double>> result;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i])) result.first.push_back(x[i]), result.second.push_back(y[i]);
  return result;
}

}  // namespace

double held_error(const std::filesystem::path& folder, const std::filesystem::path& prediction,
                  const std::string& run) {
  if (!std::filesystem::exists(prediction)) return std::nan("");
  const apc::CsvTable data = apc::read_csv(folder / "truth" / "held" / (run + ".csv"));
  const apc::CsvTable track = apc::read_csv(folder / "truth" / "held" / (run + "_track.csv"));
  const apc::CsvTable model = apc::read_csv(prediction);
  const json conditions = read(folder / "truth" / "held" / (run + ".json")),
             wanted = read(folder / "held" / (run + ".json"));
  const auto track_time = track.column("time", apc::dimension::time),
             track_speed = track.column("speed", apc::dimension::speed);
  const auto track_distance = track.find("nose_distance") ? track.column("nose_distance", apc::dimension::length)
                                                          : track.column("distance", apc::dimension::length);
  const auto model_time = model.column("time", apc::dimension::time),
             model_distance = model.column("nose_distance", apc::dimension::length);
  std::vector<double> squares;
  for (const auto& [header, channel] : wanted.at("channels").items()) {
    const std::string quantity = channel.at("quantity");
    if (quantity != "speed" && quantity != "acceleration_x") continue;
    const std::string column = header.substr(0, header.find(" ["));
    const apc::Dimension dimension = quantity == "speed" ? apc::dimension::speed : apc::dimension::acceleration;
    const auto measured = samples(data.column("time", apc::dimension::time), data.column(column, dimension));
    const auto predicted = samples(model_distance, model.column(column, dimension));
    const double noise = si(channel.at("noise"));
    double low = 1e300, high = -1e300, sum = 0.0;
    for (const double v : measured.second) low = std::min(low, v), high = std::max(high, v);
    const double s = std::max(noise, 0.02 * (high - low));
    int count = 0;
    for (std::size_t i = 0; i < measured.first.size(); ++i) {
      const double time = measured.first[i];
      if (time < 0.0 || time > track_time.back() || interpolate(track_time, track_speed, time) < 3.0) continue;
      const double place = interpolate(track_time, track_distance, time);
      ++count;
      if (predicted.first.empty() || place > predicted.first.back()) {
        sum += 25.0;
        continue;
      }
      sum += std::min(400.0,
                      std::pow((measured.second[i] - interpolate(predicted.first, predicted.second, place)) / s, 2));
    }
    if (count > 0) squares.push_back(sum / count);
  }
  if (conditions.contains("stop")) {
    const double stop = si(conditions["stop"].at("value")), s = std::max(0.3, 0.02 * stop);
    const auto remark = model.remarks.find("stop_distance");
    const double predicted =
        remark == model.remarks.end() || remark->second.empty() ? std::nan("") : si(remark->second);
    squares.push_back(std::isfinite(predicted) ? std::min(400.0, std::pow((stop - predicted) / s, 2)) : 400.0);
  }
  double mean = 0.0;
  for (const double q : squares) mean += q / static_cast<double>(squares.size());
  return std::sqrt(mean);
}

}  // namespace scoring
