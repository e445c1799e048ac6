#include "apc/reliability/samples.h"

#include <cmath>

#include "apc/base/units.h"
#include "apc/reliability/speed_search.h"

namespace apc::reliability {
namespace {

constexpr double slowest = 5.0, fastest = 60.0;  ///< m/s, of the searches

/// One sample on its way: first the arrested speed, then, where its loads pass a limit, the intact one.
struct Search {
  Search(std::size_t at, simulation::Overrun drawn, const SpeedSearch& first)
      : sample(at), overrun(std::move(drawn)), stop(first), use(first) {}

  std::size_t sample;
  simulation::Overrun overrun;
  SpeedSearch stop, use;
  struct Seen {
    double speed, use;
  };
  std::vector<Seen> seen;
  bool asks_use = false;

  bool done() const { return asks_use ? use.done() : stop.done(); }
  double speed() const { return asks_use ? use.speed() : stop.speed(); }
};

/// ln(use) at the arrested speed, carried there from the run nearest to it.
double use_at(const Search& search, double speed, double exponent) {
  const auto* nearest = &search.seen.front();
  for (const auto& each : search.seen)
    if (std::abs(each.speed - speed) < std::abs(nearest->speed - speed)) nearest = &each;
  return std::log(std::max(1e-3, nearest->use)) + exponent * std::log(speed / nearest->speed);
}

/// The arrested speed is known: is it intact, or what is asked next?
void turn_to_use(Search& search, Sample& sample, const ReliabilityOptions& options, const Expectation& expected) {
  sample.arrest = search.stop.speed(), sample.stop_exponent = search.stop.exponent();
  search.asks_use = true;
  if (sample.arrest <= 0) {
    sample.intact = 0.0, search.use = search.stop;  // done
    return;
  }
  sample.use_at_arrest = use_at(search, sample.arrest, expected.use_exponent);
  SearchRange range{slowest, sample.arrest, options.intact_tolerance, 0.5};
  if (sample.use_at_arrest <= 0) {
    sample.intact = sample.arrest, search.use = search.stop;
    return;
  }
  search.use = SpeedSearch(expected.intact(sample), expected.use_exponent, range);
  const double guess = search.use.speed();
  for (const auto& each : search.seen) search.use.tell(std::min(each.speed, sample.arrest), each.use);
  // A guess that knows the other inputs is better than a line from the arrested speed far above it.
  if (!search.use.done() && std::abs(guess - sample.arrest) > 2 * range.tolerance) search.use.ask(guess);
}

}  // namespace

void find_critical_speeds(const ReliabilityInput& input, const simulation::Model& endless, const SolveMany& solve,
                          const ReliabilityOptions& options, const Expectation& expected, std::vector<Sample>& samples,
                          const std::vector<std::size_t>& which) {
  const double bed_end = input.model.bed.length();
  std::vector<Search> searches;
  for (const auto i : which) {
    const SearchRange range{slowest, fastest, options.arrest_tolerance, 0.15};
    searches.emplace_back(i, drawn(input.model, input.centre, input.scatter, samples[i].u, samples[i].blocks),
                          SpeedSearch(expected.arrest(samples[i]), expected.stop_exponent, range));
  }
  while (!searches.empty()) {
    std::vector<simulation::Overrun> runs;
    for (auto& each : searches) each.overrun.entry_speed = each.speed(), runs.push_back(each.overrun);
    auto results = solve(endless, runs, options.solver);
    // A run that fails by its tolerance seldom fails at a tenth of it.
    auto closer = options.solver;
    closer.rtol *= 0.1;
    for (std::size_t k = 0; k < results.size(); ++k)
      if (!results[k]) results[k] = std::move(solve(endless, {runs[k]}, closer).front());
    std::vector<Search> open;
    for (std::size_t k = 0; k < searches.size(); ++k) {
      auto& search = searches[k];
      auto& sample = samples[search.sample];
      ++sample.runs;
      if (!results[k]) {
        sample.finished = true, sample.good = false;
        continue;
      }
      const auto& result = *results[k];
      const double left_over = result.exit_speed * result.exit_speed / (2 * 0.05 * units::g0);
      const double stop = std::isfinite(result.stop_distance) ? result.stop_distance : endless.bed.length() + left_over;
      const double use = input.use(result);
      search.seen.push_back({search.overrun.entry_speed, use});
      if (search.asks_use) {
        search.use.tell(use);
      } else {
        search.stop.tell(stop / bed_end);
        if (search.stop.done()) turn_to_use(search, sample, options, expected);
      }
      if (!search.done()) {
        open.push_back(std::move(search));
        continue;
      }
      if (sample.arrest > 0 && sample.use_at_arrest > 0)
        sample.intact = std::min(search.use.speed(), sample.arrest), sample.use_exponent = search.use.exponent();
      sample.finished = sample.good = true;
    }
    searches = std::move(open);
  }
}

}  // namespace apc::reliability
