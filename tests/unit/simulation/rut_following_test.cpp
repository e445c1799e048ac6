#include <gtest/gtest.h>

#include "apc/simulation/rut_log.h"
#include "apc/simulation/tire_bed.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

TEST(RutLog, ReadsBackASmoothTrack) {
  RutLog log;
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.05 * i;
    log.write(x, {0.3 + 0.05 * std::sin(x), 0.4, 1e4, 2e4, 0.0});
  }
  for (const double x : {3.013, 7.77, 12.3456}) {
    EXPECT_NEAR(log.at(x).depth, 0.3 + 0.05 * std::sin(x), 5e-6);
    EXPECT_NEAR(log.at(x).depth_slope, 0.05 * std::cos(x), 5e-4);
    EXPECT_NEAR(log.at(x).vertical, 2e4, 1e-9);
  }
}

TEST(RutLog, ReadsBackATrackThatTurnsAtACorner) {
  // Two slopes, as behind a ramp: exact on both sides when the log is told, rounded off by its cubics when not.
  const auto track = [](double x) { return 0.2 + 0.03 * std::min(x - 5.0, 0.0); };
  RutLog told, untold;
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.2 * i;
    for (auto* log : {&told, &untold}) log->write(x, {track(x), 0.4, 1e4, 2e4});
    if (i == 25) told.turn(), told.turn();
  }
  double rounded = 0.0;
  for (double x = 4.5; x < 5.5; x += 0.013) {
    EXPECT_NEAR(told.at(x).depth, track(x), 1e-14) << x;
    EXPECT_NEAR(told.at(x).depth_slope, x < 5.0 ? 0.03 : 0.0, 1e-12) << x;
    rounded = std::max(rounded, std::abs(untold.at(x).depth - track(x)));
  }
  EXPECT_GT(rounded, 1e-4);
}

TEST(RutLog, HasTheEndOfAParabolaOnBothSidesOfATurn) {
  const auto track = [](double x) { return x < 3.0 ? 0.1 + 0.01 * x * x : 0.19 + 0.02 * (x - 3.0) * (x - 3.0); };
  RutLog log;
  for (int i = 0; i <= 30; ++i) {
    log.write(0.2 * i, {track(0.2 * i), 0.4, 1e4, 2e4});
    if (i == 15) log.turn();
  }
  for (double x = 0.05; x < 5.7; x += 0.05) EXPECT_NEAR(log.at(x).depth, track(x), 1e-12) << x;
}

TEST(RutLog, HoldsNothingBeforeItsFirstEntry) {
  RutLog log;
  EXPECT_EQ(log.at(1.0).depth, 0.0);
  log.write(2.0, {0.2, 0.3, 1.0, 1.0, 0.0});
  log.write(3.0, {0.2, 0.3, 1.0, 1.0, 0.0});
  EXPECT_EQ(log.at(1.9).depth, 0.0);
  EXPECT_EQ(log.at(9.0).depth, 0.2);
}

TEST(RutLog, IgnoresASecondEntryAtTheSamePlace) {
  RutLog log;
  log.write(1.0, {0.1, 0.1, 1.0, 1.0, 0.0});
  log.write(1.0, {0.9, 0.9, 9.0, 9.0, 0.0});
  log.write(2.0, {0.1, 0.1, 1.0, 1.0, 0.0});
  EXPECT_NEAR(log.at(1.5).depth, 0.1, 1e-12);
}

class RutFollowingLaw : public ::testing::Test {
 protected:
  RutFollowingLaw() : model_(testing::foam_model("B747-400", testing::foam_bed(0.5))) {
    ground_.table = &model_.tables[1];
    ground_.following = {2.0, 0.02};
  }
  GroundLoad lead(double penetration) const { return ground_load(ground_, place(penetration), nullptr); }
  GroundLoad trail(double penetration, const GroundLoad& ahead) const {
    const Rut rut{ahead.load.rut_depth, ahead.virgin_penetration, ahead.virgin_drag, ahead.virgin_vertical};
    return ground_load(ground_, place(penetration), &rut);
  }
  static effects::TirePlace place(double penetration) { return {{20.0, 0.5, penetration}, 30.0, 30.0, 1.0}; }
  Model model_;
  TireBed ground_;
};

TEST_F(RutFollowingLaw, NothingCarriesATireAboveTheFloor) {
  const auto ahead = lead(0.30);
  EXPECT_EQ(trail(0.9 * ahead.load.rut_depth, ahead).load.vertical, 0.0);
}

