#include "loadtables/infill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

Plan plan() {
  PlanOptions options;
  options.runs = 30;
  return make_plan(synthetic::tire(), "made_up_foam", options);
}

std::vector<RunStatus> finished(const Plan& made) {
  std::vector<RunStatus> list;
  for (const auto& run : made.runs)
    list.push_back({run, RunOutcome{"steady", "", synthetic::truth(run.contact), 0.1, {}}});
  return list;
}

double distance(const PlannedRun& a, const PlannedRun& b) {
  const double v = (a.contact.speed - b.contact.speed) / (60.0 * units::kt),
               h = std::log(a.contact.bed_depth / b.contact.bed_depth) / std::log(12.0),
               r = (a.relative_penetration - b.relative_penetration) / 0.9;
  return std::sqrt(v * v + h * h + r * r);
}

TEST(FurtherRuns, ContinueThePlanAwayFromItsRunsAndFromOneAnother) {
  const auto made = plan();
  const auto further = further_runs(made, finished(made), 6);
  ASSERT_EQ(further.size(), 6u);
  auto all = made.runs;
  for (const auto& run : further) {
    EXPECT_EQ(run.id, static_cast<int>(all.size()) + 1);
    for (const auto& other : all) EXPECT_GT(distance(run, other), 0.1) << run.id << " and " << other.id;
    all.push_back(run);
  }
}

TEST(FurtherRuns, GoWhereLeavingOutCostsMost) {
  const auto made = plan();
  auto list = finished(made);
  // A region that the smooth rest does not explain: deep beds pushed hard, with loads that jump from run to run.
  double sign = 1.0;
  for (auto& each : list)
    if (each.planned.relative_penetration > 0.7 && each.planned.contact.bed_depth > 0.3)
      each.outcome->load.drag *= 1.0 + 0.4 * (sign = -sign);
  int there = 0;
  for (const auto& run : further_runs(made, list, 6))
    there += run.relative_penetration > 0.5 && run.contact.bed_depth > 0.2;
  EXPECT_GE(there, 4);
}

TEST(FurtherRuns, KeepAwayFromRefusedRuns) {
  const auto made = plan();
  auto list = finished(made);
  for (auto& each : list)
    if (each.planned.relative_penetration > 0.75) each.outcome = RunOutcome{"tire_overloaded", "too much", {}, 0.1, {}};
  for (const auto& run : further_runs(made, list, 1)) {
    const auto nearest = std::min_element(list.begin(), list.end(), [&](const auto& a, const auto& b) {
      return distance(run, a.planned) < distance(run, b.planned);
    });
    EXPECT_TRUE(nearest->outcome->steady()) << "run " << run.id << " is next to run " << nearest->planned.id;
  }
}

TEST(FurtherRuns, NeedRunsToLearnFrom) {
  const auto made = plan();
  auto list = finished(made);
  for (std::size_t i = 8; i < list.size(); ++i) list[i].outcome.reset();
  EXPECT_THROW(further_runs(made, list, 3), InputError);
  EXPECT_THROW(further_runs(made, finished(made), 0), InputError);
}

}  // namespace
}  // namespace apc::loadtables
