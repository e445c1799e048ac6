#include "apc/learning/data_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/learning/run_json.h"

namespace apc::learning {
namespace {

/// A run that brakes with 4 m/s² from 20 m/s: consistent speed, acceleration and stop.
Run steady_run(const std::string& id) {
  Run run;
  run.id = id;
  run.overrun.entry_speed = 20.0;
  run.stop = 50.0;
  Channel speed, acceleration;
  speed.column = "speed", speed.quantity = Quantity::speed, speed.noise = 0.1, speed.bias = 0.05;
  acceleration.column = "ax", acceleration.quantity = Quantity::acceleration_x, acceleration.noise = 0.3,
  acceleration.bias = 0.15;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i, ripple = 0.1 * std::sin(40.0 * t) + 1e-3 * static_cast<double>(id.size());
    acceleration.time.push_back(t), acceleration.value.push_back(-4.0 + ripple);
    if (i % 10 == 0) speed.time.push_back(t), speed.value.push_back(20.0 - 4.0 * t + 0.02 * std::sin(9.0 * t));
  }
  run.channels = {speed, acceleration};
  return run;
}

Case with(const Run& run) {
  Case data;
  data.runs = {run};
  return data;
}

TEST(DataCheck, LeavesGoodRunsAlone) {
  Case data = with(steady_run("a"));
  check_runs(data);
  EXPECT_EQ(data.runs.size(), 1u);
  EXPECT_TRUE(data.remarks.empty());
}

TEST(DataCheck, TurnsAFlippedAccelerometerOver) {
  auto run = steady_run("a");
  for (double& a : run.channels[1].value) a = -a;
  Case data = with(run);
  check_runs(data);
  ASSERT_EQ(data.remarks.size(), 1u);
  EXPECT_EQ(data.remarks[0].action, DataRemark::Action::repaired);
  EXPECT_LT(data.runs[0].channels[1].value[100], 0.0);
}

TEST(DataCheck, RecognisesAWrongUnit) {
  auto run = steady_run("a");
  for (double& a : run.channels[1].value) a /= 9.80665;
  Case data = with(run);
  check_runs(data);
  EXPECT_NEAR(data.runs[0].channels[1].value[0], -4.0, 0.2);
  run = steady_run("b");
  for (double& v : run.channels[0].value) v *= 1.94384;
  data = with(run);
  check_runs(data);
  EXPECT_NEAR(data.runs[0].channels[0].value[0], 20.0, 0.1);
}

TEST(DataCheck, SetsAsideARunThatContradictsItself) {
  auto run = steady_run("a");
  run.stop = 70.0;
  Case data = with(run);
  check_runs(data);
  EXPECT_TRUE(data.runs.empty());
  ASSERT_FALSE(data.remarks.empty());
  EXPECT_EQ(data.remarks[0].action, DataRemark::Action::run_set_aside);
}

TEST(DataCheck, KeepsOneOfTwoCopies) {
  Case data = with(steady_run("a"));
  data.runs.push_back(data.runs[0]);
  data.runs[1].id = "b";
  check_runs(data);
  ASSERT_EQ(data.runs.size(), 1u);
  EXPECT_EQ(data.runs[0].id, "a");
}

TEST(DataCheck, LeavesOutTimeThatRunsBackwards) {
  auto run = steady_run("a");
  std::swap(run.channels[1].time[200], run.channels[1].time[201]);
  Case data = with(run);
  check_runs(data);
  EXPECT_EQ(data.runs[0].channels[1].time.size(), 500u);
}

TEST(DataCheck, CountsYearsBetweenDates) {
  EXPECT_NEAR(years_between("2019-03-01", "2025-03-01"), 6.0, 0.01);
  EXPECT_TRUE(std::isnan(years_between("", "2025-03-01")));
}

}  // namespace
}  // namespace apc::learning
