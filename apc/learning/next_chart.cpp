#include "apc/learning/next_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/base/markup.h"
#include "apc/base/units.h"
#include "apc/learning/page_start.h"

namespace apc::learning {
namespace {

constexpr double left = 86.0, top = 10.0, wide = 610.0, high = 34.0;

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& one : list) text += (text.empty() ? "" : ", ") + one;
  return text;
}

/// One grey: the darker, the further apart; 6 deviations are black. Print and grey screens show the same.
std::string shade(double share) {
  const double v = std::clamp(share, 0.0, 1.0);
  const int grey = static_cast<int>(std::lround(245.0 - 200.0 * v));
  return fmt::format("rgb({0},{0},{0})", grey);
}

std::string number_or_dash(double value, double unit, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value / unit, digits) : "–";
}

}  // namespace

std::string next_map(const NextPlan& plan, std::size_t set) {
  const std::size_t n = plan.speeds.size(), m = plan.masses.size();
  double most = plan.sharpens ? 0.0 : 6.0;
  if (plan.sharpens)
    for (const CandidateRun& c : plan.candidates)
      if (c.simulated) most = std::max(most, c.separation[set]);
  const double width = wide / static_cast<double>(n), floor = top + high * static_cast<double>(m);
  std::string svg = fmt::format(
      "<svg viewBox='0 0 720 {:.0f}' role='img' aria-label='Expected separation by speed and "
      "mass'>",
      floor + 42.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < m; ++k) {
      const CandidateRun& c = plan.at(i, k);
      const double x = left + width * static_cast<double>(i), y = floor - high * static_cast<double>(k + 1);
      const double value = c.simulated ? c.separation[set] : 0.0;
      svg += fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}' stroke='var(--line)'/>",
                         x, y, width, high, c.simulated ? shade(value / std::max(1e-9, most)) : "none");
      const bool best = !plan.best.empty() && &plan.candidates[plan.best.front()] == &c;
      if (best)
        svg += fmt::format(
            "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='none' stroke='var(--model)' "
            "stroke-width='3'/>",
            x + 2.0, y + 2.0, width - 4.0, high - 4.0);
      if (c.simulated)
        svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle' style='fill:{}'>{:.1f}{}</text>",
                           x + 0.5 * width, y + 0.5 * high + 4.0, value / std::max(1e-9, most) > 0.5 ? "#fff" : "#111",
                           value, c.stops ? "" : "*");
    }
  for (std::size_t i = 0; i < n; ++i)
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{:.0f}</text>",
                       left + width * (static_cast<double>(i) + 0.5), floor + 16.0, plan.speeds[i] / units::kt);
  for (std::size_t k = 0; k < m; ++k)
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{:.1f} t</text>", left - 6.0,
                       floor - high * (static_cast<double>(k) + 0.5) + 4.0, plan.masses[k] / 1000.0);
  return svg + fmt::format("<text x='{:.0f}' y='{:.0f}' text-anchor='middle'>entry speed, kt</text></svg>",
                           left + 0.5 * wide, floor + 34.0);
}

std::string next_section(const NextPlan& plan) {
  std::string names;
  for (const Contender& c : plan.contenders) names += (names.empty() ? "" : ", ") + escaped(c.name());
  std::string html =
      plan.sharpens
          ? fmt::format(
                "<p>One explanation stands: {}. Numbers: how many standard deviations an effect of usual size "
                "would stand out once the run is made, in the median over the catalogue; {:.1f} now. All "
                "instruments on board.</p>",
                names, plan.sharpness_now)
          : fmt::format(
                "<p>What stands: {}. Numbers: expected separation, in standard deviations, of the two that are "
                "hardest to tell apart; all instruments on board.</p>",
                names);
  for (std::size_t p = 0; p < plan.hopeless.size(); ++p)
    if (plan.hopeless[p])
      html += fmt::format("<p>No run of this grid separates {} from {}.</p>",
                          escaped(plan.contenders[plan.pairs[p][0]].name()),
                          escaped(plan.contenders[plan.pairs[p][1]].name()));
  for (const Contender& c : plan.contenders)
    if (std::any_of(c.effects.begin(), c.effects.end(), [](const effects::Applied& e) { return e.effect.fine; }))
      html += "<p>" + escaped(c.name()) +
              ": joints are finer than the means compared here; an accelerometer's whole record separates them better "
              "than the numbers say.</p>";
  html += next_map(plan, plan.sets.size() - 1);
  html +=
      "<p>Framed: the recommended run. *: by at least one explanation it leaves the bed. Empty: not "
      "simulated.</p><div class='wide'><table><tr><th>speed<th>mass<th>instruments<th>separation</tr>";
  for (std::size_t i = 0; i < plan.best.size(); ++i) {
    const CandidateRun& c = plan.candidates[plan.best[i]];
    html += fmt::format("<tr><td>{:.0f} kt<td>{:.1f} t<td>{}<td>{:.1f} σ</tr>", c.speed / units::kt, c.mass / 1000.0,
                        joined(plan.sets[plan.best_set[i]].names()), c.separation[plan.best_set[i]]);
  }
  html += "</table></div>";
  if (plan.best.empty()) return html;
  const CandidateRun& c = plan.candidates[plan.best.front()];
  html += fmt::format(
      "<h3>What each would show at {:.0f} kt and {:.1f} t</h3><div class='wide'><table "
      "style='font-size:.8em;min-width:0'><tr><th>if it is<th>stops "
      "at, m<th>peak, g<th>mean, g<th>nose drag peak, kN<th>mean, kN<th>nose rut, mm<th>main rut, mm</tr>",
      c.speed / units::kt, c.mass / 1000.0);
  for (std::size_t i = 0; i < c.expects.size(); ++i) {
    const Expectation& e = c.expects[i];
    html += fmt::format("<tr><td>{}<td>{}<td>{:.2f}<td>{:.2f}<td>{:.0f}<td>{:.0f}<td>{:.0f}<td>{:.0f}</tr>",
                        escaped(plan.contenders[i].name()),
                        std::isfinite(e.stop) ? number_or_dash(e.stop, 1.0, 1)
                                              : fmt::format("leaves at {:.0f} kt", e.exit_speed / units::kt),
                        e.peak_deceleration / units::g0, e.mean_deceleration / units::g0, e.peak_nose_drag / units::kN,
                        e.mean_nose_drag / units::kN, e.nose_rut / units::mm, e.main_rut / units::mm);
  }
  return html + "</table></div>";
}

std::string next_page(const NextPlan& plan, const std::string& title) {
  return page_start(title) + "<h2>Which run next</h2>" + next_section(plan) + "</html>\n";
}

}  // namespace apc::learning
