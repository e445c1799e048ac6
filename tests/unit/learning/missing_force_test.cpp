// What a missing force follows, where it is known.
#include "apc/learning/missing_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace apc::learning {
namespace {

/// Three stops from different speeds; `law` gives the missing force, noise of 0.01 on top.
template <class Law>
std::vector<MissingForce> readings(const Law& law) {
  std::mt19937 random(7);
  std::normal_distribution<double> one;
  std::vector<MissingForce> list;
  for (std::size_t run = 0; run < 3; ++run) {
    const double entry = 20.0 + 7.0 * static_cast<double>(run);
    for (double t = 0.0; t < entry / 3.0; t += 0.1) {
      MissingForce m;
      m.run = run, m.time = t, m.speed = entry - 3.0 * t, m.place = entry * t - 1.5 * t * t;
      m.penetration = 0.3 + 0.1 * one(random), m.vertical = 3e5 + 5e4 * one(random);
      m.missing = law(m) + 0.01 * one(random);
      list.push_back(m);
    }
  }
  return list;
}

double share(const std::vector<Attribution>& list, const std::string& name) {
  for (const auto& a : list)
    if (a.coordinate == name) return a.share;
  ADD_FAILURE() << name;
  return -1.0;
}

TEST(MissingForce, ALawOfPenetrationIsAttributedToIt) {
  const auto list = attributions(readings([](const MissingForce& m) { return 0.5 * (m.penetration - 0.3); }), 1.22);
  EXPECT_EQ(list.front().coordinate, "penetration");
  EXPECT_GT(list.front().share, 0.9);
  EXPECT_LT(list[1].share, 0.1);
}

TEST(MissingForce, JointsShowInThePlaceWithinTheirPitch) {
  const auto points = readings([](const MissingForce& m) { return std::fmod(m.place, 2.44) < 0.4 ? -0.1 : 0.02; });
  EXPECT_GT(share(attributions(points, 2.44), "place within a joint's pitch"), 0.7);
  EXPECT_LT(share(attributions(points, 1.9), "place within a joint's pitch"), 0.2);
}

TEST(MissingForce, AConstantOfARunIsAttributedToTheRun) {
  const auto list = attributions(readings([](const MissingForce& m) { return m.run == 1 ? 0.05 : 0.0; }), 1.22);
  EXPECT_EQ(list.front().coordinate, "run");
}

TEST(MissingForce, NoiseFollowsNothing) {
  for (const auto& a : attributions(readings([](const MissingForce&) { return 0.0; }), 1.22))
    EXPECT_LT(a.share, 0.08) << a.coordinate;
  EXPECT_TRUE(attributions({}, 1.22).empty());
}

}  // namespace
}  // namespace apc::learning
