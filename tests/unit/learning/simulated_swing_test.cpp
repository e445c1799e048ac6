#include "apc/learning/simulated_swing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

/// One run without scatter; the same with the accelerations taken away.
class OwnSwing : public ::testing::Test {
 protected:
  OwnSwing() {
    wanted.speeds = {28.0}, wanted.masses = {62000.0}, wanted.block_strength = 0.0;
    data = bare = testing::surveyed_case(wanted);
    std::erase_if(bare.runs[0].channels, [](const Channel& c) { return c.quantity != Quantity::speed; });
    gears = gear_facts(data);
    main = gears[0].nose ? 1 : 0;
    layout = make_layout(bare, bare.runs);
    told = *measured_motion(data, make_layout(data, data.runs), 0);
    load_motion(data, gears, data.runs[0], told);
    asked = *measured_motion(bare, layout, 0);
    load_motion(bare, gears, bare.runs[0], asked);
  }
  /// Root mean square of (load − load told by the accelerations) / static load of the main gear in the second after it
  /// enters.
  double error(const std::vector<double>& load) const {
    const double weight = told.steady[main].front();
    double sum = 0.0, count = 0.0, entered = -1.0;
    for (std::size_t i = 0; i < told.size(); ++i) {
      if (entered < 0.0 && told.place[i] > gears[main].behind) entered = told.time[i];
      if (entered < 0.0 || told.time[i] > entered + 1.0) continue;
      sum += std::pow((load[i] - told.carried[main][i]) / weight, 2), count += 1.0;
    }
    return std::sqrt(sum / count);
  }
  testing::SurveyedRuns wanted;
  Case data, bare;
  std::vector<GearFacts> gears;
  std::size_t main = 1;
  Layout layout;
  Motion told, asked;
};

TEST_F(OwnSwing, IsUnknownUnlessBothVerticalAccelerationAndPitchRateWereRecorded) {
  EXPECT_FALSE(swing_unknown(data.runs[0]));
  EXPECT_TRUE(swing_unknown(bare.runs[0]));
  auto one = data.runs[0];
  std::erase_if(one.channels, [](const Channel& c) { return c.quantity == Quantity::pitch_rate; });
  EXPECT_TRUE(swing_unknown(one));
}

TEST_F(OwnSwing, FollowsTheSwingThatAccelerationsTell) {
  const double without = error(asked.carried[main]);
  simulate_swing(bare, layout, gears, 0, wanted.sinking, asked);
  ASSERT_GT(without, 0.05) << "this run does not swing";
  EXPECT_LT(error(asked.carried[main]), 0.5 * without);
}

TEST_F(OwnSwing, LeavesTheNoseGearAndTheSteadyLoadAlone) {
  const Motion before = asked;
  simulate_swing(bare, layout, gears, 0, wanted.sinking, asked);
  EXPECT_EQ(asked.carried[1 - main], before.carried[1 - main]);
  EXPECT_EQ(asked.steady, before.steady);
}

TEST_F(OwnSwing, KeepsTheLeastLoadThatTheBalanceAllows) {
  simulate_swing(bare, layout, gears, 0, wanted.sinking, asked);
  const double least = least_load(gears[main], share_of(gears), bare.runs[0]);
  for (const double load : asked.carried[main]) EXPECT_GE(load, least * (1.0 - 1e-12));
}

}  // namespace
}  // namespace apc::learning
