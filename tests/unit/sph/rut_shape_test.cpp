#include "sph_backend/rut_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases.h"

namespace apc::sph {
namespace {

using testing::quick_case;
using units::in;

/// Columns of full particles, 1 in wide, up to the given heights.
std::vector<Grain> columns(const std::vector<double>& heights) {
  std::vector<Grain> grains;
  for (std::size_t k = 0; k < heights.size(); ++k)
    for (double z = heights[k]; z > 0.0; z -= in)
      grains.push_back({(static_cast<double>(k) + 0.5) * in, std::max(z - in, 0.0), z});
  return grains;
}

FurrowWheel wheel_of(const TireShape& tire, double bed_depth, double penetration) {
  return {section(tire), bed_depth - penetration + 0.5 * tire.diameter};
}

TEST(RutShape, MeasuresASectionWithAKnownAnswer) {
  // Floor at 8 in under 24, wall rising by 4 in an inch from the centre of the strip at 6.5 in, berm of 1.5 in.
  const Surface surface = surface_of(columns({8 * in, 8 * in, 8.2 * in, 7.9 * in, 8 * in, 8 * in, 8 * in, 12 * in,
                                              16 * in, 20 * in, 25.5 * in, 24 * in}),
                                     0.0, 12 * in, in);
  const RutShape shape = rut_shape(surface, wheel_of(testing::main_tire(), 24 * in, 16 * in), 24 * in, 16 * in);
  EXPECT_NEAR(shape.floor, 8.0 * in, 1e-9);
  EXPECT_NEAR(shape.floor_ideal, 8.0 * in, 1e-9);
  EXPECT_NEAR(shape.wall, 8.5 * in, 1e-9);
  const double upper = 9.5 + (22.4 - 20.0) / 5.5, lower = 6.5 + 1.6 / 4.0;
  EXPECT_NEAR(shape.wall_width, (upper - lower) * in, 1e-9);
  EXPECT_NEAR(shape.berm, 1.5 * in, 1e-9);
  EXPECT_GT(shape.flank_width, 2.0 * in);
  EXPECT_LT(shape.flank_width, 4.0 * in);
  EXPECT_NEAR(shape.flank, 8.25 * in, 0.15 * in);  // 8 in above the lowest point the wheel is nearly at its widest
}

TEST(RutShape, ASharpStepHasTheWidthOfFourFifthsOfAStrip) {
  const Surface surface =
      surface_of(columns({8 * in, 8 * in, 8 * in, 8 * in, 8 * in, 24 * in, 24 * in}), 0.0, 7 * in, in);
  const RutShape shape = rut_shape(surface, wheel_of(testing::nose_tire(), 24 * in, 16 * in), 24 * in, 16 * in);
  EXPECT_NEAR(shape.wall_width, 0.8 * in, 1e-9);
  EXPECT_NEAR(shape.wall, 5.0 * in, 1e-9);
}

TEST(RutShape, FragmentsInFlightDoNotCountAHeapDoes) {
  auto grains = columns({8 * in, 8 * in});
  grains.push_back({0.5 * in, 12 * in, 13 * in});
  grains.push_back({1.5 * in, 8.5 * in, 9.5 * in});
  const Surface surface = surface_of(grains, 0.0, 2 * in, in);
  EXPECT_NEAR(surface.height[0], 8 * in, 1e-12);
  EXPECT_NEAR(surface.height[1], 9.5 * in, 1e-12);
}

TEST(RutShape, NoRutHasNoWall) {
  const Surface surface = surface_of(columns({24 * in, 24 * in, 24 * in}), 0.0, 3 * in, in);
  const RutShape shape = rut_shape(surface, wheel_of(testing::nose_tire(), 24 * in, 1 * in), 24 * in, 1 * in);
  EXPECT_NEAR(shape.floor, 24 * in, 1e-12);
  EXPECT_TRUE(std::isnan(shape.wall));
  EXPECT_TRUE(std::isnan(shape.wall_width));
}

TEST(RutShape, OfARollingRunFollowsTheWheel) {
  const RollingCase c = quick_case();
  const RutShape shape = roll(c).shape;
  EXPECT_GT(shape.behind, 0.3 * c.tire.diameter);
  EXPECT_NEAR(shape.floor_ideal, c.bed_depth - c.penetration, 1e-12);
  EXPECT_GT(shape.floor, shape.floor_ideal - 0.2 * c.spacing);  // the tire gives way, the foam comes back
  EXPECT_LT(shape.floor, shape.floor_ideal + c.spacing);
  EXPECT_NEAR(shape.wall, shape.flank, c.spacing);
  EXPECT_GT(shape.wall_width, 0.0);
  EXPECT_LT(std::abs(shape.berm), 2.0 * c.spacing);
}

}  // namespace
}  // namespace apc::sph
