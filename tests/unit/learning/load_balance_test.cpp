#include "apc/learning/rut_balance.h"

#include <gtest/gtest.h>

#include "apc/effects/catalogue.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

TEST(Smooth, KeepsStraightLinesAndPassesOverMissingReadings) {
  std::vector<double> x, y;
  for (int i = 0; i <= 100; ++i) x.push_back(0.1 * i), y.push_back(i == 40 ? std::nan("") : 3.0 - 0.7 * 0.1 * i);
  const Smooth s = smooth(x, y, -1.0, 11.0, 0.25, 0.01, 0.1);
  for (const double at : {0.5, 4.0, 9.3}) EXPECT_NEAR(s.at(at), 3.0 - 0.7 * at, 1e-6);
  EXPECT_NEAR(s.at(10.8), 3.0 - 0.7 * 10.8, 1e-3);  // beyond the readings: straight on
}

class OwnRun : public ::testing::Test {
 protected:
  OwnRun() {
    testing::SurveyedRuns wanted;
    wanted.speeds = {28.0}, wanted.masses = {62000.0}, wanted.block_strength = 0.0;
    data = testing::surveyed_case(wanted);
    gears = gear_facts(data);
    motion = *measured_motion(data, make_layout(data, data.runs), 0);
    settle(data, gears, data.runs[0], motion);
  }
  Case data;
  std::vector<GearFacts> gears;
  Motion motion;
};

TEST_F(OwnRun, BalancesWithTheDecelerationThatWasSimulated) {
  // The balance knows no bounce; at the ruts of a simulated run it must still give that run's deceleration. Rolling
  // resistance of the tires in the bed is the balance's own: 1.5 % of the weight, taken off.
  const Balance b = balance_at_ruts(data, gears, data.runs[0], motion, {});
  const Channel& speed = *data.runs[0].find(Quantity::speed);
  double lost = 0.0, rolling = 0.0;
  for (Eigen::Index i = 1; i < b.along.size(); ++i) {
    if (motion.time[static_cast<std::size_t>(i)] < 0.0) continue;
    lost -= b.along[i] * motion.interval;
    for (std::size_t g = 0; g < 2; ++g)
      if (motion.place[static_cast<std::size_t>(i)] > gears[g].behind)
        rolling += 0.015 * b.vertical[g][static_cast<std::size_t>(i)] / 62000.0 * motion.interval;
  }
  const double measured =
      28.0 - speed.value[static_cast<std::size_t>(
                 std::lower_bound(speed.time.begin(), speed.time.end(), motion.time.back()) - speed.time.begin() - 1)];
  EXPECT_NEAR((lost - rolling) / measured, 1.0, 0.03);
}

TEST_F(OwnRun, LoadsAtAGivenRutAreProportionalToTheStrength) {
  const Balance plain = balance_at_ruts(data, gears, data.runs[0], motion, {});
  effects::Alterations stronger;
  stronger.bed_strength = 1.2;
  const Balance solved = balance_at_ruts(data, gears, data.runs[0], motion, stronger);
  const Balance scaled = changed(plain, data, gears, data.runs[0], motion, [](std::size_t, std::size_t) {
    return LoadChange{0.2, 0.2};
  });
  for (Eigen::Index i = 0; i < plain.along.size(); i += 10) {
    const auto s = static_cast<std::size_t>(i);
    if (motion.place[s] < gears[1].behind + 5.0) continue;  // limited loads on the thin end of the ramp
    EXPECT_NEAR(solved.along[i], scaled.along[i], 0.02 * std::abs(scaled.along[i])) << motion.place[s];
  }
}

TEST(GearFacts, AreGivenForANoseAndOneMainGroupOnly) {
  testing::SurveyedRuns wanted;
  wanted.speeds = {20.0}, wanted.masses = {60000.0};
  Case data = testing::surveyed_case(wanted);
  EXPECT_EQ(gear_facts(data).size(), 2u);
  data.aircraft.gears[1].axles = 2;
  EXPECT_TRUE(gear_facts(data).empty());
  data.aircraft.gears.pop_back();
  EXPECT_TRUE(gear_facts(data).empty());
}

TEST(MeasuredMotion, NeedsASurveyAndItsChannels) {
  testing::SurveyedRuns wanted;
  wanted.speeds = {20.0}, wanted.masses = {60000.0};
  Case data = testing::surveyed_case(wanted);
  const auto motion = [&] { return measured_motion(data, make_layout(data, data.runs), 0); };
  ASSERT_TRUE(motion());
  const learning::Run whole = data.runs[0];
  data.runs[0].survey.reset();
  EXPECT_FALSE(motion());
  data.runs[0] = whole;
  std::erase_if(data.runs[0].channels, [](const Channel& c) { return c.quantity == Quantity::acceleration_x; });
  EXPECT_FALSE(motion());
}

}  // namespace
}  // namespace apc::learning
