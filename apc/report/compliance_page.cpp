#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apc/base/units.h"
#include "apc/report/compliance_record.h"
#include "apc/report/study_chart.h"
#include "apc/report/study_frame.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

const Measure share{{"%", 0.01, 0}, {"%", 0.01, 0}};

std::string case_name(const ComplianceRecord& record, std::size_t k) {
  const auto& each = record.design.fleet.cases[k];
  return each.aircraft + ", " + each.name;
}

std::string finding_table(const std::vector<Finding>& all) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& each : all) {
    const char* look = each.verdict == Verdict::pass ? "pass" : each.verdict == Verdict::fail ? "fail" : "open";
    rows.push_back(
        {"<span class=\"wrap\">" + each.clause + "</span>", fmt::format("@{}|{}", look, text(each.verdict)),
         "<span class=\"tag " + std::string(each.read ? "good\">read" : "open\">recalled") + "</span> " + each.basis,
         each.evidence});
  }
  return "<div class=\"requirements\">" +
         table({"requirement", "result", "status of the clause", "evidence"}, rows, Cells::text) + "</div>";
}

/// Runway end, safety area and bed from above, to one scale.
std::string site_plan(const ComplianceRecord& record) {
  const auto& bed = record.design.bed;
  const auto& site = record.site;
  const double ahead = std::max(site ? site->safety_length : 0.0, bed.setback + bed.length()), before = 0.25 * ahead;
  const double across = std::max(site ? site->safety_width : 0.0, bed.width);
  constexpr double width = 1000, edge = 20;
  const double scale = (width - 2 * edge) / (ahead + before), tall = across * scale + 2 * edge + 20;
  const auto x = [&](double along) { return edge + (along + before) * scale; };
  const auto box = [&](const char* look, double from, double to, double wide) {
    return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", look, pixel(x(from)),
                       pixel(0.5 * (tall - 20) - 0.5 * wide * scale), pixel((to - from) * scale), pixel(wide * scale));
  };
  std::string out = fmt::format(
      "<div class=\"wide\"><svg class=\"plan\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"site plan\">", width,
      pixel(tall));
  if (site) out += box("area", 0, site->safety_length, site->safety_width);
  out += box("runway", -before, 0, site ? site->runway_width : bed.width);
  out += box("plan-bed", bed.setback, bed.setback + bed.length(), bed.width);
  out += fmt::format("<path class=\"zero\" stroke-dasharray=\"12 5 2 5\" d=\"M{},{}H{}\"/>", pixel(x(-before)),
                     pixel(0.5 * (tall - 20)), pixel(x(ahead)));
  const auto words = [&](double along, double y, const char* anchor, const std::string& text) {
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", pixel(x(along)), pixel(y), anchor, text);
  };
  const auto length = [](double value) {
    return either("tspan", shown(value, measure::distance, UnitSystem::field),
                  shown(value, measure::distance, UnitSystem::si));
  };
  const double middle = 0.5 * (tall - 20), low = tall - 6;
  words(-0.5 * before, middle - 8, "middle", "runway");
  words(-0.5 * before, middle + 20, "middle", length(site ? site->runway_width : bed.width) + " wide");
  words(0.5 * bed.setback, low, "end", "set-back " + length(bed.setback));
  words(bed.setback + 0.5 * bed.length(), low, "start", "bed " + length(bed.length()) + " × " + length(bed.width));
  if (!site) return out + "</svg></div>\n";
  words(site->safety_length - 0.01 * ahead, middle - 0.5 * site->safety_width * scale + 18, "end",
        "safety area " + length(site->safety_length) + " × " + length(site->safety_width));
  // The runway points right; north is turned back by its heading.
  const double cx = x(-before) + 24, cy = 44, turn = site->heading - 0.5 * std::numbers::pi;
  const double dx = -std::sin(turn), dy = -std::cos(turn);
  out += fmt::format(
      "<path class=\"surface\" d=\"M{},{}L{},{}\"/><circle class=\"cg-mark\" cx=\"{}\" cy=\"{}\" r=\"3\"/>"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">N</text>",
      pixel(cx - 18 * dx), pixel(cy - 18 * dy), pixel(cx + 18 * dx), pixel(cy + 18 * dy), pixel(cx + 18 * dx),
      pixel(cy + 18 * dy), pixel(cx + 30 * dx), pixel(cy + 30 * dy + 4));
  return out + fmt::format("</svg></div>\n<p class=\"sub\">Overrun towards {:.1f}° true from {:.5f}°, {:.5f}°.</p>\n",
                           site->heading / units::deg, site->end.latitude / units::deg,
                           site->end.longitude / units::deg);
}

