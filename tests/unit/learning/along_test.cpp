// What is hidden in runs of our own making must be found again along the measured motion, and nothing where nothing is.
#include "apc/learning/along.h"

#include <gtest/gtest.h>

#include "apc/effects/catalogue.h"
#include "tests/support/surveyed_runs.h"

namespace apc::learning {
namespace {

struct Weighed {
  std::map<std::string, Evidence> best;  ///< per effect or fault
  const Evidence& of(const std::string& id) const { return best.at(id); }
  std::string first() const {
    return std::max_element(best.begin(), best.end(),
                            [](const auto& a, const auto& b) { return a.second.log_evidence < b.second.log_evidence; })
        ->first;
  }
};

Weighed weighed(const testing::SurveyedRuns& wanted) {
  const Case data = testing::surveyed_case(wanted);
  const Layout layout = make_layout(data, data.runs);
  const auto along = balance_along(data, layout, 0);
  EXPECT_TRUE(along);
  const Screen screen = weigh_along(*along, data, layout, effects::catalogue(), 0);
  Weighed result;
  for (const Hypothesis& h : screen.hypotheses) {
    if (h.kind == Hypothesis::Kind::learned || !h.run.empty()) continue;
    const Evidence e = evidence_of(screen.scores, h.candidate);
    const auto found = result.best.find(h.id);
    if (found == result.best.end() || found->second.log_evidence < e.log_evidence) result.best[h.id] = e;
  }
  return result;
}

testing::SurveyedRuns with(const std::string& id, double amplitude) {
  testing::SurveyedRuns wanted;
  wanted.hidden = {effects::applied(effects::find_effect(effects::catalogue(), id), amplitude)};
  return wanted;
}

TEST(Along, FindsNothingWhereNothingIsHidden) {
  const Weighed w = weighed({});
  EXPECT_LT(w.of(w.first()).log_evidence, 5.0) << w.first();
}

TEST(Along, FindsTheInertiaOfTheFoamWithItsSize) {
  const Weighed w = weighed(with("inertial", 0.8));
  EXPECT_EQ(w.first(), "inertial");
  const Evidence& e = w.of("inertial");
  EXPECT_GT(e.log_evidence, 5.0);
  EXPECT_NEAR(e.amplitude[0], 0.8, 3.0 * std::sqrt(e.covariance(0, 0)));
}

TEST(Along, FindsThrustWithItsSize) {
  const Weighed w = weighed(with("thrust", 2.0e4));
  EXPECT_EQ(w.first(), "thrust");
  const Evidence& e = w.of("thrust");
  EXPECT_NEAR(e.amplitude[0], 2.0e4, 3.0 * std::sqrt(e.covariance(0, 0)));
}

TEST(Along, BlamesAnAccelerometerThatReadsTooMuch) {
  testing::SurveyedRuns wanted;
  wanted.accelerometer_scale = 1.08;
  const Weighed w = weighed(wanted);
  EXPECT_EQ(w.first(), "acceleration_x.scale");
  EXPECT_NEAR(w.of("acceleration_x.scale").amplitude[0], 0.08, 0.025);
}

}  // namespace
}  // namespace apc::learning
