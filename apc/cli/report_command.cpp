/// `apc report`: a design against every checkable requirement, as one self-contained page, with GeoJSON and KML for a
/// site.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/cli/commands.h"
#include "apc/cli/fleet_inputs.h"
#include "apc/report/compliance_record.h"
#include "apc/study/critical_speed.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

struct Words {
  std::string design, site;
  Choice choice;
  fs::path out;
  bool pdf = false;
  unsigned threads = 0;
};

fs::path find_browser() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"})
    if (std::error_code error; fs::exists(path, error)) return path;
  throw InputError(
      "--pdf: no Chromium is installed. Install the package \"chromium\", or print report.html from any browser");
}

/// Chromium's own print; nothing of the page's content passes through a shell.
void print_pdf(const fs::path& browser, const fs::path& page, const fs::path& pdf) {
  const auto profile =
      fs::temp_directory_path() / ("apc_print_" + std::to_string(std::hash<std::string>{}(fs::absolute(pdf).string())));
  write_atomically(pdf, [&](const fs::path& part) {
    const auto quoted = [](const fs::path& path) {
      std::string out = "'";
      for (const char letter : path.string()) out += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
      return out + "'";
    };
    const auto made = fs::absolute(part.string() + ".pdf");
    const auto command = quoted(browser) +
                         " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking"
                         " --disable-component-update --disable-sync --no-pdf-header-footer --virtual-time-budget=3000 "
                         "--user-data-dir=" +
                         quoted(profile) + " --print-to-pdf=" + quoted(made) + " " +
                         quoted("file://" + fs::absolute(page).string()) + " >/dev/null 2>&1";
    const int code = std::system(command.c_str());
    std::error_code error;
    fs::remove_all(profile, error);
    require(code == 0 && fs::exists(made, error), "--pdf: ", browser.string(), " did not print ", page.string(),
            ". Print it by hand");
    fs::rename(made, part);
  });
}

/// All tires' loads × (1 + error).
effects::TableError scaled(double error) {
  effects::TableError out;
  out.drag.fill(std::log1p(error)), out.vertical.fill(std::log1p(error));
  return out;
}

report::ComplianceCase judge(const design::DesignFile& design, std::size_t k, simulation::Model model) {
  report::ComplianceCase out;
  model.bed = design.bed;
  auto run = design.fleet.cases[k].overrun;
  run.entry_speed *= design.speed_factor;
  // A reviewer asks whether the aircraft is damaged, not whether the design counted the load that damages it.
  auto limits = design.fleet.limits;
  limits.loads.clear();
  const auto use = [&](const simulation::Result& result) { return design::worst_use(result, model, limits); };
  out.result = simulation::simulate(model, run, {simulation::Method::reference, 1e-7, 0.01, 120.0});
  out.use = use(out.result);
  const simulation::Options fast{simulation::Method::fast, 1e-6, limits.table_range ? 0.01 : 0.0, 120.0};
  study::CriticalSpeed guess;
  guess.arrest = guess.intact = run.entry_speed;
  const auto speeds = study::critical_speed(model, run, design.bed.length(), use, simulation::simulate, fast, guess);
  out.arrest_speed = speeds.arrest, out.intact_speed = speeds.intact;
  for (const auto& table : model.tables)
    for (const auto& fit : table.quality())
      if (fit.response == "drag") out.table_error = std::max(out.table_error, fit.loo_rms_relative);
  auto endless = model;
  endless.bed = study::continued(model.bed);
  const auto with = [&](double error) {
    auto wrong = run;
    wrong.alterations.table_errors.assign(model.tables.size(), scaled(error));
    return simulation::simulate(endless, wrong, fast);
  };
  const auto weak = with(-out.table_error), strong = with(out.table_error);
  out.stop_low = std::min(weak.stop_distance, strong.stop_distance),
  out.stop_high = std::max(weak.stop_distance, strong.stop_distance);
  out.use_low = std::min(use(weak), use(strong)), out.use_high = std::max(use(weak), use(strong));
  out.model = std::move(model);
  return out;
}