std::string section(const ComplianceRecord& record) {
  const auto& bed = record.design.bed;
  Chart chart{"Depth of the bed",
              measure::distance,
              measure::depth,
              "distance from the leading edge",
              {{escaped(bed.material), "main", bed.distance, bed.depth}},
              {},
              {},
              {},
              "",
              0.0};
  return figure(chart);
}

/// Loads of every gear over distance, as shares of their limits; drag in full lines, vertical load dashed.
std::string history(const ComplianceRecord& record, std::size_t k) {
  const auto& result = record.cases[k].result;
  const bool limit = record.design.fleet.limits.criterion == study::Criterion::limit;
  Chart chart{case_name(record, k) + ": load per strut, share of its " + std::string(limit ? "limit" : "ultimate"),
              measure::distance,
              share,
              "nose wheel from the leading edge",
              {},
              {},
              {{limit ? "limit" : "ultimate", "limit", 1.0}},
              {},
              "",
              0.0};
  const auto rows = thinned_rows(result.history, 400);  // with every peak
  const auto add = [&](const std::string& name, const std::string& look, const std::vector<double>& load, double most) {
    if (most <= 0) return;
    ChartLine line{name, look, {}, {}};
    for (const auto i : rows)
      if (result.history.distance[i] > -3)
        line.x.push_back(result.history.distance[i]), line.y.push_back(load[i] / most);
    chart.lines.push_back(std::move(line));
  };
  for (std::size_t g = 0; g < result.gears.size() && g < result.history.gears.size(); ++g) {
    const auto& gear = result.gears[g];
    const auto& loads = result.history.gears[g];
    const double struts = std::max(1, gear.struts);
    add(escaped(gear.name) + " drag", line_look(g), loads.drag,
        struts * (limit ? gear.drag_limit : gear.drag_ultimate));
    add(escaped(gear.name) + " vertical", "rut-" + line_look(g), loads.vertical,
        struts * (limit ? 1.0 : 1.5) * gear.vertical_limit);
  }
  return chart.lines.empty() ? "" : figure(chart);
}

/// What effects learned from measured runs would change.
std::string learned_table(const ComplianceRecord& record) {
  const std::string heading = "<h2>What learned effects would change</h2>\n";
  if (record.learned.names.empty())
    return heading +
           "<p>No learned effects were given (--model FILE): nothing in this report was corrected by a "
           "measured run.</p>\n";
  std::string names;
  for (const auto& name : record.learned.names) names += (names.empty() ? "" : ", ") + escaped(name);
  std::vector<std::vector<std::string>> rows;
  bool outside = false;
  for (std::size_t k = 0; k < record.cases.size(); ++k) {
    const auto& each = record.cases[k];
    const double speed = each.result.entry_speed;
    const bool far = speed < record.learned.slowest - 0.5 || speed > record.learned.fastest + 0.5;
    outside = outside || far;
    rows.push_back({escaped(case_name(record, k)), both(each.result.stop_distance, measure::distance),
                    both(each.learned_stop, measure::distance), percent(each.use, 1),
                    fmt::format("@{}|{}", each.learned_use > 1 ? "fail" : "", percent(each.learned_use, 1)),
                    far ? "@open|extrapolated" : "within"});
  }
  return heading + "<p>Effects: " + names + ", learned on runs from " + both(record.learned.slowest, measure::speed) +
         " to " + both(record.learned.fastest, measure::speed) +
         ". The requirements above are judged without them.</p>\n" +
         table(
             {"case", "stop", "with the effects", "largest load of its limit", "with the effects", "speeds learned on"},
             rows, Cells::numbers);
}

