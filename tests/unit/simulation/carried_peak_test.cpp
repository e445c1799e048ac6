#include "apc/simulation/carried_peak.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apc::simulation {
namespace {

TEST(CarriedPeak, OfASmoothSignalHasNoTermOfTime) {
  // F = 7 p − (t − 2 p)² at p = 1: the peak 7 p moves to 2 p; at fixed times dF/dp = 7 + 4 (t − 2 p).
  const auto at = [](double t) {
    const double off = t - 2.0;
    return CarriedPeak::Sample{7.0 - off * off, -2.0 * off, 7.0 + 4.0 * off};
  };
  CarriedPeak peak;
  for (const double t : {0.0, 1.0, 1.9, 2.3, 4.0}) peak.offer(at(t).value, at(t).slope);
  EXPECT_NEAR(peak.slope(), 6.6, 1e-12);  // of the highest sample
  peak.offer_between(7.0, at(1.9), at(2.3));
  EXPECT_NEAR(peak.slope(), 7.0, 1e-12);
}

TEST(CarriedPeak, AtACornerMovesWithTheCornersTime) {
  // F = 3 p + 2 (t − p) before t = p, 3 p − 5 (t − p) after it: the peak is 3 p.
  const CarriedPeak::Sample before{2.8, 2.0, 1.0}, after{2.5, -5.0, 8.0};
  CarriedPeak peak;
  peak.offer_between(3.0, before, after);  // nobody says where the corner is
  EXPECT_NEAR(peak.slope(), 3.0, 1e-12);
  CarriedPeak known;
  known.offer_corner({3.0, 2.0, 3.0}, {3.0, -5.0, 3.0});
  EXPECT_EQ(known.value(), 3.0);
  EXPECT_EQ(known.slope(), 3.0);
}

TEST(CarriedPeak, AtAJumpStandsOnItsHigherSide) {
  CarriedPeak down, up, on_its_way;
  down.offer_corner({3.0, 2.0, 0.7}, {1.0, 4.0, 9.0});
  EXPECT_EQ(down.slope(), 0.7);
  up.offer_corner({1.0, -2.0, 9.0}, {3.0, -2.0, 0.4});
  EXPECT_EQ(up.slope(), 0.4);
  on_its_way.offer_corner({1.0, 2.0, 9.0}, {3.0, 2.0, 0.4});  // rises on: no peak here
  EXPECT_LT(on_its_way.value(), 0.0);
}

TEST(CarriedPeak, BetweenThreeInstantsIsTheVertexOfTheirParabola) {
  // Unequal instants of F = p (4 − (t − p)²) at p = 1, whose peak is 4 p.
  CarriedPeak peak;
  for (const double t : {0.0, 0.7, 1.2, 3.0}) {
    const double off = t - 1.0;
    peak.see(t, 4.0 - off * off, 4.0 - off * off + 2.0 * off);
  }
  EXPECT_NEAR(peak.value(), 4.0, 1e-12);
  EXPECT_NEAR(peak.slope(), 4.0, 0.1);  // between neighbours by a straight line
}

}  // namespace
}  // namespace apc::simulation
