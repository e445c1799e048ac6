#include <fmt/format.h>

#include <cmath>

#include "apc/report/design_record.h"

namespace apc::report {

std::vector<RowRun> row_runs(const design::Blocks& blocks) {
  std::vector<RowRun> out;
  for (std::size_t row = 0; row < blocks.depth.size(); ++row) {
    if (!out.empty() && std::abs(out.back().depth - blocks.depth[row]) < 1e-9)
      out.back().last = row + 1;
    else
      out.push_back({row + 1, row + 1, blocks.depth[row]});
  }
  return out;
}

namespace {

void add_certificate(std::string& out, const DesignRecord& record) {
  const auto& certificate = record.design.certificate;
  out += fmt::format(
      "\n  certificate    {} and {} differ by {} ({})\n"
      "                 gradients within {} of other differences, {} of sensitivities; stationarity {:.1e}, gap {}\n",
      design::text(certificate.first.method), design::text(certificate.second.method),
      percent(certificate.difference, 3),
      !certificate.agreed              ? "NOT agreed"
      : design::certified(certificate) ? "certified"
                                       : "agreed, but the optimum is NOT shown",
      percent(certificate.gradient_error, 2),
      std::isfinite(certificate.sensitivity_error) ? percent(certificate.sensitivity_error, 2) : "(not compared)",
      certificate.stationarity, percent(certificate.gap, 3));
  double shown_weight = 0.0;
  for (const auto& active : certificate.active) {
    if (active.constraint.kind == design::Kind::bound || active.weight < 0.01 || shown_weight > 0.97) continue;
    shown_weight += active.weight;
    out += fmt::format("    holds it     {:<58} weight {}\n", describe(active.constraint, record.fleet),
                       percent(active.weight, 0));
  }
}

}  // namespace

std::string design_brief(const DesignRecord& record, UnitSystem units) {
  const auto& design = record.design;
  const auto distance = [&](double value) { return shown(value, measure::distance, units); };
  std::string out = fmt::format("Bed for \"{}\", objective {}, {} criterion\n\n", record.fleet.name,
                                design::text(design.objective), study::text(record.fleet.limits.criterion));
  if (!record.fleet.limits.loads.empty())
    out += "  counted        " + design::counted_loads(record.fleet.limits) +
           " only; apc report judges by every known gear limit\n";
  if (design.uniform.length > 0)
    out += fmt::format("  one depth      {} deep, {} long{}; a deeper one is forbidden by {}\n",
                       shown(design.uniform.depth, measure::depth, units), distance(design.uniform.length),
                       design.uniform.feasible ? "" : " (already oversteps a limit)",
                       describe(design.uniform.limiting, record.fleet));
  if (!design.feasible) {
    out += "  NOT FEASIBLE   " + design.reason + "\n";
    add_certificate(out, record);
    return out + fmt::format("  {} overruns simulated; {:.1f} s\n", design.runs, record.seconds);
  }
  const auto& bed = design.built.bed;
  out +=
      fmt::format("  optimum        {} long, ramp {}, depths", distance(design.length), distance(design.profile.ramp));
  for (const double depth : design.profile.depth) out += " " + shown(depth, measure::depth, units) + ",";
  out.back() = '\n';
  out += fmt::format("  as built       {} long ({} rows), up to {} deep, {}; worst load at {} of its limit\n",
                     distance(bed.length()), design.built.blocks.depth.size(),
                     shown(bed.maximum_depth(), measure::depth, units), shown(bed.volume(), measure::volume, units),
                     percent(design.built.worst_use, 1));
  out += "  rows          ";
  for (const auto& run : row_runs(design.built.blocks))
    out += fmt::format(" {}-{}: {},", run.first, run.last, shown(run.depth, measure::depth, units));
  out.back() = '\n';
  out += fmt::format("\n  {:<34}{:>10}{:>12}{:>12}{:>12}{:>12}  {}\n", "case", "exit", "stop", "highest", "arrested",
                     "use", "nearest limit");
  for (const auto& outcome : design.cases) {
    const auto& each = record.fleet.cases[outcome.fleet_case];
    out += fmt::format("  {:<34}{:>10}{:>12}{:>12}{:>12}{:>12}  {}\n", each.aircraft + ", " + each.name,
                       shown(design.built.results[outcome.fleet_case].entry_speed, measure::speed, units),
                       std::isfinite(outcome.stop_distance) ? distance(outcome.stop_distance) : "left",
                       shown(outcome.max_exit_speed, measure::speed, units),
                       shown(outcome.arrest_speed, measure::speed, units), percent(outcome.use, 1),
                       describe(outcome.active, record.fleet));
  }
  add_certificate(out, record);
  for (const auto& point : record.front)
    out += fmt::format("  trade          margin {:>6}: {:>10} long, {:>12}\n", percent(point.margin, 0),
                       distance(point.length), shown(point.volume, measure::volume, units));
  return out + fmt::format("  {} overruns simulated, {} the solver gave up; {:.1f} s\n", design.runs, design.gave_up,
                           record.seconds);
}

}  // namespace apc::report
