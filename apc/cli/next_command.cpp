/// `apc next`: which run would separate what a diagnosis leaves standing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apc/base/file.h"
#include "apc/base/progress.h"
#include "apc/base/require.h"
#include "apc/cli/learn_inputs.h"
#include "apc/cli/text_table.h"
#include "apc/learning/next_chart.h"
#include "apc/learning/next_json.h"

namespace apc::cli {
namespace {

struct NextWords {
  std::string speeds, masses, rivals;
};

/// "inertial,seams+debris,nothing" as sets of ids.
std::vector<std::vector<std::string>> rivals_of(const std::string& text) {
  std::vector<std::vector<std::string>> sets(1);
  std::string word;
  for (const char c : text + ",") {
    if (c != ',' && c != '+') {
      word += c;
      continue;
    }
    require(!word.empty(), "--rivals: \"", text,
            "\" has an empty part. Write effects apart by commas, joined by +: \"inertial,seams+debris,nothing\"");
    if (word != "nothing") sets.back().push_back(word);
    word.clear();
    if (c == ',') sets.emplace_back();
  }
  sets.pop_back();
  return sets;
}

/// "20:60:10 kt" or "30 kt": values from first to last; InputError names the option.
std::vector<double> range_of(const std::string& option, const std::string& text, const Dimension& wanted) {
  const auto unit_at = text.find(' ');
  const std::string numbers = text.substr(0, unit_at), unit = unit_at == std::string::npos ? "" : text.substr(unit_at);
  std::vector<double> parts;
  for (std::size_t from = 0; from <= numbers.size();) {
    const auto to = std::min(numbers.find(':', from), numbers.size());
    parts.push_back(option_quantity(option, numbers.substr(from, to - from) + unit, wanted));
    from = to + 1;
  }
  require((parts.size() == 1 || parts.size() == 3) && parts.front() > 0.0 &&
              (parts.size() == 1 || (parts[1] >= parts[0] && parts[2] > 0.0)),
          option, ": \"", text, "\" is no range. Write first:last:step with a unit, such as \"20:60:10 kt\"");
  if (parts.size() == 1) return parts;
  require((parts[1] - parts[0]) / parts[2] < 40.0, option, ": \"", text,
          "\" is more than 40 values; take larger steps");
  std::vector<double> list;
  for (double x = parts[0]; x <= parts[1] + 1e-6 * parts[2]; x += parts[2]) list.push_back(x);
  return list;
}

std::string comma_list(const std::vector<std::string>& list) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "" : ", ") + one;
  return text;
}

