#include "apc/cli/sph_studies.h"

#include <fmt/format.h>

#include <algorithm>
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
  if (quantity.unit == "J/m^2") return {{"lbf/in", u::lbf / u::in, 0}, {"kJ/m2", 1e3, 1}};
  if (quantity.unit == "J") return {{"lbf ft", u::lbf * u::ft, 0}, {"kJ", 1e3, 2}};
  if (quantity.name == "work_ratio") return {{"", 1.0, 3}, {"", 1.0, 3}};
  if (quantity.unit == "1") return {{"%", 0.01, 2}, {"%", 0.01, 2}};
  return {{quantity.unit.c_str(), 1.0, 3}, {quantity.unit.c_str(), 1.0, 3}};
}

std::string written(const sph::Quantity& quantity, double value, UnitSystem units) {
  return std::isfinite(value) ? report::shown(value, measure_of(quantity), units) : "-";
}

std::string percent_or_dash(double value, int digits) {
  return std::isfinite(value) ? report::percent(value, digits) : "-";
}

std::string number_or_dash(double value, int digits) {
  return std::isfinite(value) ? report::number(value, digits) : "-";
}

/// A particle size with every digit it was given.
std::string size_name(double size, UnitSystem system) {
  return system == UnitSystem::si ? fmt::format("{:.4g} mm", 1e3 * size) : fmt::format("{:.4g} in", size / units::in);
}

const char* label(sph::Method method) { return method == sph::Method::fem ? "FEM" : "SPH"; }

std::string account(const sph::Verification& run) {
  std::string out = fmt::format("  {} {}, {}, {}: energy residual {}, compaction {}, sum of V W {}, spin ratio {}\n",
                                label(run.method), size_name(run.spacing, UnitSystem::field), run.symmetry,
                                run.state.empty() ? "done" : run.state, report::percent(run.energy_residual, 2),
                                report::percent(run.compaction, 1), report::number(run.partition, 3),
                                report::number(run.spin_ratio, 3));
  out += fmt::format("    {} {}, {} steps, {:.2f} million a second, {:.1f} s", report::number(run.particles, 0),
                     run.method == sph::Method::fem ? "elements" : "particles", report::number(run.steps, 0),
                     run.particle_steps_per_s / 1e6, run.wall_s);
  if (run.bytes_per_particle > 0.0)
    out += fmt::format(", {} bytes per particle", report::number(run.bytes_per_particle, 0));
  if (!run.message.empty()) out += "\n    " + run.message;
  return out + "\n";
}

/// Every term of the energy account, a line each and a column for each run.
std::string energy_table(const std::vector<const sph::Verification*>& runs) {
  TextTable table{{"share of the work put in"}, {}};
  std::vector<std::string> names;
  for (const auto* run : runs) {
    table.headings.push_back(fmt::format("{} {}", label(run->method), size_name(run->spacing, UnitSystem::field)));
    for (const auto& term : run->energy)
      if (std::find(names.begin(), names.end(), term.name) == names.end()) names.push_back(term.name);
  }
  for (const auto& name : names) {
    std::vector<std::string> row{name};
    for (const auto* run : runs) {
      const auto term = std::find_if(run->energy.begin(), run->energy.end(),
                                     [&](const sph::EnergyTerm& each) { return each.name == name; });
      row.push_back(term == run->energy.end() ? "-" : report::percent(term->value, 2));
    }
    table.rows.push_back(row);
  }
  const auto add = [&](const char* name, auto value) {
    std::vector<std::string> row{name};
    for (const auto* run : runs) row.push_back(report::percent(value(*run), 2));
    table.rows.push_back(row);
  };
  add("residual", [](const sph::Verification& run) { return run.energy_residual; });
  add("hourglass over internal", [](const sph::Verification& run) { return run.hourglass_share; });
  return aligned(table);
}

/// The furrow of every rolling particle run, a column each.
std::string shape_table(const std::vector<const sph::Verification*>& runs, UnitSystem units) {
  static const report::Measure fine{{"in", apc::units::in, 2}, {"mm", apc::units::mm, 0}};
  TextTable table{{"shape of the rut"}, {}};
  for (const auto* run : runs) {
    if (run->shape.behind <= 0.0) continue;
    table.headings.push_back(fmt::format("{} {}", label(run->method), size_name(run->spacing, units)));
    const auto lines = sph::lines_of(run->shape);
    table.rows.resize(lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (table.rows[k].empty()) table.rows[k].emplace_back(lines[k].name);
      const double value = lines[k].value;
      table.rows[k].push_back(std::isfinite(value) ? report::shown(value, fine, units) : "-");
    }
  }
  return table.rows.empty() ? "" : aligned(table) + "\n";
}

std::string assumptions(const sph::Verification& run) {
  std::string out = run.study == sph::Study::deck ? "As run:" : "Not printed in the study; here:";
  for (std::size_t k = 0; k < run.assumptions.size(); ++k) out += (k > 0 ? "; " : " ") + run.assumptions[k];
  return out + ".\n";
}

}  // namespace