void run_report(const Words& words, Settings& settings) {
  const auto browser = words.pdf ? find_browser() : fs::path();
  const fs::path file = words.design;
  report::ComplianceRecord record;
  record.design = design::load_design(file);
  const auto design_note = note("design", file, record.design.program + ": " + record.design.command);
  if (!words.site.empty()) {
    const auto site_file = resolve(words.site, "designs/sites", "site");
    record.site = site::load_site(site_file);
    record.fit = site::fit(*record.site, record.design.bed);
    record.manifest.files.push_back(note("site", site_file, record.site->source));
  }
  auto loaded = load_fleet_models(record.design.fleet, design_note, words.choice);
  record.manifest.files.insert(record.manifest.files.end(), loaded.files.begin(), loaded.files.end());
  record.manifest.version = std::string("apc ") + APC_VERSION, record.manifest.command = settings.command_line;
  record.cases.resize(loaded.models.size());
  parallel_for(record.cases.size(), words.threads, [&](std::size_t k) {
    if (stop_requested()) throw Interrupted();
    record.cases[k] = judge(record.design, k, loaded.models[k]);
  });
  const auto page = report::compliance_page(record), json = report::compliance_json(record);
  const auto folder = words.out.empty() ? fs::path("out") / "report" : words.out;
  write_text(folder / "report.html", page);
  write_text(folder / "report.json", json);
  if (record.site) {
    write_text(folder / "site.geojson", site::geojson(*record.site, record.design.bed));
    write_text(folder / "site.kml", site::kml(*record.site, record.design.bed));
  }
  if (words.pdf) print_pdf(browser, folder / "report.html", folder / "report.pdf");
  if (!settings.json.empty()) write_text(settings.json, json);
  std::size_t passed = 0, failed = 0, unverified = 0, open = 0;
  for (const auto& each : report::findings(record)) {
    passed += each.verdict == report::Verdict::pass, failed += each.verdict == report::Verdict::fail;
    unverified += each.verdict == report::Verdict::not_verified, open += each.verdict == report::Verdict::not_checked;
    if (each.verdict == report::Verdict::fail && !settings.quiet) std::printf("  fails     %s\n", each.clause.c_str());
  }
  if (failed > 0) settings.exit_code = exit_code::not_met;
  if (settings.quiet) return;
  std::printf(
      "  %zu requirements pass, %zu fail, %zu rest on clauses not verified, %zu cannot be checked by simulation\n",
      passed, failed, unverified, open);
  std::printf("  page      %s%s\n  also      report.json%s beside it\n", (folder / "report.html").c_str(),
              words.pdf ? ", report.pdf" : "", record.site ? ", site.geojson, site.kml" : "");
}

}  // namespace

void add_report(CLI::App& program, Settings& settings) {
  auto* command = program.add_subcommand(
      "report", "compliance report of a design: requirements, loads, margins, validity, sources");
  const auto words = std::make_shared<Words>();
  command->add_option("--design", words->design, "design.json of apc design")->required()->type_name("FILE");
  command->add_option("--site", words->site, "runway end (apc-site/1): also the fit, GeoJSON and KML")
      ->type_name("NAME|FILE");
  command->add_flag("--pdf", words->pdf, "also as PDF, printed by Chromium");
  command->add_option("--loads", words->choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command->add_option("--tires", words->choice.tires, "tire library")->type_name("FILE");
  command->add_option("--threads", words->threads, "default: all")->type_name("N");
  command->add_option("-o,--out", words->out, "folder of the files (default out/report)")->type_name("DIR");
  add_common_options(*command, settings);
  command->footer(
      "Exit code 1 when a requirement whose clause was read is not met.\nExample: apc report --design "
      "out/design_acrp29_fleet/"
      "design.json --site example_runway_end --pdf");
  command->callback([words, &settings] { run_report(*words, settings); });
}

}  // namespace apc::cli
