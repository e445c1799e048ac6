#include "apc/learning/readings.h"

#include <gtest/gtest.h>

#include "apc/effects/catalogue.h"
#include "apc/learning/simulated_swing.h"
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
    const Layout layout = make_layout(data, data.runs);
    motion = *measured_motion(data, layout, 0);
    motion.sinking = wanted.sinking;
    lead_swing(data, layout, 0, wanted.sinking, motion);
    load_motion(data, gears, data.runs[0], motion);
    simulation::Overrun overrun = data.runs[0].overrun;
    overrun.sinking = {wanted.sinking, 0.0};
    simulation::Options options;
    options.method = simulation::Method::fast, options.sampling = 0.01;
    truth =
        simulation::simulate(simulation::make_model(data.aircraft, data.bed, data.tables), overrun, options).history;
  }
  /// What was simulated, at a time of the motion.
  double simulated(const std::vector<double>& values, double time) const {
    const auto next = std::lower_bound(truth.time.begin(), truth.time.end(), time) - truth.time.begin();
    return values[std::min(static_cast<std::size_t>(next), values.size() - 1)];
  }
  /// Fully in the bed, past the thin end of the ramp.
  bool inside(std::size_t i) const { return motion.place[i] > gears[1].behind + 16.0; }
  Case data;
  std::vector<GearFacts> gears;
  Motion motion;
  simulation::History truth;
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

TEST_F(OwnRun, BrakesAsTheSimulationDoesAtTheLoadsItCarried) {
  // From the thin end of the ramp on: same loads, same forces.
  Motion known = motion;
  for (std::size_t i = 0; i < known.size(); ++i) {
    known.speed[i] = simulated(truth.speed, known.time[i]), known.place[i] = simulated(truth.distance, known.time[i]);
    for (std::size_t g = 0; g < 2; ++g) known.carried[g][i] = simulated(truth.gears[g].vertical, known.time[i]);
  }
  const Balance b = balance_at_loads(data, gears, data.runs[0], known, {});
  for (std::size_t g = 0; g < 2; ++g)
    for (const auto& [from, to] : {std::pair{2.0, 6.0}, {6.0, 15.0}, {15.0, 40.0}}) {
      double balance = 0.0, simulation = 0.0;
      for (std::size_t i = 0; i < known.size(); ++i) {
        const double place = known.place[i] - gears[g].behind;
        if (place < from || place > to) continue;
        balance -= b.force_x[g][i], simulation += simulated(truth.gears[g].drag, known.time[i]);
      }
      EXPECT_NEAR(balance / simulation, 1.0, 0.03) << "gear " << g << " from " << from << " m";
    }
}

TEST_F(OwnRun, BalancesWithTheDecelerationThatWasSimulated) {
  // At the loads that instruments tell. 4.5 % too much: smoothed loads lack the peaks of the bounce, and drag is not
  // linear in the load.
  const Balance b = balance_at_loads(data, gears, data.runs[0], motion, {});
  double lost = 0.0;
  for (Eigen::Index i = 1; i < b.along.size(); ++i)
    if (motion.time[static_cast<std::size_t>(i)] > 0.0) lost -= b.along[i] * motion.interval;
  EXPECT_NEAR(lost / (28.0 - simulated(truth.speed, motion.time.back())), 1.0, 0.06);
}

TEST_F(OwnRun, FollowsTheFallOfTheLoadsAtTheLeadingEdge) {
  Motion alone = motion;
  alone.led = {};
  load_motion(data, gears, data.runs[0], alone);
  const std::size_t main = gears[0].nose ? 1 : 0;
  const auto error = [&](const Motion& m) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double place = m.place[i] - gears[main].behind;
      if (place < -2.0 || place > 15.0) continue;
      sum += std::pow(m.carried[main][i] / simulated(truth.gears[main].vertical, m.time[i]) - 1.0, 2), count += 1.0;
    }
    return std::sqrt(sum / count);
  };
  EXPECT_LT(error(motion), 0.6 * error(alone));
}

TEST_F(OwnRun, TakesTheLoadOfTheNoseGearFromItsCellButNotTheCellsOffset) {
  const std::size_t nose = gears[0].nose ? 0 : 1;
  std::mt19937 random(2);
  std::vector<double> read = truth.gears[nose].vertical;
  for (double& force : read) force += 4000.0;
  auto with = data.runs[0];
  with.channels.push_back(testing::channel(Quantity::nose_vertical, 3000.0, 0.0, truth.time, read, 1, random));
  with.channels.back().bias = 4000.0;
  Motion told = motion;
  load_motion(data, gears, with, told);
  const auto error = [&](const Motion& m) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (m.place[i] < 2.0 || m.place[i] > 40.0) continue;
      sum += std::pow(m.carried[nose][i] / simulated(truth.gears[nose].vertical, m.time[i]) - 1.0, 2), count += 1.0;
    }
    return std::sqrt(sum / count);
  };
  EXPECT_LT(error(told), 0.7 * error(motion));
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