std::string report_text(const learning::NextPlan& plan, report::UnitSystem units) {
  using namespace report::measure;
  const auto shown = [&](double value, const report::Measure& m) { return report::shown(value, m, units); };
  std::string out;
  if (plan.sharpens)
    out += fmt::format(
        "{}: no two explanations to separate. NEXT RUN for the smallest detectable sizes; apart: deviations an effect\n"
        "of usual size would stand out, in the median over the catalogue ({:.1f} without a further run).\n",
        plan.contenders.front().name(), plan.sharpness_now);
  else
    out +=
        "NEXT RUN to separate what cannot be told apart; apart: of the two explanations that are hardest to tell "
        "apart\n";
  TextTable best{{"speed", "mass", "apart", plan.sharpens ? "" : "hardest pair", "instruments"}, {}};
  for (std::size_t i = 0; i < plan.best.size(); ++i) {
    const auto& c = plan.candidates[plan.best[i]];
    best.rows.push_back({shown(c.speed, speed), shown(c.mass, mass),
                         fmt::format("{:.1f} sigma", c.separation[plan.best_set[i]]),
                         plan.sharpens ? "" : plan.contenders[c.a].name() + " | " + plan.contenders[c.b].name(),
                         comma_list(plan.sets[plan.best_set[i]].names())});
  }
  out += aligned(best);
  for (std::size_t p = 0; p < plan.hopeless.size(); ++p)
    if (plan.hopeless[p])
      out += fmt::format("No run of this grid separates {} from {}.\n", plan.contenders[plan.pairs[p][0]].name(),
                         plan.contenders[plan.pairs[p][1]].name());
  for (const auto& c : plan.contenders)
    if (std::any_of(c.effects.begin(), c.effects.end(), [](const effects::Applied& e) { return e.effect.fine; }))
      out += c.name() +
             ": joints are finer than the means compared here; an accelerometer separates them better than this.\n";
  const auto& first = plan.candidates[plan.best.front()];
  if (!plan.sharpens && first.separation.back() < 2.0)
    out += "No run of the grid separates them for certain (2 sigma): repeat the best one, or add instruments.\n";
  out += fmt::format("\nWHAT EACH WOULD SHOW at {}, {}\n", shown(first.speed, speed), shown(first.mass, mass));
  TextTable shows{{"if it is", "stops at", "peak", "mean", "nose drag peak", "mean", "nose rut", "main rut"}, {}};
  for (std::size_t i = 0; i < first.expects.size(); ++i) {
    const auto& e = first.expects[i];
    shows.rows.push_back({plan.contenders[i].name(),
                          std::isfinite(e.stop) ? shown(e.stop, distance) : "leaves at " + shown(e.exit_speed, speed),
                          shown(e.peak_deceleration, acceleration), shown(e.mean_deceleration, acceleration),
                          shown(e.peak_nose_drag, force), shown(e.mean_nose_drag, force), shown(e.nose_rut, depth),
                          shown(e.main_rut, depth)});
  }
  out += aligned(shows);
  out += "\nSEPARATION, sigma, all instruments (* leaves the bed by at least one explanation)\n";
  TextTable map{{"mass"}, {}};
  for (const double s : plan.speeds) map.headings.push_back(shown(s, speed));
  for (std::size_t k = plan.masses.size(); k-- > 0;) {
    std::vector<std::string> row = {shown(plan.masses[k], mass)};
    for (std::size_t i = 0; i < plan.speeds.size(); ++i) {
      const auto& c = plan.at(i, k);
      row.push_back(c.simulated ? fmt::format("{:.1f}{}", c.separation.back(), c.stops ? "" : "*") : "-");
    }
    map.rows.push_back(row);
  }
  return out + aligned(map);
}

void next_run(const LearnWords& words, const NextWords& grid, const Settings& settings) {
  learning::NextOptions options;
  options.threads = words.threads;
  if (!grid.speeds.empty()) options.speeds = range_of("--speeds", grid.speeds, dimension::speed);
  if (!grid.masses.empty()) options.masses = range_of("--masses", grid.masses, dimension::mass);
  const auto known = known_effects(words);
  require(grid.rivals.empty() != words.from.empty(),
          "apc next needs either --from diagnosis.json or --rivals, such as --rivals inertial,softening");
  const auto contenders = grid.rivals.empty() ? learning::contenders_of_file(words.from, known)
                                              : learning::contenders_of(rivals_of(grid.rivals), {}, {}, known);
  const learning::Case data = load(words);
  const auto progress = settings.quiet ? nullptr : std::make_shared<Progress>("next run for " + data.title);
  if (progress) options.report = [progress](double share, const std::string& what) { progress->show(share, what); };
  const learning::NextPlan plan = learning::plan_next(data, contenders, known, options);
  if (!settings.quiet) fmt::print("{}", report_text(plan, settings.units));
  if (!settings.json.empty()) write_text(settings.json, learning::next_json(plan));
  if (!words.out.empty()) write_text(words.out, learning::next_page(plan, data.title));
}

}  // namespace

void add_next(CLI::App& program, Settings& settings) {
  CLI::App* next = program.add_subcommand(
      "next",
      "which run would separate what a diagnosis cannot tell apart, and what each explanation would show there");
  add_common_options(*next, settings);
  const auto words = std::make_shared<LearnWords>();
  const auto grid = std::make_shared<NextWords>();
  add_case_options(*next, words);
  next->add_option("--from", words->from, "diagnosis.json; what it leaves standing is to be separated");
  next->add_option("--rivals", grid->rivals,
                   "explanations of your own choice instead: effects apart by commas, joined by +, or nothing");
  next->add_option("--speeds", grid->speeds, "\"20:60:10 kt\"; every 5 kt inside the tables when left out");
  next->add_option("--masses", grid->masses, "\"16:21:1 t\"; five masses in service when left out");
  next->add_option("-o,--out", words->out, "page with the map, such as next.html");
  next->callback([&settings, words, grid] { next_run(*words, *grid, settings); });
}

}  // namespace apc::cli
