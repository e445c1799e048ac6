// The entry speed: read off a speed signal that began on the pavement, weighed against the recorded one.
#include "apc/learning/entry_speed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/learning/layout.h"

namespace apc::learning {
namespace {

/// 30 m/s at entry, 0.4 m/s² on the pavement and 5 m/s² in the bed, read late by the mean delay.
Run rolled(double from, double every, double lag = 0.1) {
  Run run;
  run.overrun.entry_speed = 30.2, run.uncertainty.entry_speed = 0.2;
  Channel speed;
  speed.quantity = Quantity::speed;
  speed.noise = 0.1, speed.bias = 0.05, speed.scale = 0.002, speed.lag = lag;
  for (double t = from; t < 2.0; t += every) {
    const double true_time = t - mean_lag * lag;
    speed.time.push_back(t), speed.value.push_back(30.0 - (true_time < 0.0 ? 0.4 : 5.0) * true_time);
  }
  run.channels = {speed};
  return run;
}

TEST(EntrySpeed, IsTheLineOfThePavementAtTheEdge) {
  const auto told = entry_speed_of_signal(rolled(-1.95, 0.1));
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->value, 30.0, 1e-9) << "what the bed does later and the delay of the instrument are not in it";
  // Twenty readings: their line at its end is known to about twice the noise over the root of their number.
  EXPECT_NEAR(told->deviation, std::hypot(0.05, 0.06, 2.0 * 0.1 / std::sqrt(20.0)), 0.005);
}

TEST(EntrySpeed, IsWeighedAgainstTheRecordedOne) {
  const auto run = rolled(-1.95, 0.1);
  const auto told = entry_speed_of_signal(run);
  const EntrySpeed both = entry_speed(run);
  const double share = 0.04 / (0.04 + told->deviation * told->deviation);
  EXPECT_NEAR(both.value, 30.2 - share * 0.2, 1e-9);
  EXPECT_LT(both.deviation, told->deviation);
}

TEST(EntrySpeed, ASignalThatContradictsOrSaysTooLittleIsLeftOut) {
  auto run = rolled(-1.95, 0.1);
  run.overrun.entry_speed = 31.5;
  EXPECT_EQ(entry_speed(run).value, 31.5) << "one of the two is at fault";
  EXPECT_FALSE(entry_speed_of_signal(rolled(-0.3, 0.1))) << "four readings";
  EXPECT_FALSE(entry_speed_of_signal(rolled(0.05, 0.1))) << "nothing before the bed";
  EXPECT_EQ(entry_speed(rolled(0.05, 0.1)).value, 30.2);
  auto silent = run;
  silent.channels.clear();
  EXPECT_EQ(entry_speed(silent).deviation, 0.2);
}

}  // namespace
}  // namespace apc::learning
