#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "loadtables/campaign.h"

namespace apc::loadtables {
namespace {

using Value = nlohmann::ordered_json;

/// A refused run may end with anything; only numbers are written.
double finite(double value) { return std::isfinite(value) ? value : 0.0; }

std::string written(double value, const char* unit) { return fmt::format("{:.10g} {}", finite(value), unit); }

bool is_state(const std::string& state) {
  return state == "steady" || state == "did_not_settle" || state == "tire_overloaded" || state == "unstable";
}

}  // namespace

void write_outcome(const PlannedRun& run, const RunOutcome& outcome, const std::filesystem::path& file) {
  expect(is_state(outcome.state), "a run's state \"", outcome.state, "\"");
  Value json{{"schema", "apc-load-run/1"},
             {"id", run.id},
             {"state", outcome.state},
             {"speed", written(run.contact.speed, "m/s")},
             {"bed_depth", written(run.contact.bed_depth, "m")},
             {"penetration", written(run.contact.penetration, "m")},
             {"drag", written(outcome.load.drag, "N")},
             {"vertical", written(outcome.load.vertical, "N")},
             {"rut_depth", written(outcome.load.rut_depth, "m")},
             {"spin_ratio", finite(outcome.load.spin_ratio)},
             {"wall", written(outcome.wall_s, "s")}};
  if (!outcome.message.empty()) json["message"] = outcome.message;
  for (const auto& [name, value] : outcome.facts)
    if (std::isfinite(value)) json["facts"][name] = value;
  write_text(file, json.dump(1) + "\n");
}

RunOutcome read_outcome(const PlannedRun& run, const std::filesystem::path& file) {
  const auto json = read_json(file);
  json.schema("apc-load-run/1");
  json.check(json.integer("id") == run.id, "id", "is not the run of this file's name");
  RunOutcome outcome;
  outcome.state = json.text("state");
  json.check(is_state(outcome.state), "state", "is unknown (steady, did_not_settle, tire_overloaded or unstable)");
  const auto same = [&](const char* key, double value, const Dimension& dimension) {
    const double found = json.quantity(key, dimension);
    json.check(std::abs(found - value) <= 1e-6 * (std::abs(value) + 1e-6), key,
               "is not what the plan says. The plan was changed after this run; make a new folder");
  };
  same("speed", run.contact.speed, dimension::speed);
  same("bed_depth", run.contact.bed_depth, dimension::length);
  same("penetration", run.contact.penetration, dimension::length);
  outcome.load.drag = json.quantity("drag", dimension::force);
  outcome.load.vertical = json.quantity("vertical", dimension::force);
  outcome.load.rut_depth = json.quantity("rut_depth", dimension::length);
  outcome.load.spin_ratio = json.number("spin_ratio");
  outcome.wall_s = json.quantity("wall", dimension::time);
  if (json.has("message")) outcome.message = json.text("message");
  if (json.has("facts")) {
    const auto facts = json.object("facts");
    for (const auto& key : facts.keys()) outcome.facts[key] = facts.number(key);
  }
  json.finish();
  return outcome;
}

void write_settings(const CampaignSettings& settings, const std::filesystem::path& folder) {
  Value json{{"schema", "apc-load-settings/1"},
             {"friction", settings.friction},
             {"spacing", written(settings.spacing, "m")},
             {"solver", settings.solver}};
  if (!settings.command.empty()) json["command"] = settings.command;
  write_text(folder / "settings.json", json.dump(1) + "\n");
}

std::optional<CampaignSettings> campaign_settings(const std::filesystem::path& folder) {
  const auto file = folder / "settings.json";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const auto json = read_json(file);
  json.schema("apc-load-settings/1");
  CampaignSettings settings;
  settings.friction = json.number("friction");
  settings.spacing = json.quantity("spacing", dimension::length);
  settings.solver = json.text("solver");
  if (json.has("command")) settings.command = json.text("command");
  json.finish();
  return settings;
}

}  // namespace apc::loadtables
