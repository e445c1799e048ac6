#include "apc/learning/learn_page.h"

#include <gtest/gtest.h>

namespace apc::learning {
namespace {

/// What a user may write into the files of a case: harmless in a title, markup in a page.
const std::string hostile = "<b>&\"'";
const std::string shown = "&lt;b&gt;&amp;&quot;&#39;";

TEST(LearnPage, ShowsWhatUsersWroteAndReadsNoneOfItAsMarkup) {
  Case data;
  data.title = "title " + hostile;
  data.remarks.push_back({"remark run " + hostile, "remark channel " + hostile, "remark text " + hostile});
  Study study;
  auto& background = study.background;
  background.data = &data;
  background.training = 1;
  background.runs.resize(1);
  background.runs[0].id = "run " + hostile;
  background.layout.runs.resize(1);
  auto& diagnosis = study.diagnosis;
  diagnosis.learned = "learned " + hostile;
  Explanation explanation;
  explanation.label = "label " + hostile;
  explanation.ids = {"id " + hostile};
  diagnosis.explanations.push_back(explanation);
  Claim claim;
  claim.id = claim.applied.effect.id = "claim " + hostile;
  claim.applied.values = {1.0};
  claim.applied.effect.law = "law " + hostile;
  diagnosis.claims.push_back(claim);
  diagnosis.rivals.push_back({"rival a " + hostile, "rival b " + hostile, 0.5, 1.0});
  diagnosis.smallest_detectable["detectable " + hostile] = 1.0;

  const auto page = learn_page(study);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  for (const auto* what : {"title ", "remark run ", "remark channel ", "remark text ", "run ", "learned ", "label ",
                           "id ", "claim ", "law ", "rival a ", "rival b ", "detectable "})
    EXPECT_NE(page.find(what + shown), std::string::npos) << what;
  EXPECT_NE(page.find("<title>title " + shown + "</title>"), std::string::npos);
}

}  // namespace
}  // namespace apc::learning
