#include "apc/learning/learn_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apc/base/markup.h"
#include "apc/effects/other_forms.h"
#include "apc/learning/along_chart.h"
#include "apc/learning/evidence_chart.h"
#include "apc/learning/missing_force.h"
#include "apc/learning/next_chart.h"
#include "apc/learning/page_start.h"

namespace apc::learning {
namespace {

template <class... Parts>
std::string format(const char* pattern, Parts... parts) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, parts...);
  return text;
}

std::string name_of_explanation(const Explanation& x) {
  std::string name = x.label;
  for (const std::string& id : x.ids) name += (name.empty() ? "" : " + ") + id;
  return name.empty() ? "nothing missing" : name;
}

/// Horizontal bars of probability with the log evidence written beside them.
std::string ranked(const Diagnosis& d) {
  const std::size_t n = std::min<std::size_t>(10, d.explanations.size());
  std::string svg =
      format("<svg viewBox='0 0 720 %d' role='img' aria-label='Ranked explanations'>", static_cast<int>(26 * n + 10));
  for (std::size_t i = 0; i < n; ++i) {
    const Explanation& x = d.explanations[i];
    const double y = 26.0 * static_cast<double>(i) + 6.0;
    svg += format("<text x='250' y='%.0f' text-anchor='end'>", y + 14) + escaped(name_of_explanation(x)) + "</text>";
    svg += format("<rect x='260' y='%.0f' width='%.1f' height='18' class='bar'/>", y,
                  std::max(1.0, 300.0 * x.probability));
    svg += format("<text x='%.0f' y='%.0f'>P %.2f, ln E %+.0f</text>", 268.0 + 300.0 * x.probability, y + 14,
                  x.probability, x.log_evidence);
  }
  return svg + "</svg>";
}

/// Measured samples and the model's line of one channel against time.
std::string overlay(const Background& b, std::size_t r, const Channel& channel, std::size_t c) {
  const auto& h = b.traces[r].result.history;
  if (h.time.empty() || channel.time.empty()) return "";
  double low = 1e300, high = -1e300;
  for (const double v : channel.value) low = std::min(low, v), high = std::max(high, v);
  const double end = channel.time.back(), begin = std::min(0.0, channel.time.front());
  const auto X = [&](double t) { return 50.0 + 640.0 * (t - begin) / std::max(1e-6, end - begin); };
  const auto Y = [&](double v) { return 150.0 - 130.0 * (v - low) / std::max(1e-9, high - low); };
  std::string svg = "<svg viewBox='0 0 720 180' role='img'><g class='dots'>";
  const std::size_t stride = std::max<std::size_t>(1, channel.time.size() / 300);
  for (std::size_t i = 0; i < channel.time.size(); i += stride)
    svg += format("<circle cx='%.1f' cy='%.1f' r='1.4'/>", X(channel.time[i]), Y(channel.value[i]));
  svg += "</g><polyline class='model' points='";
  const Signal signal(h, channel, b.data->aircraft);
  for (double t = std::max(begin, h.time.front()); t < std::min(end, h.time.back()); t += (end - begin) / 400.0)
    svg += format("%.1f,%.1f ", X(t),
                  std::clamp(Y((1.0 + b.eta[b.layout.runs[r].scale[c]]) * signal(t) + b.eta[b.layout.runs[r].bias[c]]),
                             0.0, 175.0));
  svg += format(
      "'/><text x='50' y='172'>%.1f s</text><text x='690' y='172' text-anchor='end'>%.1f s</text><text x='46' y='20' "
      "text-anchor='end'>%.3g</text><text x='46' y='150' text-anchor='end'>%.3g</text></svg>",
      begin, end, high, low);
  return svg;
}

/// Runs as rows, distance in the bed across, colour = missing longitudinal force over weight, from the block strengths
/// the fit needed.
std::string strip(const Background& b) {
  double reach = 1.0;
  for (std::size_t r = 0; r < b.training; ++r)
    reach = std::max(reach, static_cast<double>(b.layout.runs[r].blocks) * b.layout.spacing);
  std::string svg = format("<svg viewBox='0 0 720 %d' role='img' aria-label='Strength the fit needed along the bed'>",
                           static_cast<int>(24 * b.training + 30));
  for (std::size_t r = 0; r < b.training; ++r) {
    const RunLayout& at = b.layout.runs[r];
    svg += format("<text x='60' y='%d' text-anchor='end'>", static_cast<int>(24 * r + 18)) + escaped(b.runs[r].id) +
           "</text>";
    for (Eigen::Index k = 0; k < at.blocks; ++k) {
      const double v = std::clamp(b.eta[at.main_blocks + k] / 0.25, -1.0, 1.0),
                   x = 66.0 + 640.0 * static_cast<double>(k) * b.layout.spacing / reach;
      const int red = static_cast<int>(v < 0 ? 230 : 230 * (1 - v)),
                blue = static_cast<int>(v > 0 ? 230 : 230 * (1 + v)), green = static_cast<int>(230 * (1 - std::abs(v)));
      svg += format("<rect x='%.1f' y='%d' width='%.1f' height='20' fill='rgb(%d,%d,%d)'/>", x,
                    static_cast<int>(24 * r + 4), 640.0 * b.layout.spacing / reach + 0.5, red, green, blue);
      if (std::abs(v) > 0.32)  // a sign, for print and eyes that see no colour
        svg += format("<text x='%.1f' y='%d' text-anchor='middle' style='fill:#111'>%s</text>",
                      x + 320.0 * b.layout.spacing / reach, static_cast<int>(24 * r + 18), v > 0.0 ? "+" : "−");
    }
  }
  svg += format(
      "<text x='66' y='%d'>0 m</text><text x='706' y='%d' text-anchor='end'>%.0f m from the leading edge</text></svg>",
      static_cast<int>(24 * b.training + 22), static_cast<int>(24 * b.training + 22), reach);
  return svg;
}

