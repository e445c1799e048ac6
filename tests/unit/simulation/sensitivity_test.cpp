#include "apc/simulation/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/require.h"
#include "tests/support/differences.h"

namespace apc::simulation {
namespace {

using testing::braked, testing::differenced;

TEST(Sensitivity, OfTheStopAgreesWithDifferences) {
  const auto model = testing::foam_model("CRJ-200", testing::foam_bed(0.3));
  const auto parameter = parameters::entry_speed();
  const auto expected = differenced(model, braked(40), parameter, 1e-3);
  EXPECT_NEAR(sensitivity(model, braked(40), parameter).stop_distance, expected.stop, 5e-3 * expected.stop);
}

TEST(Sensitivity, RefusesAParameterThatMovesNothing) {
  const auto model = testing::foam_model("B737-800", testing::foam_bed(0.4572));
  EXPECT_THROW(sensitivity(model, braked(60), {"nothing", "1", 0.0, 1.0, {}}), InputError);
}

}  // namespace
}  // namespace apc::simulation
