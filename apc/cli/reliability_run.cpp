#include "apc/cli/reliability_run.h"

#include <chrono>
#include <mutex>

#include "apc/base/require.h"
#include "apc/study/store.h"

namespace apc::cli {

report::ReliabilityRecord run_reliability(const ReliabilityAsk& ask) {
  require(ask.samples >= 100 && ask.samples <= 1000000, "--samples: ", ask.samples, " is outside 100 to 1000000");
  require(ask.seed >= 0, "--seed: ", ask.seed, " is negative");
  report::ReliabilityRecord record;
  if (!ask.scatter.empty()) record.scatter = reliability::load_scatter(ask.scatter);
  auto loaded = load_design_models(ask.of);
  if (!ask.scatter.empty()) loaded.files.push_back(note("scatter", ask.scatter, record.scatter.source));
  std::string identity = std::string(APC_VERSION) + " critical speeds/2 ";
  for (const auto& each : loaded.files) identity += each.sha256;

  const auto& design = loaded.design;
  const auto cases = design.fleet.cases.size();
  reliability::ReliabilityOptions options;
  options.samples = (static_cast<std::size_t>(ask.samples) + cases - 1) / cases;
  options.seed = static_cast<std::uint64_t>(ask.seed), options.threads = ask.of.threads;
  // Damage asks for every known gear limit, whatever the design counted; leaving the tables' range is a warning about
  // the model and no damage.
  auto limits = design.fleet.limits;
  limits.loads.clear(), limits.table_range = false;
  std::mutex guard;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < cases; ++k) {
    const auto& each = design.fleet.cases[k];
    const auto name = each.aircraft + ", " + each.name;
    const auto& model = loaded.models[k];
    const reliability::ReliabilityInput input{
        model,
        each.overrun,
        each.overrun.entry_speed * design.speed_factor,
        [&](const simulation::Result& result) { return design::worst_use(result, model, limits); },
        record.scatter,
        record.exit_speeds};
    if (ask.progress)
      options.finished = [&](std::size_t finished) {
        const std::lock_guard lock(guard);
        ask.progress(static_cast<double>(k * options.samples + finished), static_cast<double>(cases * options.samples),
                     name);
      };
    study::Store store(ask.of.out / ("case_" + std::to_string(k + 1) + ".store"), study::fingerprint(identity));
    record.results.push_back(reliability::assess(input, reliability::side_by_side(), store, options));
    record.cases.push_back(name), record.asked_speeds.push_back(input.asked_speed);
  }
  record.design = design.bed.name, record.criterion = study::text(design.fleet.limits.criterion);
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.manifest = {std::string("apc ") + APC_VERSION, ask.command, "", std::move(loaded.files)};
  return record;
}

}  // namespace apc::cli
