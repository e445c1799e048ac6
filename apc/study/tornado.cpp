#include "apc/study/tornado.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/study/critical_speed.h"

namespace apc::study {
namespace {

/// One input's two ends as cases; `model` indexes the list the cases belong to.
struct Pair {
  std::string input, low, high;
  Case at_low, at_high;
};

/// `change(overrun, sign)` moves one input of an overrun.
template <class Change>
Pair moved(const std::string& input, const std::string& low, const std::string& high, const Case& centre,
           const Change& change) {
  Pair pair{input, low, high, centre, centre};
  change(pair.at_low.overrun, -1.0);
  change(pair.at_high.overrun, +1.0);
  return pair;
}

double wheelbase(const aircraft::Aircraft& plane) {
  double last = 0.0;
  for (const auto& gear : plane.gears) last = std::max(last, gear.behind_nose_gear);
  return last;
}

std::vector<Pair> pairs_around(const simulation::Model& model, const Case& centre) {
  using simulation::Overrun;
  std::vector<Pair> pairs;
  pairs.push_back(moved("exit speed", "-5 kt", "+5 kt", centre,
                        [](Overrun& run, double sign) { run.entry_speed += sign * 5 * units::kt; }));
  pairs.push_back(
      moved("mass", "-5 %", "+5 %", centre, [](Overrun& run, double sign) { run.mass *= 1 + 0.05 * sign; }));
  const double shift = 0.01 * wheelbase(model.aircraft);
  pairs.push_back(moved("centre of gravity", "1 % forward", "1 % aft", centre,
                        [shift](Overrun& run, double sign) { run.cg_behind_nose_gear += sign * shift; }));
  pairs.push_back(moved("pitch inertia", "-25 %", "+25 %", centre,
                        [](Overrun& run, double sign) { run.pitch_inertia *= 1 + 0.25 * sign; }));
  pairs.push_back(moved("braking", "-0.1", "+0.1", centre, [](Overrun& run, double sign) {
    run.braking = std::max(0.0, run.braking + 0.1 * sign);
    if (run.braking_in_bed >= 0) run.braking_in_bed = std::max(0.0, run.braking_in_bed + 0.1 * sign);
  }));
  pairs.push_back(moved("headwind", "-10 kt", "+10 kt", centre,
                        [](Overrun& run, double sign) { run.headwind += sign * 10 * units::kt; }));
  Pair strength{"bed strength", "-10 %", "+10 %", centre, centre};
  strength.at_low.overrun.alterations.bed_strength *= 0.9;
  strength.at_high.overrun.alterations.bed_strength *= 1.1;
  pairs.push_back(strength);
  Pair depth{"bed depth", "-5 %", "+5 %", centre, centre};
  depth.at_low.overrun.bed_depth *= 0.95, depth.at_high.overrun.bed_depth *= 1.05;
  pairs.push_back(depth);
  return pairs;
}

}  // namespace

Tornado tornado(const simulation::Model& model, const simulation::Overrun& overrun, const Solve& solve, Store& store,
                const SweepOptions& options) {
  std::vector<simulation::Model> models{model};
  models[0].bed = continued(model.bed);
  Case centre{0, overrun};
  auto& run_of = centre.overrun;
  if (run_of.mass <= 0) run_of.mass = model.aircraft.mass;
  if (run_of.cg_behind_nose_gear <= 0) run_of.cg_behind_nose_gear = model.aircraft.cg_behind_nose_gear;
  if (run_of.pitch_inertia <= 0)
    run_of.pitch_inertia = model.aircraft.pitch_inertia * run_of.mass / model.aircraft.mass;
  const auto pairs = pairs_around(model, centre);
  std::vector<Case> cases{centre};
  for (const auto& pair : pairs) cases.push_back(pair.at_low), cases.push_back(pair.at_high);
  const auto results = run(models, cases, solve, store, options);

  const auto distance = [&](std::size_t i) {
    return results[i].failure.empty() ? results[i].result.stop_distance : std::nan("");
  };
  const auto margin = [&](std::size_t i) {
    return results[i].failure.empty() ? worst_margin(results[i].result, Criterion::limit) : std::nan("");
  };
  Tornado out{model.aircraft.name, model.bed.name, distance(0), margin(0), overrun.entry_speed, {}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t low = 1 + 2 * i, high = low + 1;
    TornadoBar bar{pairs[i].input, pairs[i].low, pairs[i].high, distance(low),
                   distance(high), margin(low),  margin(high),  0.0};
    const auto far = [&](double value) { return std::isfinite(value) ? std::abs(value - out.distance) : 0.0; };
    bar.reach = std::max(far(bar.distance_low), far(bar.distance_high));
    out.bars.push_back(bar);
  }
  std::stable_sort(out.bars.begin(), out.bars.end(),
                   [](const TornadoBar& a, const TornadoBar& b) { return a.reach > b.reach; });
  return out;
}

}  // namespace apc::study
