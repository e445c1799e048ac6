// Three runs of a CRJ-200 measured on an independent test range into a bed with weak joints every 8 ft, two blocks: the
// loop must name the joints, their pitch, and nothing else. What was hidden: depth 0.22, width 0.138 m, pitch 2.4384 m.
#include <gtest/gtest.h>

#include <cstdio>

#include "apc/effects/catalogue.h"
#include "apc/learning/diagnose.h"
#include "apc/learning/run_json.h"

namespace apc::learning {
namespace {

TEST(JointsCase, IsDiagnosedAsJointsEveryTwoBlocks) {
  const Case data = load_case(std::filesystem::path(PROJECT_DIR) / "tests/validation/cases/joints");
  DiagnoseOptions options;
  options.effects = effects::catalogue();
  const Study study = diagnose(data, options);
  const Diagnosis& d = study.diagnosis;
  ASSERT_FALSE(d.claims.empty());
  const Claim& first = d.claims.front();
  for (const Claim& claim : d.claims) std::printf("%s P %.3f\n", claim.id.c_str(), claim.probability);
  EXPECT_EQ(first.id, "seams");
  EXPECT_GT(first.probability, 0.8);
  EXPECT_NEAR(first.applied.values[1], 2.4384, 1e-6);
  // Depth and width trade against each other; what they take off the mean strength is what the data hold.
  const double missing = first.applied.values[0] * first.applied.values[2];
  std::printf("depth x width %.4f m, hidden %.4f m\n", missing, 0.22011 * 0.13768);
  EXPECT_NEAR(missing, 0.22011 * 0.13768, 0.5 * 0.22011 * 0.13768);
  for (std::size_t i = 1; i < d.claims.size(); ++i) EXPECT_LT(d.claims[i].probability, 0.5) << d.claims[i].id;
}

}  // namespace
}  // namespace apc::learning
