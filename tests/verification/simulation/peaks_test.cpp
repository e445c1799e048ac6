/// Extremes of the fast path without a history, which looks only where its steps begin, halve and end, against the same
/// runs observed every 2 ms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/shipped_models.h"

namespace apc::simulation {
namespace {

TEST(PeaksWithoutHistory, MissLittle) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto plane = testing::shipped_aircraft(name);
    const auto tables = testing::shipped_tables(plane);
    double deceleration = 0.0, drag = 0.0, vertical = 0.0;
    for (const double inches : {14.0, 18.0, 24.0}) {
      const auto model = make_model(plane, testing::foam_bed(inches * units::in), tables);
      for (double knots = 30.0; knots <= 70.0; knots += 10.0)
        for (const double braking : {0.0, 0.25}) {
          Overrun overrun;
          overrun.entry_speed = knots * units::kt;
          overrun.braking = braking;
          Options options;
          options.method = Method::fast;
          const auto seen = simulate(model, overrun, options);
          options.sampling = 0.0;
          const auto quick = simulate(model, overrun, options);
          EXPECT_EQ(quick.stop_distance, seen.stop_distance);  // observing changes no bit of the motion
          const auto miss = [](double& worst, double found, double truth) {
            const double error = found / truth - 1.0;
            if (std::abs(error) > std::abs(worst)) worst = error;
          };
          miss(deceleration, quick.peak_deceleration, seen.peak_deceleration);
          for (std::size_t g = 0; g < seen.gears.size(); ++g) {
            miss(drag, quick.gears[g].peak_drag, seen.gears[g].peak_drag);
            miss(vertical, quick.gears[g].peak_vertical, seen.gears[g].peak_vertical);
          }
        }
    }
    std::printf(
        "peaks without history, %s, worst of 30 runs: deceleration %+.2f %%, drag %+.2f %%, vertical %+.2f %%\n", name,
        100 * deceleration, 100 * drag, 100 * vertical);
    EXPECT_LT(std::abs(deceleration), 0.03);
    EXPECT_LT(std::abs(drag), 0.03);
    EXPECT_LT(std::abs(vertical), 0.03);
  }
}

}  // namespace
}  // namespace apc::simulation
