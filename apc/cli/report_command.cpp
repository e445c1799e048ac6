/// `apc report`: a design against every checkable requirement, as one self-contained page, with GeoJSON and KML for a
/// site and a manifest that makes it again byte for byte.
#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/print_pdf.h"
#include "apc/cli/report_run.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  ReportAsk ask;
  fs::path manifest;
  bool pdf = false;
};

void say(const report::ComplianceRecord& record, Settings& settings) {
  std::size_t passed = 0, failed = 0, unverified = 0, open = 0;
  for (const auto& each : report::findings(record)) {
    passed += each.verdict == report::Verdict::pass, failed += each.verdict == report::Verdict::fail;
    unverified += each.verdict == report::Verdict::not_verified, open += each.verdict == report::Verdict::not_checked;
    if (each.verdict == report::Verdict::fail && !settings.quiet) std::printf("  fails     %s\n", each.clause.c_str());
  }
  if (failed > 0) settings.exit_code = exit_code::not_met;
  if (!settings.quiet)
    std::printf(
        "  %zu requirements pass, %zu fail, %zu rest on clauses not verified, %zu cannot be checked by simulation\n",
        passed, failed, unverified, open);
}

void run_command(const Words& words, Settings& settings) {
  const auto browser = words.pdf ? find_browser() : fs::path();
  auto ask = words.ask;
  if (words.manifest.empty()) {
    require(!ask.of.design.empty(), "--design: is missing. Give the design.json of apc design, or a --manifest");
    ask.command = settings.command_line;
  } else {
    require(ask.of.design.empty() && ask.site.empty() && ask.effects.empty() && ask.of.choice.loads.empty() &&
                ask.of.choice.tires.empty(),
            "--manifest: names every input itself. Leave the others out");
    auto again = read_manifest(words.manifest);
    again.of.out = ask.of.out, again.of.threads = ask.of.threads;
    ask = std::move(again);
  }
  const auto folder = ask.of.out.empty() ? fs::path("out") / "report" : ask.of.out;
  for (const char* name : {"report.html", "report.json", "report.pdf"}) settings.results.push_back(folder / name);
  const auto record = run_report(ask);
  const auto texts = texts_of(ask, record);
  const auto changed = words.manifest.empty() ? std::vector<std::string>() : differing(words.manifest, texts);
  for (const auto& [name, text] : texts) write_text(folder / name, text);
  if (words.pdf) print_pdf(browser, folder / "report.html", folder / "report.pdf");
  if (!settings.json.empty()) write_text(settings.json, texts[1].second);
  say(record, settings);
  if (!settings.quiet) {
    std::printf("  page      %s%s\n  also      report.json, manifest.json%s beside it\n",
                (folder / "report.html").c_str(), words.pdf ? ", report.pdf" : "",
                record.site ? ", site.geojson, site.kml" : "");
    if (!words.manifest.empty() && changed.empty())
      std::printf("  again     the same bytes as the manifest promises\n");
  }
  for (const auto& name : changed)
    std::fprintf(stderr, "apc: %s differs from what the manifest promises\n", name.c_str());
  if (!changed.empty()) settings.exit_code = exit_code::not_met;
}

}  // namespace

void add_report(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand(
      "report", "compliance report of a design: requirements, loads, margins, validity, sources");
  const auto words = std::make_shared<Words>();
  add_design_options(*command, words->ask.of, "folder of the files (default out/report)");
  command->add_option("--site", words->ask.site, "runway end (apc-site/1): also the fit, GeoJSON and KML")
      ->type_name("NAME|FILE");
  command->add_option("--model", words->ask.effects, "learned effects (apc-model/1): also what they would change")
      ->type_name("FILE");
  command->add_option("--manifest", words->manifest, "manifest.json of a report: makes it again and compares the bytes")
      ->type_name("FILE");
  command->add_flag("--pdf", words->pdf, "also as PDF, printed by Chromium");
  add_common_options(*command, settings);
  command->footer(
      "Exit code 1 when a requirement whose clause was read is not met.\nExample: apc report --design "
      "out/design_acrp29_fleet/design.json --site example_runway_end --pdf");
  command->callback([words, &settings] { run_command(*words, settings); });
}

}  // namespace apc::cli