TEST_F(RutFollowingLaw, AnEqualLoadRollsOnTheFloorWithoutDeepeningIt) {
  const auto ahead = lead(0.30);
  // The penetration at which the second tire carries the same load.
  double low = ahead.load.rut_depth, high = 0.5;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (trail(middle, ahead).load.vertical < ahead.load.vertical ? low : high) = middle;
  }
  const auto second = trail(low, ahead);
  EXPECT_NEAR(second.load.vertical, ahead.load.vertical, 1e-6 * ahead.load.vertical);
  EXPECT_DOUBLE_EQ(second.load.rut_depth, ahead.load.rut_depth);
  EXPECT_NEAR(second.load.drag, 0.02 * second.load.vertical, 1e-9);
}

TEST_F(RutFollowingLaw, TwoPassesTakeTheEnergyOfOneDeeperPass) {
  const auto ahead = lead(0.25);
  const auto second = trail(0.42, ahead);
  ASSERT_GT(second.load.rut_depth, ahead.load.rut_depth + 0.02) << "the second pass must deepen the rut";
  const auto once = lead(second.virgin_penetration);
  EXPECT_NEAR(once.load.rut_depth, second.load.rut_depth, 1e-9);
  const double crushing = ahead.load.drag + second.load.drag - 0.02 * second.load.vertical;
  EXPECT_NEAR(crushing, once.load.drag, 1e-6 * once.load.drag);
}

TEST_F(RutFollowingLaw, SlopesAgreeWithDifferencesInTheAirOnTheFloorAndWhereItYields) {
  const auto ahead = lead(0.25);
  const auto rut_at = [&](double x) {  // a track that rises along the way, its entries not quite of one penetration
    Rut rut{ahead.load.rut_depth + 0.01 * (x - 30.0), 0.25 + 0.012 * (x - 30.0), ahead.virgin_drag,
            ahead.virgin_vertical + 2e3 * (x - 30.0)};
    rut.depth_slope = 0.01;
    rut.penetration_slope = 0.012;
    rut.vertical_slope = 2e3;
    return rut;
  };
  const auto load = [&](double speed, double depth, double penetration, double x) {
    const auto rut = rut_at(x);
    return ground_load(ground_, {{speed, depth, penetration}, x, x, 1.0}, &rut).load;
  };
  bool yielded = false;
  for (const double penetration : {0.19, 0.26, 0.40, 0.44}) {
    const auto rut = rut_at(30.0);
    const auto all = ground_load_with_slopes(ground_, place(penetration), &rut);
    yielded = yielded || all.load.rut_depth > rut.depth + 0.01;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double h = 1e-6;
      double up[4] = {20.0, 0.5, penetration, 30.0}, down[4] = {20.0, 0.5, penetration, 30.0};
      up[lane] += h;
      down[lane] -= h;
      const auto a = load(up[0], up[1], up[2], up[3]), b = load(down[0], down[1], down[2], down[3]);
      const auto near = [&](double slope, double high, double low, double scale) {
        EXPECT_NEAR(slope, (high - low) / (2 * h), 2e-5 * (scale + std::abs(slope))) << penetration << " " << lane;
      };
      near(all.drag[lane], a.drag, b.drag, 1e4);
      near(all.vertical[lane], a.vertical, b.vertical, 1e4);
      near(all.rut_depth[lane], a.rut_depth, b.rut_depth, 1.0);
      near(all.spin_ratio[lane], a.spin_ratio, b.spin_ratio, 1.0);
    }
  }
  EXPECT_TRUE(yielded);
}

TEST_F(RutFollowingLaw, IsContinuousAtYieldWhateverTheLogHolds) {
  // Interpolated entries do not agree with the table to the last digit; the load must not jump for that.
  const auto ahead = lead(0.25);
  const Rut rut{1.01 * ahead.load.rut_depth, 0.25, ahead.virgin_drag, 0.98 * ahead.virgin_vertical};
  const auto at = [&](double penetration) { return ground_load(ground_, place(penetration), &rut).load; };
  double low = rut.depth, high = 0.5;  // the penetration at which the floor yields
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (at(middle).rut_depth > rut.depth ? high : low) = middle;
  }
  EXPECT_NEAR(at(low).vertical, at(high).vertical, 0.1);
  EXPECT_NEAR(at(low).drag, at(high).drag, 0.1);
  EXPECT_NEAR(at(low).spin_ratio, at(high).spin_ratio, 1e-6);
}

TEST_F(RutFollowingLaw, LoadGrowsSteadilyThroughYield) {
  const auto ahead = lead(0.25);
  double before = 0.0, largest = 0.0;
  for (double p = ahead.load.rut_depth; p < 0.5; p += 0.001) {
    const double now = trail(p, ahead).load.vertical;
    EXPECT_GE(now, before - 1.0) << p;
    largest = std::max(largest, now - before);
    before = now;
  }
  EXPECT_LT(largest, 0.1 * before);  // no jump
}

}  // namespace
}  // namespace apc::simulation
