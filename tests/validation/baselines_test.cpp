// Weak baselines: what a diagnosis must beat. And their answers to a folder of cases, to be scored like any other:
//   APC_CASES=… APC_BASELINES=out validation_tests --gtest_filter=Baselines.WriteAnswers
//   APC_CASES=… APC_ANSWERS=out/white_noise_bic validation_tests --gtest_filter=Score.TableOfAnswers
#include "baselines.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/diagnosis_json.h"
#include "tests/support/surveyed_runs.h"

namespace scoring {
namespace {

using namespace apc;
using namespace apc::learning;

constexpr Baseline all[] = {Baseline::always_nothing, Baseline::always_inertial, Baseline::white_noise_bic,
                            Baseline::sparse_regression};

apc::testing::SurveyedRuns scattered(unsigned seed) {
  apc::testing::SurveyedRuns wanted;
  wanted.seed = seed, wanted.block_strength = 0.08, wanted.correlation = 3.0, wanted.table_error = 0.02;
  return wanted;
}

TEST(Baselines, WhiteNoiseRaisesTheAlarmWhereNothingIsHidden) {
  // Were this not so, the sets of own_nulls_test.cpp would prove nothing.
  int alarms = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
    alarms += answer_of(Baseline::white_noise_bic, apc::testing::surveyed_case(scattered(seed))).diagnosis.verdict ==
              Verdict::found;
  std::printf("white-noise BIC claims an effect in %d of 6 sets without one\n", alarms);
  EXPECT_GE(alarms, 3);
}

TEST(Baselines, WithoutScatterWhiteNoiseFindsWhatIsHidden) {
  auto wanted = scattered(3);
  wanted.block_strength = 1e-4, wanted.table_error = 0.0;
  wanted.hidden = {effects::applied(effects::find_effect(effects::catalogue(), "inertial"), 0.5)};
  const Study study = answer_of(Baseline::white_noise_bic, apc::testing::surveyed_case(wanted));
  ASSERT_FALSE(study.diagnosis.claims.empty());
  EXPECT_EQ(study.diagnosis.claims.front().id, "inertial");
}

TEST(Baselines, WriteAnswers) {
  const char *cases = std::getenv("APC_CASES"), *out = std::getenv("APC_BASELINES");
  if (!cases || !out) GTEST_SKIP() << "set APC_CASES and APC_BASELINES to write the baselines' answers";
  for (const auto& folder : std::filesystem::directory_iterator(cases)) {
    if (!std::filesystem::exists(folder.path() / "case.json")) continue;
    try {
      const Case data = load_case(folder.path());
      for (const Baseline baseline : all) {
        const Study study = answer_of(baseline, data);
        const auto answer = std::filesystem::path(out) / name_of(baseline) / folder.path().filename();
        write_text(answer / "diagnosis.json", diagnosis_json(study));
        write_predictions(study, answer / "held");
      }
    } catch (const std::exception& failure) {
      std::printf("%s: %s\n", folder.path().filename().c_str(), failure.what());
    }
  }
}

}  // namespace
}  // namespace scoring
