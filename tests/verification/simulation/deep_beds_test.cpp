/// Beds so deep that wheels leave their tables: every overrun ends as an outcome, with ruts that fit into the bed.
#include <gtest/gtest.h>

#include <cstdio>

#include "apc/base/require.h"
#include "apc/simulation/overrun_run.h"
#include "tests/support/shipped_models.h"

namespace apc::simulation {
namespace {

TEST(DeepBeds, EveryOverrunEndsAsAnOutcomeWithRutsThatFitIntoTheBed) {
  int runs = 0, stopped = 0, over = 0, failed = 0;
  for (const auto* name : {"CRJ-200", "B727-100", "B737-800", "B747-400"})
    for (const double inches : {9.0, 14.0, 18.0, 24.0, 30.0, 36.0}) {
      const double depth = inches * units::in;
      const auto model = testing::shipped_model(name, testing::foam_bed(depth));
      for (const double knots : {30.0, 50.0, 70.0})
        for (const double braking : {0.0, 0.25})
          for (const auto method : {Method::reference, Method::fast}) {
            Overrun overrun;
            overrun.entry_speed = knots * units::kt;
            overrun.braking = braking;
            Options options;
            options.method = method;
            options.sampling = 0.0;
            ++runs;
            SCOPED_TRACE(name + std::string(" ") + std::to_string(inches) + " in " + std::to_string(knots) + " kt " +
                         std::to_string(braking));
            try {
              const auto result = simulate(model, overrun, options);
              const bool fell = result.outcome == Outcome::pitched_over;
              fell ? ++over : ++stopped;
              EXPECT_EQ(fell, std::isnan(result.stop_distance)) << result.message;
              EXPECT_LE(std::max(result.peak_pitch, -result.lowest_pitch), overturning_pitch * 1.01);
              for (const auto& gear : result.gears) {
                EXPECT_LE(gear.peak_rut, 1.03 * depth) << gear.name;  // fits put ruts that much too deep
                EXPECT_LE(gear.peak_rut, 1.005 * gear.peak_penetration) << gear.name;
              }
            } catch (const SolveError& error) {
              ++failed;
              std::printf("deep bed: %s, %.0f in, %.0f kt, %.2f, %s: %s\n", name, inches, knots, braking,
                          method == Method::fast ? "fast" : "reference", error.what());
            }
          }
    }
  std::printf("deep beds, %d runs: %d stopped, %d pitched over, %d gave up\n", runs, stopped, over, failed);
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(over, 0);
}

}  // namespace
}  // namespace apc::simulation
