#include <gmock/gmock.h>

#include <cmath>

#include "apc/simulation/overrun_run.h"
#include "apc/simulation/rosenbrock.h"
#include "apc/simulation/trim.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Corners, LieWhereTheSlopeOfTheBedChanges) {
  const Profile profile(testing::foam_bed(0.5, 10.0, 100.0), 1.0);
  EXPECT_THAT(profile.corners(0.0), ElementsAre(0.0, 10.0));
  EXPECT_THAT(profile.corners(0.25), ElementsAre(-0.25, 0.0, 0.25, 9.75, 10.0, 10.25));
  EXPECT_TRUE(Profile(testing::pavement(), 1.0).corners(0.25).empty());
}

TEST(Corners, AreReachedByTheRowThatIsNextToThem) {
  // The nose stands in front of the ramp's beginning; its patch feels it half a patch before.
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.5, 10.0));
  Overrun overrun;
  overrun.entry_speed = 30.0;
  const auto plant = make_plant(model, overrun);
  auto y = trim(plant, 30.0).state;
  y[0] -= 1.0;
  Moment moment;
  std::vector<double> rate(y.size());
  derivatives(plant, surroundings_at_entry(plant), 0.0, y.data(), rate.data(), &moment);
  const double way = 1.0 - 0.5 * plant.groups[0].tire_radius, time = time_to_corner(plant, moment);
  EXPECT_NEAR(30.0 * time + 0.5 * moment.cg_acceleration.x * time * time, way, 1e-3);
  y[0] += 2000.0;
  derivatives(plant, surroundings_at_entry(plant), 0.0, y.data(), rate.data(), &moment);
  EXPECT_TRUE(std::isinf(time_to_corner(plant, moment)));
}

TEST(StepControl, ComesBackToItsPlanAfterAStepCutShort) {
  StepControl control(1e-6, 1.0);
  control.start();
  const double planned = control.step(20.0, INFINITY);
  EXPECT_DOUBLE_EQ(control.step(20.0, 0.01 * planned), 0.01 * planned);
  EXPECT_TRUE(control.accepts(0.0, 0.0, nullptr, Plant{}));
  EXPECT_NEAR(control.step(20.0, INFINITY), 0.9 * planned, 0.1 * planned);
}

TEST(StepControl, AllowsLessTheFasterTheAircraftRolls) {
  const double zeros[4] = {};
  const auto accepts = [&](double speed, double size) {
    StepControl control(1e-6, 1.0);
    control.start();
    control.step(speed, INFINITY);
    return control.accepts(size, 0.0, zeros, Plant{});
  };
  EXPECT_TRUE(accepts(20.0, 0.99e-6));
  EXPECT_FALSE(accepts(20.0, 1.01e-6));
  EXPECT_TRUE(accepts(40.0, 0.24e-6));
  EXPECT_FALSE(accepts(40.0, 0.26e-6));
  EXPECT_TRUE(accepts(1.0, 3.9e-6));
  EXPECT_FALSE(accepts(1.0, 4.1e-6));
}

}  // namespace
}  // namespace apc::simulation
