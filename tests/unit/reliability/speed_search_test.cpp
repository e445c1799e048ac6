#include "apc/reliability/speed_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace apc::reliability {
namespace {

struct Found {
  double speed;
  int runs;
};

Found search(const std::function<double(double)>& ratio, double guess, double exponent, const SearchRange& range = {}) {
  SpeedSearch search(guess, exponent, range);
  int runs = 0;
  while (!search.done() && runs < 200) search.tell(ratio(search.speed())), ++runs;
  return {search.speed(), runs};
}

TEST(SpeedSearch, NeedsOneRunNearTheRootAndTwoFarFromIt) {
  const auto stop = [](double v) { return std::pow(v / 33.0, 2.0); };
  const auto near = search(stop, 32.6, 2.0), far = search(stop, 25.0, 2.0);
  EXPECT_NEAR(near.speed, 33.0, 0.02);
  EXPECT_EQ(near.runs, 1);
  EXPECT_NEAR(far.speed, 33.0, 0.1);
  EXPECT_EQ(far.runs, 2);
}

TEST(SpeedSearch, KeepsItsToleranceWhereTheExponentIsAnotherThanExpected) {
  for (const double exponent : {0.15, 0.6, 2.6})
    for (const double guess : {12.0, 28.0, 55.0}) {
      const auto found =
          search([&](double v) { return std::pow(v / 30.0, exponent); }, guess, 0.5, {5.0, 60.0, 0.1, 1.0});
      EXPECT_NEAR(found.speed, 30.0, 0.1) << exponent << " from " << guess;
      EXPECT_LE(found.runs, 7) << exponent << " from " << guess;
    }
}

/// Nearly flat below, a jump, steep above: what a peak load does where another gear takes the lead.
TEST(SpeedSearch, FindsTheJumpOfALoad) {
  const auto use = [](double v) { return v < 27.3 ? 0.95 + 1e-4 * v : 1.1 * std::pow(v / 27.3, 1.5); };
  for (const double guess : {8.0, 26.0, 45.0}) {
    const auto found = search(use, guess, 0.3, {5.0, 50.0, 0.1, 0.3});
    EXPECT_NEAR(found.speed, 27.3, 0.5) << guess;
    EXPECT_LE(found.runs, 16) << guess;
  }
}

TEST(SpeedSearch, TheLowestCrossingCountsWhereALoadFallsBack) {
  const auto use = [](double v) { return v < 20 ? v / 20 : v < 30 ? 1.2 : 0.9 * v / 30; };  // 1 at 20 and at 33.3
  EXPECT_NEAR(search(use, 24.0, 0.5).speed, 20.0, 0.3);
}

TEST(SpeedSearch, EndsOfTheRangeAreAnswers) {
  EXPECT_EQ(search([](double) { return 0.2; }, 30.0, 2.0).speed, 60.0);
  EXPECT_EQ(search([](double) { return 5.0; }, 30.0, 2.0).speed, 0.0);
  EXPECT_EQ(search([](double) { return 0.0; }, 30.0, 0.3).speed, 60.0);
}

TEST(SpeedSearch, LearnsFromRunsMadeForAnotherQuestion) {
  SpeedSearch search(30.0, 0.3, {5.0, 36.0, 0.1, 0.3});
  const auto use = [](double v) { return std::pow(v / 31.0, 0.5); };
  search.tell(36.0, use(36.0));
  search.tell(33.0, use(33.0));
  while (!search.done()) search.tell(use(search.speed()));
  EXPECT_NEAR(search.speed(), 31.0, 0.1);
}

}  // namespace
}  // namespace apc::reliability
