#include "apc/learning/readings.h"

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
    motion.sinking = wanted.sinking;
    load_motion(data, gears, data.runs[0], motion);
  }
  /// Fully in the bed, past the thin end of the ramp.
  bool inside(std::size_t i) const { return motion.place[i] > gears[1].behind + 16.0; }
  Case data;
  std::vector<GearFacts> gears;
  Motion motion;
};

TEST_F(OwnRun, CarriesItsWeightOnAverageAndTakesItFromTheNoseWhenTheNoseGearIsLightlyLoaded) {
  double sum = 0.0, seconds = 0.0, nose = 0.0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    sum += (motion.carried[0][i] + motion.carried[1][i]) * motion.interval, seconds += motion.interval;
    nose += motion.carried[gears[0].nose ? 0 : 1][i] * motion.interval;
  }
  // Lift takes a few percent off, and braking by the bed loads the nose gear beyond its static share of about a tenth.
  EXPECT_NEAR(sum / seconds / (62000.0 * units::g0), 1.0, 0.06);
  EXPECT_GT(nose / sum, 0.08);
}

TEST_F(OwnRun, BalancesWithTheDecelerationThatWasSimulated) {
  // At the loads of a simulated run the balance must give that run's deceleration. Rolling resistance of the tires in
  // the bed is the balance's own: 1.5 % of the weight, taken off.
  const Balance b = balance_at_loads(data, gears, data.runs[0], motion, {});
  const Channel& speed = *data.runs[0].find(Quantity::speed);
  double lost = 0.0;
  for (Eigen::Index i = 1; i < b.along.size(); ++i) {
    const auto s = static_cast<std::size_t>(i);
    if (motion.time[s] < 0.0) continue;
    lost -= b.along[i] * motion.interval;
    for (std::size_t g = 0; g < 2; ++g)
      if (motion.place[s] > gears[g].behind) lost -= 0.015 * b.vertical[g][s] / 62000.0 * motion.interval;
  }
  const double measured =
      28.0 - speed.value[static_cast<std::size_t>(
                 std::lower_bound(speed.time.begin(), speed.time.end(), motion.time.back()) - speed.time.begin() - 1)];
  // 6 % too much: loads smoothed against vibration lack the peaks of the bounce, and drag is not linear in the load.
  EXPECT_NEAR(lost / measured, 1.0, 0.08);
}

TEST_F(OwnRun, LeavesTheRutsThatWereSurveyed) {
  const Balance b = balance_at_loads(data, gears, data.runs[0], motion, {});
  for (std::size_t g = 0; g < 2; ++g) {
    double sum = 0.0, worst = 0.0;
    int count = 0;
    const auto list = readings_of(data, gears, data.runs[0], motion);
    const Eigen::VectorXd h = read_off(list, gears, data.runs[0], motion, b, 28.0);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].kind == Reading::Kind::rut && list[i].gear == g) {
        const double miss = h[static_cast<Eigen::Index>(i)] - list[i].value;
        sum += miss, worst = std::max(worst, std::abs(miss)), ++count;
      }
    ASSERT_GT(count, 10);
    EXPECT_NEAR(sum / count, 0.0, 0.02) << g;
    EXPECT_LT(worst, 0.08) << g;
  }
}

TEST_F(OwnRun, CarriesWhatItIsToldWhateverTheBed) {
  effects::Alterations stronger;
  stronger.bed_strength = 1.1;
  const Balance plain = balance_at_loads(data, gears, data.runs[0], motion, {}),
                strong = balance_at_loads(data, gears, data.runs[0], motion, stronger);
  for (std::size_t g = 0; g < 2; ++g)
    for (std::size_t i = 0; i < motion.size(); i += 7) {
      if (!inside(i)) continue;
      EXPECT_NEAR(strong.vertical[g][i] / motion.carried[g][i], 1.0, 1e-3);
      EXPECT_LT(strong.rut[g][i], plain.rut[g][i]) << "a stronger bed carries the same load in a shallower rut";
    }
}