std::string case_tables(const ComplianceRecord& record) {
  std::vector<std::vector<std::string>> fleet, doubt;
  for (std::size_t k = 0; k < record.cases.size(); ++k) {
    const auto& each = record.cases[k];
    const auto& result = each.result;
    const bool stopped = std::isfinite(result.stop_distance);
    fleet.push_back({escaped(case_name(record, k)), both(result.mass, measure::mass),
                     both(result.entry_speed, measure::speed), number(record.design.fleet.cases[k].overrun.braking, 2),
                     stopped ? both(result.stop_distance, measure::distance)
                             : "@fail|left at " + both(result.exit_speed, measure::speed),
                     both(result.peak_deceleration, measure::acceleration),
                     fmt::format("@{}|{}", each.use > 1 ? "fail" : "", percent(each.use, 1)),
                     both(each.arrest_speed, measure::speed), both(each.intact_speed, measure::speed)});
    std::string inside;
    for (const auto& coverage : result.coverage)
      inside += (inside.empty() ? "" : "<br>") + escaped(coverage.gear) + " " + percent(coverage.inside, 0);
    doubt.push_back({escaped(case_name(record, k)), percent(each.table_error, 1),
                     both(each.stop_low, measure::distance) + " – " + both(each.stop_high, measure::distance),
                     percent(each.use_low, 1) + " – " + percent(each.use_high, 1), inside});
  }
  return "<h2>Fleet</h2>\n" +
         table({"case", "mass", "exit speed", "braking", "stop", "peak", "largest load of its limit", "arrested up to",
                "within limits up to"},
               fleet, Cells::numbers) +
         "<h2>What the load tables' own error does</h2>\n<p>Drag and vertical load of all tires scaled down and up by "
         "the largest "
         "leave-one-out error of the tables' drag. Inside: share of the time within the tables' fitted range.</p>\n" +
         table({"case", "table error", "stop", "largest load of its limit", "inside"}, doubt, Cells::numbers);
}

}  // namespace

std::string compliance_page(const ComplianceRecord& record) {
  const auto all = findings(record);
  const auto count = [&](Verdict verdict) {
    return std::to_string(
        std::count_if(all.begin(), all.end(), [&](const Finding& each) { return each.verdict == verdict; }));
  };
  std::string header = "<h1>Compliance of " + escaped(record.design.bed.name) +
                       "</h1><p class=\"sub\">with FAA AC 150/5220-22B as far as "
                       "this project knows it; " +
                       escaped(record.site ? record.site->name : "no site given") + "</p>\n<div class=\"cards\">";
  header +=
      card(count(Verdict::pass) == "0" ? "" : "good", "Pass", count(Verdict::pass), "clauses read in a source and met");
  header += card(count(Verdict::fail) == "0" ? "good" : "bad", "Fail", count(Verdict::fail),
                 "clauses read in a source and not met");
  header += card("warn", "Not verified", count(Verdict::not_verified),
                 "clauses recalled only: read them before relying on them");
  header += card("", "Not checked", count(Verdict::not_checked), "clauses no simulation can decide");
  header +=
      "</div>\n<p class=\"warning\">A prediction, not a measurement: loads come from simulated tires in simulated "
      "foam, and no "
      "arrestment of these aircraft in this bed was measured.</p>\n";
  std::string body =
      "<h2>Site plan</h2>\n" + site_plan(record) + "<div class=\"plots\">\n" + section(record) + "</div>\n";
  body += "<h2>Requirements</h2>\n" + finding_table(all) + case_tables(record) + learned_table(record) +
          "<h2>Load histories against limits</h2>\n<div class=\"plots\">\n";
  for (std::size_t k = 0; k < record.cases.size(); ++k) body += history(record, k);
  body += "</div>\n<h2>Certificate of the design</h2>\n";
  const auto& design = record.design;
  body += fmt::format(
      "<p>{}; two methods ({} and {}) differ by {}; gradients within {}; stationarity {:.1e}. Held by: {}.</p>\n",
      design.agreed ? "Two methods agree" : "<b>Not certified</b>",
      design.methods.empty() ? "-" : design.methods.front(), design.methods.empty() ? "-" : design.methods.back(),
      percent(design.difference, 3), percent(design.gradient_error, 2), design.stationarity,
      design.active.empty() ? "-" : escaped(design.active.front()));
  std::vector<std::vector<std::string>> tables;
  std::vector<std::string> known;
  for (const auto& each : record.cases)
    for (const auto& loads : each.model.tables) {
      if (std::find(known.begin(), known.end(), loads.tire().name) != known.end()) continue;
      known.push_back(loads.tire().name);
      std::string quality;
      for (const auto& fit : loads.quality())
        quality += fmt::format("{}{} {} (leave one out)", quality.empty() ? "" : "<br>", fit.response,
                               percent(fit.loo_rms_relative, 1));
      tables.push_back({escaped(loads.tire().name), std::to_string(loads.provenance().runs), quality,
                        escaped(loads.provenance().source)});
    }
  body +=
      "<h2>What was measured, what was not</h2>\n<p>Load tables are fits to simulations; their errors are those of the "
      "fit, not of "
      "the physics. Aircraft data marked as estimated in their files are estimates.</p>\n" +
      table({"tire", "runs", "error of the fit", "source"}, tables, Cells::text);
  body += "<h2>How to make this report again, byte for byte</h2>\n" + manifest_section(record.manifest);
  return framed("Compliance of " + record.design.bed.name, header, body,
                "apc, the Arrestor Prediction Code. The same inputs give the same bytes.");
}

}  // namespace apc::report
