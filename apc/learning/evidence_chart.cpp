#include "apc/learning/evidence_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/base/markup.h"
#include "apc/base/require.h"
#include "apc/learning/metrics.h"
#include "apc/learning/weighing.h"

namespace apc::learning {
namespace {

double in_unit(double value, const effects::Parameter& p) {
  return p.unit.empty() ? value : value / parse_unit(p.unit).factor;
}

}  // namespace

std::string confusion_matrix(const Study& study) {
  auto singles = best_shapes(study.screen);
  std::erase_if(singles, [&](const Single& s) {
    const Eigen::Index c = s.hypothesis->candidate.columns.front();
    return !(study.screen.scores.gram(c, c) > 0.0);
  });
  if (singles.size() < 2) return "";
  const std::size_t n = std::min<std::size_t>(12, singles.size());
  constexpr double left = 140.0, cell = 46.0, high = 24.0;
  const double bottom = 8.0 + high * static_cast<double>(n);
  std::string svg =
      fmt::format("<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='Which effects look alike'>", bottom + 110.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double y = 8.0 + high * static_cast<double>(i), x = left + cell * static_cast<double>(i);
    svg += fmt::format("<text x='{:.0f}' y='{:.0f}' text-anchor='end'>{}</text>", left - 6.0, y + 16.0,
                       escaped(singles[i].hypothesis->id));
    svg += fmt::format("<text transform='translate({:.0f} {:.0f}) rotate(90)'>{}</text>", x + 0.42 * cell, bottom + 8.0,
                       escaped(singles[i].hypothesis->id));
    for (std::size_t k = 0; k < n; ++k) {
      const double rho = std::abs(correlation_of(study.screen.scores, singles[i].hypothesis->candidate.columns.front(),
                                                 singles[k].hypothesis->candidate.columns.front()));
      const int grey = static_cast<int>(std::lround(245.0 - 200.0 * std::min(1.0, rho)));
      svg += fmt::format(
          "<rect x='{0:.1f}' y='{1:.1f}' width='{2:.1f}' height='{3:.1f}' fill='rgb({4},{4},{4})'/><text x='{5:.1f}' "
          "y='{6:.1f}' text-anchor='middle' style='fill:{7}'>{8:.2f}</text>",
          left + cell * static_cast<double>(k), y, cell - 1.0, high - 1.0, grey,
          left + cell * (static_cast<double>(k) + 0.5), y + 16.0, rho > 0.5 ? "#fff" : "#111", rho);
    }
  }
  return "<p>Correlation (without sign) of what each leading effect does to these runs, after everything uncertain of "
         "bed, tables and instruments: 1 = the same, black. Above 0.9 these runs seldom tell two apart.</p>" +
         svg + "</svg>";
}

std::string parameter_intervals(const Study& study) {
  std::vector<const Claim*> claims;
  for (const Claim& c : study.diagnosis.claims)
    if (!c.applied.effect.parameters.empty() && !c.deviation.empty() && std::isfinite(c.deviation.front()) &&
        claims.size() < 8)
      claims.push_back(&c);
  if (claims.empty()) return "";
  std::string svg = fmt::format("<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='Intervals of amplitudes'>",
                                std::max(92.0, 40.0 * static_cast<double>(claims.size()) + 6.0));
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const Claim& c = *claims[i];
    const effects::Parameter& p = c.applied.effect.parameters.front();
    const double value = c.applied.values.front(), half = 1.96 * c.deviation.front();
    const double low = std::min({p.low, p.neutral, value - half}), high = std::max({p.high, p.neutral, value + half});
    const auto X = [&](double v) { return 190.0 + 380.0 * (v - low) / std::max(1e-300, high - low); };
    const double y = 40.0 * static_cast<double>(i) + 18.0;
    svg += fmt::format("<text x='180' y='{:.0f}' text-anchor='end'>{}.{}, P {:.2f}</text>", y + 4.0, escaped(c.id),
                       escaped(p.name), c.probability);
    svg +=
        fmt::format("<line x1='{0:.1f}' x2='{1:.1f}' y1='{2:.0f}' y2='{2:.0f}' stroke='var(--line)' stroke-width='9'/>",
                    X(std::min(p.low, p.neutral)), X(std::max(p.high, p.neutral)), y);
    svg += fmt::format(
        "<line x1='{0:.1f}' x2='{1:.1f}' y1='{2:.0f}' y2='{2:.0f}' stroke='var(--model)' "
        "stroke-width='3'/><circle cx='{3:.1f}' cy='{2:.0f}' r='4.5' fill='var(--model)'/>",
        X(value - half), X(value + half), y, X(value));
    svg += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.0f}' y2='{2:.0f}' stroke='var(--ink)'/>", X(p.neutral),
                       y - 9.0, y + 9.0);
    svg += fmt::format(
        "<text x='190' y='{0:.0f}'>{1:.3g}</text><text x='570' y='{0:.0f}' text-anchor='end'>{2:.3g}"
        "</text><text x='582' y='{3:.0f}'>{4:.3g} ± {5:.2g} {6}</text>",
        y + 20.0, in_unit(low, p), in_unit(high, p), y + 4.0, in_unit(value, p), in_unit(half / 1.96, p),
        escaped(p.unit));
  }
  return "<p>Amplitudes: pale, the range taken as possible; line, 95 % interval with its middle; upright stroke, the "
         "value "
         "that changes nothing. An interval across the stroke is no finding.</p>" +
         svg + "</svg>";
}

