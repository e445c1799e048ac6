#include <fmt/format.h>

#include <cmath>

#include "apc/report/design_record.h"
#include "apc/report/study_chart.h"
#include "apc/report/study_frame.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

std::string cards(const DesignRecord& record) {
  const auto& design = record.design;
  std::string out = "<div class=\"cards\">";
  if (!design.feasible) return out + card("bad", "Verdict", "Not feasible", escaped(design.reason)) + "</div>\n";
  const auto& bed = design.built.bed;
  const auto& certificate = design.certificate;
  out += card(
      "", "Bed as built", both(bed.length(), measure::distance),
      both(bed.maximum_depth(), measure::depth) + " deep at most, " + both(bed.width, measure::distance) + " wide");
  out += card("", "Material", both(bed.volume(), measure::volume), escaped(bed.material));
  out += card(design.built.worst_use <= 1 ? "good" : "bad", "Largest load", percent(design.built.worst_use, 1),
              "of its " + std::string(study::text(record.fleet.limits.criterion)) + ": " +
                  escaped(describe(design.built.worst, record.fleet)));
  const bool certified = design::certified(certificate);
  out += card(certified ? "good" : "warn", certified ? "Certified optimum" : "Optimality not shown",
              percent(certificate.difference, 3),
              std::string("between ") + design::text(certificate.first.method) + " and " +
                  design::text(certificate.second.method) + ", from two starts");
  if (design.objective == design::Objective::speed)
    out += card("", "Speeds", percent(design.speed_factor, 1), "of those asked for");
  else if (design.uniform.feasible)
    out += card("", "Against one depth", number(100 * (1 - design.length / design.uniform.length), 1) + " %",
                "shorter than the best bed of one depth (" + both(design.uniform.depth, measure::depth) + ", " +
                    both(design.uniform.length, measure::distance) + ")");
  return out + "</div>\n";
}

std::string depth_chart(const DesignRecord& record) {
  const auto& design = record.design;
  const auto& bed = design.built.bed;
  Chart chart{"Depth along the bed",
              measure::distance,
              measure::depth,
              "distance from the leading edge",
              {},
              {},
              {},
              {},
              "",
              0.0};
  ChartLine optimum{"optimum", "nose", {0.0}, {0.0}},
      built{"as built, in rows of blocks", "main", bed.distance, bed.depth};
  for (const double at : design.profile.stations())
    if (at < design.length) optimum.x.push_back(at), optimum.y.push_back(design.profile.depth_at(at));
  optimum.x.push_back(design.length), optimum.y.push_back(design.profile.depth_at(design.length));
  chart.lines = {optimum, built};
  if (design.uniform.feasible)
    chart.lines.push_back({"best bed of one depth",
                           "rut-total",
                           {0.0, record.fleet.bed.maximum_ramp, design.uniform.length},
                           {0.0, design.uniform.depth, design.uniform.depth}});
  return figure(chart);
}

/// Drag of the nose gear of every case over distance, as a share of its limit.
std::string use_chart(const DesignRecord& record) {
  const Measure share{{"%", 0.01, 0}, {"%", 0.01, 0}};
  Chart chart{"Nose-gear drag of every case, share of its limit",
              measure::distance,
              share,
              "nose wheel from the leading edge",
              {},
              {},
              {{"limit", "limit", 1.0}},
              {},
              "",
              0.0};
  const auto& built = record.design.built;
  for (std::size_t k = 0; k < built.results.size(); ++k) {
    const auto& result = built.results[k];
    for (std::size_t g = 0; g < result.gears.size() && g < result.history.gears.size(); ++g) {
      const auto& gear = result.gears[g];
      const double limit =
          record.fleet.limits.criterion == study::Criterion::limit ? gear.drag_limit : gear.drag_ultimate;
      if (gear.name != "nose" || limit <= 0) continue;
      const auto& history = result.history;
      ChartLine line{escaped(record.fleet.cases[k].aircraft + ", " + record.fleet.cases[k].name), line_look(k), {}, {}};
      for (std::size_t i = 0; i < history.distance.size(); i += 4)
        if (history.distance[i] >= -5) {
          line.x.push_back(history.distance[i]);
          line.y.push_back(history.gears[g].drag[i] / gear.struts / limit);
        }
      chart.lines.push_back(line);
    }
  }
  return chart.lines.empty() ? "" : figure(chart);
}

std::string front_chart(const DesignRecord& record) {
  if (record.front.empty()) return "";
  Chart chart{"What may be traded: length against margin",
              {{"%", 0.01, 0}, {"%", 0.01, 0}},
              measure::distance,
              "margin kept by every load",
              {},
              {},
              {},
              {},
              "before rounding to blocks",
              0.0};
  ChartLine shortest{"shortest bed", "nose", {}, {}}, least{"least material", "main", {}, {}};
  for (const auto& point : record.front) {
    auto& line = point.objective == design::Objective::length ? shortest : least;
    line.x.push_back(point.margin), line.y.push_back(point.length);
  }
  for (const auto& line : {shortest, least})
    if (!line.x.empty()) chart.lines.push_back(line);
  return figure(chart);
}

