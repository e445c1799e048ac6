#include "apc/cli/report_run.h"

#include <cmath>

#include "apc/base/file.h"
#include "apc/base/parallel.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/overlay_json.h"
#include "apc/study/critical_speed.h"

namespace apc::cli {
namespace {

/// All tires' loads × (1 + error).
effects::TableError scaled(double error) {
  effects::TableError out;
  out.drag.fill(std::log1p(error)), out.vertical.fill(std::log1p(error));
  return out;
}

report::ComplianceCase judge(const design::DesignFile& design, std::size_t k, const simulation::Model& model,
                             const learning::Overlay& learned) {
  report::ComplianceCase out;
  auto run = design.fleet.cases[k].overrun;
  run.entry_speed *= design.speed_factor;
  // A reviewer asks whether the aircraft is damaged, not whether the design counted the load that damages it.
  auto limits = design.fleet.limits;
  limits.loads.clear();
  const auto use = [&](const simulation::Result& result) { return design::worst_use(result, model, limits); };
  out.result = simulation::simulate(model, run, {simulation::Method::reference, 1e-7, 0.01, 120.0});
  out.result.solver.wall_s = 0.0;  // the only thing in it that is not the same every time
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
  if (!learned.effects.empty()) {
    auto more = run;
    more.alterations.effects = learned.effects, more.alterations.bed_strength *= learned.bed_strength;
    const auto result = simulation::simulate(endless, more, fast);
    out.learned_stop = result.stop_distance, out.learned_use = use(result);
  }
  out.model = model;
  return out;
}

}  // namespace

report::ComplianceRecord run_report(const ReportAsk& ask) {
  report::ComplianceRecord record;
  auto loaded = load_design_models(ask.of);
  record.design = std::move(loaded.design);
  if (!ask.site.empty()) {
    const auto file = resolve(ask.site, "designs/sites", "site");
    record.site = site::load_site(file);
    record.fit = site::fit(*record.site, record.design.bed);
    record.manifest.files.push_back(note("site", file, record.site->source));
  }
  learning::Overlay learned;
  if (!ask.effects.empty()) {
    learned = learning::load_overlay(ask.effects, effects::catalogue());
    record.manifest.files.push_back(note("learned effects", ask.effects, ""));
    for (const auto& each : learned.effects) record.learned.names.push_back(each.effect.id);
    record.learned.slowest = learned.slowest, record.learned.fastest = learned.fastest;
  }
  record.manifest.files.insert(record.manifest.files.end(), loaded.files.begin(), loaded.files.end());
  record.manifest.version = std::string("apc ") + APC_VERSION, record.manifest.command = ask.command;
  record.cases.resize(loaded.models.size());
  parallel_for(record.cases.size(), ask.of.threads, [&](std::size_t k) {
    if (stop_requested()) throw Interrupted();
    record.cases[k] = judge(record.design, k, loaded.models[k], learned);
  });
  return record;
}

}  // namespace apc::cli
