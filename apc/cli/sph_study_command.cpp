/// `apc sph verify|converge|bench`: the published cases, their convergence, and the throughput of this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "apc/base/file.h"
#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/cli/commands.h"
#include "apc/cli/sph_deck.h"
#include "apc/cli/sph_studies.h"

namespace apc::cli {
namespace {

struct StudyWords {
  std::string study, spacing, sizes;
  double friction = -1.0;
  unsigned threads = 0;
};

sph::StudyOptions options_of(const StudyWords& words, Progress* line) {
  require(words.threads <= 1024, "--threads: ", words.threads, ". Between 1 and 1024 are possible, 0 takes all");
  sph::StudyOptions options;
  options.friction = words.friction;
  options.threads = words.threads == 0 ? hardware_threads() : words.threads;
  options.stop = stop_requested;
  if (line) options.progress = [line](double share, const std::string& remark) { line->show(share, remark); };
  return options;
}

double read_size(const std::string& option, const std::string& text) {
  const double size = option_quantity(option, text, dimension::length);
  require(size >= 2 * units::mm && size <= 8 * units::in, option, ": \"", text,
          "\" does not resolve the case. The published sizes are 1 to 4 in");
  return size;
}

std::unique_ptr<Progress> line_of(const Settings& settings, const std::string& what) {
  return settings.quiet ? nullptr : std::make_unique<Progress>(what);
}

void verify(const StudyWords& words, Settings& settings) {
  const auto study = sph::study_of(words.study);
  const double spacing = words.spacing.empty() ? 2 * units::in : read_size("--h", words.spacing);
  auto line = line_of(settings, concat("SPH case ", words.study));
  const auto result = sph::verify(study, spacing, options_of(words, line.get()));
  line.reset();
  if (!settings.json.empty()) write_text(settings.json, verification_json(result));
  if (!settings.quiet) std::fputs(verification_text(result, settings.units).c_str(), stdout);
  if (result.state != "steady" && study != sph::Study::platen_1d)
    throw SolveError(concat(words.study, ": ", result.state, ": the loads did not become steady. Try other sizes"));
}

void converge(const StudyWords& words, Settings& settings) {
  const auto study = sph::study_of(words.study);
  std::vector<double> sizes;
  for (std::size_t start = 0; start < words.sizes.size();) {
    const auto comma = std::min(words.sizes.find(',', start), words.sizes.size());
    sizes.push_back(read_size("--sizes", words.sizes.substr(start, comma - start)));
    start = comma + 1;
  }
  if (sizes.empty()) sizes = sph::published_sizes(study);
  require(sizes.size() >= 3, "--sizes: \"", words.sizes, "\" holds fewer than three sizes. Write \"4 in, 2 in, 1 in\"");
  auto line = line_of(settings, concat("convergence of ", words.study));
  const auto result = sph::converge(study, sizes, options_of(words, line.get()));
  line.reset();
  if (!settings.json.empty()) write_text(settings.json, convergence_json(result));
  if (!settings.quiet) std::fputs(convergence_text(result, settings.units).c_str(), stdout);
}

/// The published tire case at 2 in, rolled for one radius after its release: the same work for every machine.
void bench(const StudyWords& words, Settings& settings) {
  auto deck = read_deck("h44_70kt");
  deck.rig.longest = 0.5 * deck.rig.tire.diameter;
  const unsigned all = words.threads == 0 ? hardware_threads() : words.threads;
  std::vector<BenchRow> rows;
  for (const unsigned threads : {1u, all}) {
    if (!rows.empty() && threads == 1) break;
    sph::RollOptions options;
    options.threads = threads;
    options.stop = stop_requested;
    auto line = line_of(settings, concat("bench on ", threads, threads == 1 ? " thread" : " threads"));
    if (line) options.progress = [&](double share, const std::string& remark) { line->show(share, remark); };
    const auto result = sph::roll(deck.rig, options);
    rows.push_back({threads, result.particles, result.particle_steps, result.particle_steps_per_s, result.wall_s});
  }
  if (!settings.json.empty()) write_text(settings.json, bench_json(rows));
  if (settings.quiet) return;
  for (const auto& row : rows)
    fmt::print("{:>3} {}  {:>8.0f} particles  {:>7.2f} million particle-steps/s  {:>7.1f} s\n", row.threads,
               row.threads == 1 ? "thread " : "threads", row.particles, row.particle_steps_per_s / 1e6, row.wall_s);
}

}  // namespace

void add_sph_studies(CLI::App& sph, Settings& settings) {
  const auto add = [&](const char* name, const char* what, void (*work)(const StudyWords&, Settings&)) {
    auto* command = sph.add_subcommand(name, what);
    const auto words = std::make_shared<StudyWords>();
    command->add_option("--threads", words->threads, "0 = all")->type_name("N")->capture_default_str();
    add_common_options(*command, settings);
    command->callback([words, work, &settings] { work(*words, settings); });
    return std::pair{command, words};
  };
  const auto [verified, verify_words] = add("verify", "a published case beside the published values", verify);
  verified->add_option("CASE", verify_words->study, "platen_1d, roller_2d or tire_3d")->required()->type_name("");
  verified->add_option("--h", verify_words->spacing, "particle spacing (default \"2 in\")")->type_name("LENGTH");
  verified->add_option("--friction", verify_words->friction, "of tire on foam (default 0 roller, 0.3 tire)");
  const auto [converged, converge_words] =
      add("converge", "a published case over several sizes: order, limit, GCI", converge);
  converged->add_option("CASE", converge_words->study, "platen_1d, roller_2d or tire_3d")->required()->type_name("");
  converged->add_option("--sizes", converge_words->sizes, "default: the published ones")
      ->type_name("\"4 in, 2 in, 1 in\"");
  converged->add_option("--friction", converge_words->friction, "of tire on foam (default 0 roller, 0.3 tire)");
  add("bench", "particle-steps per second of this machine on the published tire case", bench);
}

}  // namespace apc::cli