TEST_F(OwnRun, AWheelThatMustSinkFastCarriesMoreThanASteadyOne) {
  // Half of a sine in the strength, 4 m long: at rest in every place the main wheels would sink much further.
  effects::Alterations soft;
  soft.strength.assign(2, {1.0, {}});
  for (auto& profile : soft.strength) {
    profile.log_strength.assign(60, 0.0);
    for (int k = 0; k <= 4; ++k) profile.log_strength[static_cast<std::size_t>(40 + k)] = -0.2 * std::sin(0.785 * k);
  }
  const auto deepest = [&](double sinking) {
    motion.sinking = sinking;
    const Balance even = balance_at_loads(data, gears, data.runs[0], motion, {}),
                  weak = balance_at_loads(data, gears, data.runs[0], motion, soft);
    double deeper = 0.0;
    for (std::size_t i = 0; i < motion.size(); ++i)
      deeper = std::max(deeper, weak.penetration[1][i] - even.penetration[1][i]);
    return deeper;
  };
  const double rigid = deepest(1.0), flexible = deepest(1.7), steady = deepest(0.01);
  EXPECT_LT(rigid, 0.9 * steady);
  EXPECT_LT(flexible, rigid);
  EXPECT_GT(flexible, 0.0);
}

TEST_F(OwnRun, SmallChangesAreThoseOfTheBalanceSolvedAgain) {
  const Response response = response_at_loads(data, gears, data.runs[0], motion, {});
  effects::Alterations stronger;
  stronger.bed_strength = 1.02;
  const Balance solved = balance_at_loads(data, gears, data.runs[0], motion, stronger);
  const Balance first = response.to(data, gears, data.runs[0], motion, [](std::size_t, std::size_t) {
    return LoadChange{0.0, 0.0, 0.02};
  });
  const Balance draggy = response.to(data, gears, data.runs[0], motion,
                                     [](std::size_t g, std::size_t) { return LoadChange{g == 1 ? 0.1 : 0.0}; });
  for (std::size_t i = 0; i < motion.size(); i += 7) {
    if (!inside(i) || motion.speed[i] < 6.0) continue;  // a slow wheel on the plateau is far from linear
    const auto k = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(first.along[k], solved.along[k], 0.02 * std::abs(solved.along[k])) << motion.place[i];
    EXPECT_NEAR(first.rut[1][i], solved.rut[1][i], 0.01) << motion.place[i];
    EXPECT_NEAR(draggy.drag[1][i], 1.1 * response.base.drag[1][i], 1e-9 * response.base.drag[1][i]);
    EXPECT_EQ(draggy.drag[0][i], response.base.drag[0][i]);
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

TEST(MeasuredMotion, NeedsASpeedAndNothingElse) {
  testing::SurveyedRuns wanted;
  wanted.speeds = {20.0}, wanted.masses = {60000.0};
  Case data = testing::surveyed_case(wanted);
  const auto motion = [&] { return measured_motion(data, make_layout(data, data.runs), 0); };
  data.runs[0].survey.reset();
  std::erase_if(data.runs[0].channels, [](const Channel& c) { return c.quantity != Quantity::speed; });
  auto m = motion();
  ASSERT_TRUE(m);
  // Without accelerations: statics, braking included.
  const auto gears = gear_facts(data);
  load_motion(data, gears, data.runs[0], *m);
  const std::size_t middle = m->size() / 2;
  EXPECT_GT(m->carried[0][middle], 1.2 * m->carried[0][0]);
  EXPECT_NEAR(m->carried[0][middle] + m->carried[1][middle], m->carried[0][0] + m->carried[1][0],
              0.03 * 60000.0 * units::g0);
  data.runs[0].channels.clear();
  EXPECT_FALSE(motion());
}

}  // namespace
}  // namespace apc::learning