/// Smallest detectable amplitudes in the units of their effects.
std::string detectable(const Study& study) {
  std::string html = "<p>";
  for (const auto& [name, value] : study.diagnosis.smallest_detectable) {
    const std::string id = name.substr(0, name.find('.'));
    std::string unit;
    for (const Hypothesis& h : study.screen.hypotheses)
      if (h.id == id && !h.applied.effect.parameters.empty()) unit = h.applied.effect.parameters.front().unit;
    html += (html.size() > 3 ? "; " : "") + escaped(name) +
            format(" %.3g", unit.empty() ? value : value / parse_unit(unit).factor) + (unit.empty() ? "" : " ") +
            escaped(unit);
  }
  return html + ".</p>";
}

}  // namespace

std::string learn_page(const Study& study, const NextPlan* next) {
  const Background& b = study.background;
  const Diagnosis& d = study.diagnosis;
  std::string page =
      page_start(b.data->title) +
      "<p style='color:var(--bad)'><strong>Experimental: the probabilities are not calibrated; quote none "
      "of them.</strong></p><p><strong>Verdict: " +
      text(d.verdict) + "</strong>";
  if (!d.learned.empty()) page += ": a force that follows \"" + escaped(d.learned) + "\", none of the catalogue";
  page +=
      ".</p><h2>What explains the runs</h2><p>Probability after the background: block scatter, table error, entry "
      "conditions and instruments.</p>" +
      ranked(d);
  if (!d.claims.empty()) {
    page += "<div class='wide'><table><tr><th>effect<th>probability<th>family-wise p<th>size (SI)<th>law</tr>";
    for (const Claim& c : d.claims) {
      const double deviation = c.deviation.empty() ? std::nan("") : c.deviation.front();
      page += "<tr><td style='white-space:nowrap'>" + escaped(effects::named(c.applied.effect)) +
              format("<td>%.2f<td>%.4f<td>%.4g ± %.2g<td>", c.probability, c.p_family_wise, c.applied.values.front(),
                     deviation) +
              escaped(c.applied.effect.law) + "</tr>";
    }
    page += "</table></div>";
  }
  const std::string intervals = parameter_intervals(study);
  if (!intervals.empty()) page += "<h2>How well the amplitudes are known</h2>" + intervals;
  page += "<h2>Cannot be told apart</h2>";
  if (d.rivals.empty()) page += "<p>No two leading effects look alike in these runs.</p>";
  for (const Rival& r : d.rivals)
    page += "<p>" + escaped(r.a) + " | " + escaped(r.b) +
            format(": correlation %+.2f, %.1f deviations apart</p>", r.correlation, r.separability);
  page += confusion_matrix(study);
  if (next) page += "<h2>Which run next</h2>" + next_section(*next);
  page += "<h2>Not missing above</h2><p>Smallest amplitude that would have been seen with 90 % power.</p>" +
          detectable(study);
  page +=
      "<h2>Where it fails</h2><p>Strength of the bed the fit needed under the main gear: red and − softer, blue and + "
      "harder, full colour at 25 %, signs from 8 %.</p>" +
      strip(b) + along_charts(study) + missing_force_charts(study);
  const std::string proof = before_and_after(study);
  if (!proof.empty()) page += "<h2>Before and after</h2>" + proof;
  page +=
      "<h2>Measured and fitted</h2><p>Dots measured, line the model with its background fitted, led along the measured "
      "speed.</p>";
  for (std::size_t r = 0; r < b.training; ++r)
    for (std::size_t c = 0; c < b.runs[r].channels.size(); ++c)
      page += "<h3>" + escaped(b.runs[r].id) + ", " + name_of(b.runs[r].channels[c].quantity) + " (SI)</h3>" +
              overlay(b, r, b.runs[r].channels[c], c);
  if (!b.data->remarks.empty()) page += "<h2>Data</h2>";
  for (const DataRemark& remark : b.data->remarks)
    page += "<p>" + escaped(remark.run) + " " + escaped(remark.channel) + ": " + escaped(remark.text) + "</p>";
  return page + "</html>\n";
}

}  // namespace apc::learning
