/// `apc reliability`: the probability that a designed bed arrests, and arrests without damage, over everything that
/// scatters.
#include <CLI/CLI.hpp>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/cli/commands.h"
#include "apc/cli/reliability_run.h"

namespace apc::cli {
namespace {

void run_command(ReliabilityAsk ask, Settings& settings) {
  if (ask.of.out.empty()) ask.of.out = std::filesystem::path("out") / "reliability";
  ask.command = settings.command_line;
  settings.results = {ask.of.out / "reliability.json", ask.of.out / "reliability.html"};
  std::unique_ptr<Progress> progress;
  if (!settings.quiet)
    ask.progress = [&](double finished, double all, const std::string& name) {
      if (!progress) progress = std::make_unique<Progress>("samples", all);
      progress->show(finished, name);
    };
  const auto record = run_reliability(ask);
  progress.reset();
  const auto json = report::reliability_json(record), page = report::reliability_page(record);
  write_text(ask.of.out / "reliability.json", json);
  write_text(ask.of.out / "reliability.html", page);
  if (!settings.json.empty()) write_text(settings.json, json);
  if (settings.quiet) return;
  std::fputs(report::reliability_brief(record, settings.units).c_str(), stdout);
  std::printf("  page      %s\n", (ask.of.out / "reliability.html").c_str());
}

}  // namespace

void add_reliability(CLI::App& program, Settings& settings) {
  auto* command =
      program.add_subcommand("reliability", "probability of arrest, and of arrest without damage, over all scatter");
  const auto ask = std::make_shared<ReliabilityAsk>();
  add_design_options(*command, ask->of, "folder of the files and of the finished samples (default out/reliability)");
  command->get_option("--design")->required();
  command->add_option("--samples", ask->samples, "over all cases together (default 1000; at least 200 per case)")
      ->type_name("N");
  command->add_option("--seed", ask->seed, "of the samples (default 1)")->type_name("N");
  command->add_option("--scatter", ask->scatter, "apc-scatter/1 file (default: estimates, listed in the record)")
      ->type_name("FILE");
  add_common_options(*command, settings);
  command->footer(
      "Interrupted, the same command continues where it was.\nExample: apc reliability --design "
      "out/design_acrp29_fleet/design.json --samples 10000");
  command->callback([ask, &settings] { run_command(*ask, settings); });
}

}  // namespace apc::cli
