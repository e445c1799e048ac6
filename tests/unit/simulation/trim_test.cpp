#include "apc/simulation/trim.h"

#include <gtest/gtest.h>

#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

// From a level attitude the first Newton steps pitched a CRJ-200 here and there down until its light nose tire was
// flat, and then led to and fro for ever.
TEST(TrimFromTheStaticStand, IsFoundForEveryMassAndCentreOfGravityInService) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    const auto model = testing::foam_model(name, testing::foam_bed(0.4));
    int most = 0;
    for (double mass = 0.75; mass <= 1.05; mass += 0.01)
      for (double cg = 0.96; cg <= 1.02; cg += 0.002)
        for (const double braking : {0.0, 0.25}) {
          Overrun overrun;
          overrun.entry_speed = 60 * units::kt;
          overrun.mass = mass * model.aircraft.mass;
          overrun.cg_behind_nose_gear = cg * model.aircraft.cg_behind_nose_gear;
          overrun.braking = braking;
          most = std::max(most, trim(make_plant(model, overrun), overrun.entry_speed).iterations);
        }
    EXPECT_LT(most, 20) << name;
  }
}

}  // namespace
}  // namespace apc::simulation
