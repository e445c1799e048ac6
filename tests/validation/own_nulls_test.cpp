// A hundred sets of runs of our own making with nothing hidden but what is always wrong — scatter of the blocks, errors
// of the tables, noise and bias of the instruments, and in every fifth set an accelerometer that reads 6 % too much:
// how often an effect is claimed. And twenty sets with an effect: how often it comes first.
//   APC_EVERY_NULL=1    weighs every set on free runs as well, not every fifth: as a diagnosis does, and ten times as
//   long
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "apc/effects/other_forms.h"
#include "apc/learning/weighing.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

/// The probability of every effect; "" none, "~" an instrument. Single effects only.
std::map<std::string, double> probabilities(const testing::SurveyedRuns& wanted, bool free_runs_too) {
  const Case data = testing::surveyed_case(wanted);
  const Layout layout = make_layout(data, data.runs);
  const auto along = balance_along(data, layout, 0);
  auto laws = effects::catalogue();
  laws.insert(laws.end(), effects::other_forms().begin(), effects::other_forms().end());
  const Screen screen = weigh_along(*along, data, layout, laws, 0);
  Background none;
  std::vector<Explanation> list(1);
  const auto singles = best_shapes(screen);
  for (const Single& s : singles) list.push_back(weighed(none, {s.hypothesis}, s.evidence, s.log_evidence));
  std::vector<SensorClaim> sensors;
  add_linear(screen, list, sensors);
  if (free_runs_too)
    if (const auto free = weigh_free(data, laws, 0, {}))
      for (Explanation& x : list) x.free_evidence = x.ids.empty() ? 0.0 : free->of(x.ids);
  weigh(list, true, singles.size(), screen.temper);
  std::map<std::string, double> result;
  for (const Explanation& x : list)
    result[x.kind == Hypothesis::Kind::sensor    ? "~"
           : x.kind == Hypothesis::Kind::learned ? "learned"
           : x.ids.empty()                       ? ""
                                                 : x.ids.front()] += x.probability;
  return result;
}

bool on_free_runs(unsigned seed) { return seed % 5 == 1 || std::getenv("APC_EVERY_NULL"); }

testing::SurveyedRuns made(unsigned seed) {
  testing::SurveyedRuns wanted;
  wanted.seed = seed;
  wanted.block_strength = 0.05 + 0.01 * (seed % 8);
  wanted.correlation = 1.5 + 2.0 * (seed % 5);
  wanted.table_error = 0.01 + 0.01 * (seed % 4);
  return wanted;
}

TEST(OwnNulls, OfAHundredFewClaimAnEffect) {
  int claimed = 0, blamed = 0, faults = 0, free = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    auto wanted = made(seed);
    if (seed % 5 == 0) wanted.accelerometer_scale = 1.06;
    const auto p = probabilities(wanted, on_free_runs(seed));
    for (const auto& [id, probability] : p)
      if (!id.empty() && id != "~" && probability > 0.5) {
        ++claimed;
        std::printf("seed %u: %s P %.2f\n", seed, id.c_str(), probability);
      }
    free += on_free_runs(seed);
    if (seed % 5 == 0) ++faults, blamed += p.at("~") > 0.5;
  }
  std::printf(
      "an effect claimed in %d of 100 sets without one (%d of them weighed on free runs, too); the accelerometer "
      "blamed in %d of %d\n",
      claimed, free, blamed, faults);
  EXPECT_LE(claimed, 5);
  EXPECT_GE(blamed, faults * 4 / 5);
}

TEST(OwnNulls, AHiddenEffectComesFirst) {
  struct Hidden {
    const char* id;
    double amplitude;
    int least;  ///< of 20. A thrust that is held and air against the wind do nearly what a slope does.
  };
  for (const auto& [id, amplitude, least] :
       {Hidden{"inertial", 1.0, 18}, Hidden{"thrust", 2.0e4, 16}, Hidden{"slope", 0.02, 11}}) {
    int first = 0, certain_of_another = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      auto wanted = made(seed);
      wanted.hidden = {effects::applied(effects::find_effect(effects::catalogue(), id), amplitude)};
      auto p = probabilities(wanted, on_free_runs(seed));
      p.erase(""), p.erase("~");
      const auto best =
          std::max_element(p.begin(), p.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      first += best->first == id;
      certain_of_another += best->first != id && best->second > 0.8;
    }
    std::printf("%s first in %d of 20, another effect with P > 0.8 in %d\n", id, first, certain_of_another);
    EXPECT_GE(first, least) << id;
    EXPECT_LE(certain_of_another, 1) << id;
  }
}

}  // namespace
}  // namespace apc::learning
