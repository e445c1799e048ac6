/// The compliance report of a design, from files to finished texts: what `apc report` and the Python binding do.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apc/cli/of_design.h"
#include "apc/report/compliance_record.h"

namespace apc::cli {

struct ReportAsk {
  OfDesign of;
  std::string site;     ///< apc-site/1, name or file; empty = none
  std::string effects;  ///< apc-model/1: learned effects, whose influence is reported; empty = none
  std::string command;  ///< for the manifest
};

/// Runs every case. Throws InputError, SolveError, Interrupted.
report::ComplianceRecord run_report(const ReportAsk&);

/// Names and contents: report.html, report.json, with a site site.geojson and site.kml, and manifest.json.
using Texts = std::vector<std::pair<std::string, std::string>>;
Texts texts_of(const ReportAsk&, const report::ComplianceRecord&);

/// What a manifest.json asks for. InputError when it was made by another version of the program or when a file it
/// names is missing or has changed since.
ReportAsk read_manifest(const std::filesystem::path&);

/// Names of the texts whose bytes are not those that the manifest promises.
std::vector<std::string> differing(const std::filesystem::path& manifest, const Texts&);

}  // namespace apc::cli