std::string before_and_after(const Study& study) {
  struct Row {
    std::string run;
    double before = 0.0, after = 0.0;
    std::string stop;
  };
  std::vector<Row> rows;
  double most = 1e-9;
  for (const LeftOut& one : study.held_out.runs) {
    Row row{one.run, one.before.total, one.after.total, ""};
    if (one.before.stop && one.after.stop)
      row.stop = fmt::format("stop {:+.1f} → {:+.1f} m", one.before.stop->error, one.after.stop->error);
    most = std::max({most, row.before, row.after});
    rows.push_back(row);
  }
  if (rows.empty()) return "";
  std::string svg = fmt::format("<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='Error before and after'>",
                                38.0 * static_cast<double>(rows.size()) + 6.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = 38.0 * static_cast<double>(i) + 4.0;
    const Row& row = rows[i];
    svg += fmt::format("<text x='110' y='{:.0f}' text-anchor='end'>{}</text>", y + 18.0, escaped(row.run));
    svg += fmt::format(
        "<rect x='120' y='{:.0f}' width='{:.1f}' height='13' class='bar'/><text x='{:.0f}' y='{:.0f}'>"
        "{:.1f} before</text>",
        y, std::max(1.0, 330.0 * row.before / most), 126.0 + 330.0 * row.before / most, y + 11.0, row.before);
    svg += fmt::format(
        "<rect x='120' y='{:.0f}' width='{:.1f}' height='13' fill='none' stroke='var(--model)' "
        "stroke-width='2'/><text x='{:.0f}' y='{:.0f}'>{:.1f} after; {}</text>",
        y + 15.0, std::max(1.0, 330.0 * row.after / most), 126.0 + 330.0 * row.after / most, y + 27.0, row.after,
        row.stop);
  }
  return fmt::format(
             "<p>Every run predicted from the others, without and with the effects; beside them one strength for the "
             "bed is fitted. Root mean square of the errors of speed, acceleration and stop over the larger of noise "
             "and 2 % of the range. All runs (geometric mean): {:.2f} before, {:.2f} after{}.</p>",
             study.held_out.before, study.held_out.after,
             study.held_out.helps() ? "" : "; that is no help, and the effects are not added to the model") +
         svg + "</svg>";
}

}  // namespace apc::learning
