#include "apc/cli/sph_studies.h"

#include <fmt/format.h>

#include <cmath>

#include "apc/base/units.h"
#include "apc/cli/text_table.h"

namespace apc::cli {
namespace {

using report::UnitSystem;

/// How the studies' quantities are written; their SI units are N, N/m, J/m, J/m² and 1.
report::Measure measure_of(const sph::Quantity& quantity) {
  namespace u = units;
  if (quantity.unit == "N") return report::measure::force;
  if (quantity.unit == "N/m") return {{"lbf/in", u::lbf / u::in, 0}, {"kN/m", 1e3, 1}};
  if (quantity.unit == "J/m") return {{"lbf", u::lbf, 0}, {"kJ/m", 1e3, 2}};
  if (quantity.unit == "J") return {{"lbf ft", u::lbf * u::ft, 0}, {"kJ", 1e3, 2}};
  if (quantity.unit == "1") return {{"%", 0.01, 2}, {"%", 0.01, 2}};
  return {{quantity.unit.c_str(), 1.0, 3}, {quantity.unit.c_str(), 1.0, 3}};
}

std::string written(const sph::Quantity& quantity, double value, UnitSystem units) {
  return std::isfinite(value) ? report::shown(value, measure_of(quantity), units) : "-";
}

std::string account(const sph::Verification& run) {
  return fmt::format(
      "  {}, {}: energy residual {}, viscosity {} of the work, spin ratio {}, compaction {}, sum of V W {}\n"
      "  {} particles, {} steps, {:.2f} million particle-steps/s, {:.1f} s\n",
      run.symmetry, run.state.empty() ? "done" : run.state, report::percent(run.energy_residual, 2),
      report::percent(run.viscous_share, 1), report::number(run.spin_ratio, 3), report::percent(run.compaction, 1),
      report::number(run.partition, 3), report::number(run.particles, 0), report::number(run.steps, 0),
      run.particle_steps_per_s / 1e6, run.wall_s);
}

}  // namespace

std::string verification_text(const sph::Verification& run, UnitSystem units) {
  TextTable table{{"quantity", "here", "published SPH", "difference", "published FEM"}, {}};
  for (const auto& each : run.quantities)
    table.rows.push_back({each.name, written(each, each.value, units), written(each, each.reference, units),
                          std::isfinite(each.difference()) ? report::percent(each.difference(), 1) : "-",
                          written(each, each.reference_fem, units)});
  return fmt::format("{}, particles {} apart\n\n{}\n{}", sph::name_of(run.study),
                     report::shown(run.spacing, report::measure::depth, units), aligned(table), account(run));
}

std::string convergence_text(const sph::Convergence& study, UnitSystem units) {
  TextTable table{{"quantity"}, {}};
  for (const double size : study.sizes) table.headings.push_back(report::shown(size, report::measure::depth, units));
  for (const char* heading : {"order", "limit", "r2", "GCI", "published"}) table.headings.emplace_back(heading);
  for (const auto& each : study.quantities) {
    std::vector<std::string> row{each.finest.name};
    for (const double value : each.values) row.push_back(written(each.finest, value, units));
    row.push_back(each.fit.valid ? report::number(each.fit.order, 2) : "none");
    row.push_back(each.fit.valid ? written(each.finest, each.fit.extrapolated, units) : "-");
    row.push_back(each.fit.valid ? report::number(each.fit.r2, 4) : "-");
    row.push_back(each.gci.valid ? report::percent(each.gci.index, 1) : "-");
    row.push_back(written(each.finest, each.finest.reference, units));
    table.rows.push_back(row);
  }
  std::string out =
      fmt::format("{}: values over the particle spacing\n\n{}\n", sph::name_of(study.study), aligned(table));
  for (const auto& run : study.runs) out += account(run);
  return out;
}

}  // namespace apc::cli
