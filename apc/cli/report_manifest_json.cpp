/// Schema "apc-manifest/1": what a report was made from, what came out, and the way back.
#include <nlohmann/json.hpp>

#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/cli/report_run.h"
#include "apc/report/manifest_json.h"
#include "apc/report/sha256.h"

namespace apc::cli {
namespace {

using Value = nlohmann::ordered_json;

std::string manifest_text(const ReportAsk& ask, const report::ComplianceRecord& record, const Texts& made) {
  Value out{{"schema", "apc-manifest/1"}};
  out.update(report::provenance(record.manifest));
  out["arguments"] = Value::object();
  for (const auto& [name, value] : {std::pair{"design", ask.of.design},
                                    {"site", ask.site},
                                    {"model", ask.effects},
                                    {"loads", ask.of.choice.loads.string()},
                                    {"tires", ask.of.choice.tires.string()}})
    if (!value.empty()) out["arguments"][name] = value;
  out["made"] = Value::array();
  for (const auto& [name, text] : made) out["made"].push_back({{"name", name}, {"sha256", report::sha256(text)}});
  return out.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

Json read_manifest_file(const std::filesystem::path& path) {
  auto json = read_json(path);
  json.schema("apc-manifest/1");
  return json;
}

}  // namespace

Texts texts_of(const ReportAsk& ask, const report::ComplianceRecord& record) {
  Texts out{{"report.html", report::compliance_page(record)}, {"report.json", report::compliance_json(record)}};
  if (record.site) {
    out.emplace_back("site.geojson", site::geojson(*record.site, record.design.bed));
    out.emplace_back("site.kml", site::kml(*record.site, record.design.bed));
  }
  const auto manifest = manifest_text(ask, record, out);
  out.emplace_back("manifest.json", manifest);
  return out;
}

ReportAsk read_manifest(const std::filesystem::path& path) {
  const auto json = read_manifest_file(path);
  const auto program = json.text("program");
  json.check(program == std::string("apc ") + APC_VERSION, "program",
             concat("is another version than this program (apc ", APC_VERSION, "): the same bytes cannot be promised"));
  for (const auto& file : json.objects("files")) {
    const auto name = file.text("path"), was = file.text("sha256");
    std::error_code error;
    file.check(std::filesystem::is_regular_file(name, error), "path",
               "is missing. Start in the folder in which the report was made");
    const auto now = report::sha256(read_text(name));
    file.check(now == was, "path",
               concat("has changed since the report was made (SHA-256 now ", now.substr(0, 16), "…, then ",
                      was.substr(0, 16), "…)"));
  }
  ReportAsk ask;
  ask.command = json.text("command");
  const auto arguments = json.object("arguments");
  ask.of.design = arguments.text("design");
  ask.site = arguments.text("site", ""), ask.effects = arguments.text("model", "");
  ask.of.choice.loads = arguments.text("loads", ""), ask.of.choice.tires = arguments.text("tires", "");
  return ask;
}

std::vector<std::string> differing(const std::filesystem::path& path, const Texts& texts) {
  std::vector<std::string> out;
  for (const auto& each : read_manifest_file(path).objects("made"))
    for (const auto& [name, text] : texts)
      if (name == each.text("name") && report::sha256(text) != each.text("sha256")) out.push_back(name);
  return out;
}

}  // namespace apc::cli
