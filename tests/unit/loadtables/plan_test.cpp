#include "loadtables/plan.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "loadtables/penetration_scale.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::HasSubstr;
namespace u = units;

Plan plan(int runs = 60, unsigned seed = 1) {
  PlanOptions options;
  options.runs = runs;
  options.seed = seed;
  return make_plan(synthetic::tire(), "foam", options);
}

TEST(Plan, StaysInItsBoxAndKeepsTheDefinitionOfPenetration) {
  const auto made = plan();
  const auto scale = penetration_scale(synthetic::tire());
  ASSERT_EQ(made.runs.size(), 60u);
  for (const auto& run : made.runs) {
    EXPECT_GE(run.contact.speed, 10 * u::kt * 0.999999);
    EXPECT_LE(run.contact.speed, 70 * u::kt * 1.000001);
    EXPECT_GE(run.contact.bed_depth, 3 * u::in * 0.999999);
    EXPECT_LE(run.contact.bed_depth, 36 * u::in * 1.000001);
    EXPECT_GE(run.relative_penetration, 0.1);
    EXPECT_LE(run.relative_penetration, 1.0);
    EXPECT_NEAR(run.contact.penetration, run.relative_penetration * scale.at(run.contact.bed_depth), 1e-12);
    const double courses = run.contact.bed_depth / u::in;
    EXPECT_NEAR(courses, std::round(courses), 1e-9);
  }
}

TEST(Plan, HoldsTheCornersOfTheBox) {
  std::set<std::string> corners;
  for (const auto& run : plan().runs) {
    const auto end = [](double x, double low, double high) {
      return std::abs(x - low) < 1e-9 ? "low " : std::abs(x - high) < 1e-9 ? "high " : "";
    };
    const std::string v = end(run.contact.speed, 10 * u::kt, 70 * u::kt),
                      h = end(run.contact.bed_depth, 3 * u::in, 36 * u::in),
                      r = end(run.relative_penetration, 0.1, 1.0);
    if (!v.empty() && !h.empty() && !r.empty()) corners.insert(v + h + r);
  }
  EXPECT_EQ(corners.size(), 8u);
}

TEST(Plan, PutsMostRunsWhereTiresRide) {
  int deep = 0;
  for (const auto& run : plan().runs) deep += run.relative_penetration >= 0.3;
  EXPECT_GE(deep, 45);
}

TEST(Plan, IsTheSameForTheSameSeedAndDiffersForAnother) {
  const auto a = plan(), b = plan(), c = plan(60, 2);
  int differing = 0;
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    EXPECT_EQ(a.runs[i].contact.speed, b.runs[i].contact.speed);
    EXPECT_EQ(a.runs[i].contact.penetration, b.runs[i].contact.penetration);
    differing += a.runs[i].contact.speed != c.runs[i].contact.speed;
  }
  EXPECT_GT(differing, 30);
}

/// Smallest distance between two runs in the scaled box.
double closest(const Plan& made, std::size_t count) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = made.runs[i], &b = made.runs[j];
      const double v = (a.contact.speed - b.contact.speed) / (60 * u::kt),
                   h = std::log(a.contact.bed_depth / b.contact.bed_depth) / std::log(12.0),
                   r = (a.relative_penetration - b.relative_penetration) / 0.9;
      least = std::min(least, std::sqrt(v * v + h * h + r * r));
    }
  return least;
}

TEST(Plan, SpreadsItsRuns) {
  const auto made = plan();
  EXPECT_GT(closest(made, 60), 0.1);  // 60 random points come within about 0.03 of one another
  EXPECT_GT(closest(made, 15), 0.3);  // and any first part covers the box
}

TEST(Plan, SurvivesItsFile) {
  const synthetic::Folder folder("plan");
  const auto made = plan(20);
  write_plan(made, folder.path());
  const auto back = read_plan(folder.path());
  EXPECT_EQ(back.material, "foam");
  EXPECT_EQ(back.tire.curve_load, made.tire.curve_load);
  EXPECT_EQ(back.options.seed, 1u);
  ASSERT_EQ(back.runs.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_DOUBLE_EQ(back.runs[i].contact.speed, made.runs[i].contact.speed);
    EXPECT_DOUBLE_EQ(back.runs[i].contact.penetration, made.runs[i].contact.penetration);
  }
}

TEST(Plan, RefusesSenselessRangesAndMissingFiles) {
  PlanOptions options;
  options.runs = 5;
  EXPECT_THROW(make_plan(synthetic::tire(), "foam", options), InputError);
  options = {};
  options.speed = {0.0, 36.0};
  EXPECT_THROW(make_plan(synthetic::tire(), "foam", options), InputError);
  options = {};
  options.bed_depth = {0.5, 0.4};
  EXPECT_THROW(make_plan(synthetic::tire(), "foam", options), InputError);
  options = {};
  options.relative_penetration = {0.1, 2.0};
  EXPECT_THROW(make_plan(synthetic::tire(), "foam", options), InputError);
  const synthetic::Folder folder("no_plan");
  try {
    read_plan(folder.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("apc loads plan"));
  }
}

}  // namespace
}  // namespace apc::loadtables
