#include "apc/base/curve.h"

#include <gtest/gtest.h>

#include "apc/base/require.h"

namespace apc {
namespace {

TEST(LinearCurve, IsStraightBetweenPointsAndConstantBeyond) {
  const LinearCurve curve({0.0, 1.0, 3.0}, {0.0, 2.0, 0.0});
  EXPECT_DOUBLE_EQ(curve(0.25), 0.5);
  EXPECT_DOUBLE_EQ(curve(2.0), 1.0);
  EXPECT_DOUBLE_EQ(curve(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(curve(9.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.slope(0.5), 2.0);
  EXPECT_DOUBLE_EQ(curve.slope(-0.1), 0.0);
}

TEST(MonotoneCurve, PassesThroughItsPointsWithoutOvershoot) {
  const MonotoneCurve curve({0.0, 1.0, 2.0, 3.0}, {0.0, 0.1, 5.0, 5.0});
  for (double x = 0.0, last = -1e-12; x <= 3.0; x += 0.01) {
    EXPECT_GE(curve(x), last - 1e-12) << x;
    EXPECT_LE(curve(x), 5.0 + 1e-12);
    last = curve(x);
  }
  EXPECT_DOUBLE_EQ(curve(1.0), 0.1);
  EXPECT_DOUBLE_EQ(curve(2.0), 5.0);
}

TEST(MonotoneCurve, ReproducesStraightLinesAndContinuesThem) {
  const MonotoneCurve curve({0.0, 1.0, 4.0}, {1.0, 3.0, 9.0});
  for (const double x : {-2.0, 0.3, 2.5, 7.0}) {
    EXPECT_NEAR(curve(x), 1.0 + 2.0 * x, 1e-12);
    EXPECT_NEAR(curve.slope(x), 2.0, 1e-12);
  }
}

TEST(MonotoneCurve, SlopeMatchesDifferencesAndIsContinuous) {
  const MonotoneCurve curve({0.0, 0.09, 0.22}, {0.0, 199e3, 538e3});
  for (const double x : {0.01, 0.05, 0.15, 0.25})
    EXPECT_NEAR(curve.slope(x), (curve(x + 1e-6) - curve(x - 1e-6)) / 2e-6, 1.0) << x;
  for (const double knot : {0.09, 0.22}) EXPECT_NEAR(curve.slope(knot - 1e-9), curve.slope(knot + 1e-9), 1.0);
}

TEST(MonotoneCurve, InverseUndoesIt) {
  const MonotoneCurve curve({0.0, 0.09, 0.22}, {0.0, 199e3, 538e3});
  for (const double x : {0.0, 0.03, 0.09, 0.2, 0.3}) EXPECT_NEAR(curve.inverse(curve(x)), x, 1e-9);
}

TEST(MonotoneCurve, IntegralIsTheAreaBelow) {
  const MonotoneCurve curve({0.0, 1.0, 2.0}, {0.0, 1.0, 4.0});
  double sum = 0.0;
  for (int i = 0; i < 30000; ++i) sum += curve((i + 0.5) * 1e-4) * 1e-4;
  EXPECT_NEAR(curve.integral(3.0), sum, 1e-6);
  EXPECT_EQ(curve.integral(0.0), 0.0);
}

TEST(Curves, RefuseWhatIsNoCurve) {
  EXPECT_THROW(LinearCurve({0.0, 1.0}, {0.0}), InputError);
  EXPECT_THROW(LinearCurve({0.0}, {0.0}), InputError);
  EXPECT_THROW(MonotoneCurve({0.0, 1.0, 1.0}, {0.0, 1.0, 2.0}), InputError);
  EXPECT_THROW(MonotoneCurve({0.0, -1.0}, {0.0, 1.0}), InputError);
}

}  // namespace
}  // namespace apc