std::string verification_text(const std::vector<sph::Verification>& runs, UnitSystem units) {
  TextTable table{{"quantity"}, {}};
  std::vector<const sph::Verification*> all;
  for (const auto& run : runs) {
    all.push_back(&run);
    for (const char* what : {"here", "published", "difference"})
      table.headings.push_back(fmt::format("{} {}", label(run.method), what));
  }
  for (const auto& named : runs.back().quantities) {  // elements have one more
    std::vector<std::string> row{named.name};
    for (const auto& run : runs) {
      const auto each = std::find_if(run.quantities.begin(), run.quantities.end(),
                                     [&](const sph::Quantity& q) { return q.name == named.name; });
      const bool here = each != run.quantities.end();
      row.push_back(here ? written(*each, each->value, units) : "-");
      row.push_back(here ? written(*each, each->reference, units) : "-");
      row.push_back(here ? percent_or_dash(each->difference(), 1) : "-");
    }
    table.rows.push_back(row);
  }
  std::string out = fmt::format("{}, {} apart\n\n{}\n", sph::name_of(runs.front().study),
                                size_name(runs.front().spacing, units), aligned(table));
  out += assumptions(runs.front()) + "\n" + energy_table(all) + "\n" + shape_table(all, units);
  for (const auto& run : runs) out += account(run);
  return out;
}

std::string span_text(const std::vector<sph::SpanRow>& rows, UnitSystem units) {
  TextTable table{{"what the study leaves unsaid"}, {}};
  const auto& quantities = rows.front().run.quantities;
  for (const auto& each : quantities) table.headings.push_back(each.name);
  for (const char* heading : {"residual", "state"}) table.headings.emplace_back(heading);
  std::vector<double> low(quantities.size(), 1e300), high(quantities.size(), -1e300);
  for (const auto& row : rows) {
    std::vector<std::string> cells{row.what};
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      const auto& each = row.run.quantities[q];
      cells.push_back(written(each, each.value, units));
      if (std::isfinite(each.value)) low[q] = std::min(low[q], each.value), high[q] = std::max(high[q], each.value);
    }
    cells.push_back(report::percent(row.run.energy_residual, 2)), cells.push_back(row.run.state);
    table.rows.push_back(cells);
  }
  for (const bool lowest : {true, false}) {
    std::vector<std::string> cells{lowest ? "lowest" : "highest"};
    for (std::size_t q = 0; q < quantities.size(); ++q)
      cells.push_back(written(quantities[q], lowest ? low[q] : high[q], units));
    cells.insert(cells.end(), {"", ""});
    table.rows.push_back(cells);
  }
  std::vector<std::string> cells{"published, " + std::string(label(rows.front().run.method))};
  for (const auto& each : quantities) cells.push_back(written(each, each.reference, units));
  cells.insert(cells.end(), {"", ""});
  table.rows.push_back(cells);
  return "\n" + aligned(table);
}

std::string convergence_text(const std::vector<sph::Convergence>& studies, UnitSystem units) {
  std::string out = fmt::format("{}: values over the spacing, and their limit\n", sph::name_of(studies.front().study));
  out += assumptions(studies.front().runs.front());
  std::vector<const sph::Verification*> runs;
  for (const auto& study : studies) {
    TextTable table{{fmt::format("{} here", label(study.method))}, {}};
    for (const double size : study.sizes) table.headings.push_back(size_name(size, units));
    for (const char* heading :
         {"order", "limit", "r2", "GCI", "published order", "limit", "r2", "GCI", "limits differ"})
      table.headings.emplace_back(heading);
    TextTable errors{{"error against the limit"}, {}};
    for (const double size : study.sizes) errors.headings.push_back(size_name(size, units));
    errors.headings.emplace_back("published, 1 in");
    for (const auto& each : study.quantities) {
      std::vector<std::string> row{each.finest.name}, error{each.finest.name};
      for (const double value : each.values) row.push_back(written(each.finest, value, units));
      row.push_back(each.fit.valid ? report::number(each.fit.order, 2) : "none");
      row.push_back(each.fit.valid ? written(each.finest, each.fit.extrapolated, units) : "-");
      row.push_back(each.fit.valid ? report::number(each.fit.r2, 4) : "-");
      row.push_back(each.gci.valid ? report::percent(each.gci.index, 1) : "-");
      row.push_back(number_or_dash(each.paper.order, 2));
      row.push_back(written(each.finest, each.paper.extrapolated, units));
      row.push_back(number_or_dash(each.paper.r2, 3));
      row.push_back(percent_or_dash(each.paper.gci, 1));
      row.push_back(each.fit.valid ? percent_or_dash(each.fit.extrapolated / each.paper.extrapolated - 1.0, 1) : "-");
      table.rows.push_back(row);
      for (std::size_t k = 0; k < study.sizes.size(); ++k)
        error.push_back(each.errors.empty() ? "-" : report::percent(each.errors[k], 1));
      error.push_back(percent_or_dash(each.paper.finest_error, 1));
      errors.rows.push_back(error);
    }
    out += "\n" + aligned(table) + "\n" + aligned(errors);
    for (const auto& run : study.runs) runs.push_back(&run);
  }
  out += "\n" + energy_table(runs) + "\n" + shape_table(runs, units);
  for (const auto* run : runs) out += account(*run);
  return out;
}

}  // namespace apc::cli