std::string case_table(const DesignRecord& record) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& outcome : record.design.cases) {
    const auto& each = record.fleet.cases[outcome.fleet_case];
    const auto& result = record.design.built.results[outcome.fleet_case];
    rows.push_back(
        {escaped(each.aircraft + ", " + each.name), both(result.entry_speed, measure::speed),
         both(result.mass, measure::mass), number(each.overrun.braking, 2),
         std::isfinite(outcome.stop_distance) ? both(outcome.stop_distance, measure::distance) : "@fail|left the bed",
         both(outcome.max_exit_speed, measure::speed), both(outcome.arrest_speed, measure::speed),
         both(result.peak_deceleration, measure::acceleration),
         fmt::format("@{}|{}",
                     outcome.use > 1      ? "over"
                     : outcome.use > 0.95 ? "near"
                                          : "",
                     percent(outcome.use, 1)),
         "<span class=\"rule\">" + escaped(describe(outcome.active, record.fleet)) + "</span>"});
  }
  return table({"case", "exit speed", "mass", "braking", "stop", "highest exit speed", "arrested up to", "peak",
                "largest load", "nearest limit"},
               rows, Cells::numbers);
}

std::string certificate_section(const DesignRecord& record) {
  const auto& certificate = record.design.certificate;
  std::vector<std::vector<std::string>> methods, active;
  for (const auto& optimum : {certificate.first, certificate.second})
    methods.push_back({design::text(optimum.method), fmt::format("{:.6f}", optimum.objective),
                       optimum.feasible ? "yes" : "@fail|no", std::to_string(optimum.evaluations), optimum.ended});
  for (const auto& each : certificate.active) {
    if (each.constraint.kind == design::Kind::bound) continue;
    auto name = describe(each.constraint, record.fleet);
    if (each.constraint.window >= 0) name += fmt::format(", window {}", each.constraint.window + 1);
    active.push_back({escaped(name), percent(each.use, 2), percent(each.weight, 1)});
  }
  return "<h2>Why this is the best bed</h2>\n<div class=\"two\"><div>" +
         table({"method", "objective", "keeps the limits", "evaluations", "ended"}, methods, Cells::numbers) +
         fmt::format(
             "<p>The objectives differ by {}. Gradients by forward differences agree with central ones over twice the "
             "step "
             "within {}. What is left of the objective's gradient after subtracting the pull of the constraints in "
             "contact "
             "(Karush–Kuhn–Tucker): {:.1e}.</p></div><div>",
             percent(certificate.difference, 4), percent(certificate.gradient_error, 2), certificate.stationarity) +
         table({"constraint that holds it", "at", "weight"}, active, Cells::numbers) +
         "<p>Weight: share of the multipliers; where giving way would shorten the bed most.</p></div></div>\n";
}

std::string rows_section(const DesignRecord& record) {
  std::vector<std::vector<std::string>> rows;
  const auto& blocks = record.design.built.blocks;
  for (const auto& run : row_runs(blocks))
    rows.push_back({run.first == run.last ? std::to_string(run.first) : fmt::format("{}–{}", run.first, run.last),
                    both(static_cast<double>(run.first - 1) * blocks.row_length, measure::distance) + " – " +
                        both(static_cast<double>(run.last) * blocks.row_length, measure::distance),
                    both(run.depth, measure::depth)});
  const auto across = std::ceil(record.fleet.bed.width / record.fleet.bed.block_width - 1e-9);
  return "<h2>Block schedule</h2>\n<p>" + std::to_string(blocks.depth.size()) + " rows of " +
         both(blocks.row_length, measure::distance) + ", " + number(across, 0) +
         " blocks across: " + number(across * static_cast<double>(blocks.depth.size()), 0) +
         " blocks. To the tires the depth runs straight between the "
         "middles of the rows.</p>\n" +
         table({"rows", "from – to", "depth"}, rows, Cells::numbers);
}

}  // namespace

std::string design_page(const DesignRecord& record) {
  const auto& design = record.design;
  std::string header =
      fmt::format("<h1>Bed for {}</h1><p class=\"sub\">objective: {}; {} criterion, counting {}; {} cases</p>\n",
                  escaped(record.fleet.name),
                  design.objective == design::Objective::length    ? "shortest bed"
                  : design.objective == design::Objective::volume  ? "least material"
                  : design.objective == design::Objective::minimax ? "fairest to all aircraft"
                                                                   : "highest speed in a given length",
                  study::text(record.fleet.limits.criterion), escaped(design::counted_loads(record.fleet.limits)),
                  record.fleet.cases.size());
  header += cards(record);
  std::string body;
  if (design.feasible) {
    body += "<h2>The bed</h2>\n<div class=\"plots\">\n" + depth_chart(record) + use_chart(record) +
            front_chart(record) + "</div>\n";
    body += "<h2>What each case gets</h2>\n" + case_table(record) + certificate_section(record) + rows_section(record);
  } else if (!design.certificate.active.empty()) {
    body += certificate_section(record);
  }
  body += fmt::format("<h2>How to make this design again</h2>\n<p>{} overruns simulated in {} s.</p>\n", design.runs,
                      number(record.seconds, 1)) +
          manifest_section(record.manifest);
  return framed("Bed for " + record.fleet.name, header, body,
                "apc, the Arrestor Prediction Code. Loads per strut by the reference method in the bed as built; "
                "distances from the "
                "leading edge to the nose wheel. A prediction with the load tables named above, not a measurement.");
}

}  // namespace apc::report
