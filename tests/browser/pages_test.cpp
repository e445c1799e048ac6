/// Every kind of page the program makes, as a reader meets it: phone, desk and paper, light and dark.
#include "tests/browser/browser.h"

namespace apc::browser {
namespace {

using scenarios::Folder, scenarios::run;

std::string joined(const std::vector<std::string>& list) {
  std::string out;
  for (const auto& each : list) out += "\n  " + each;
  return out;
}

void expect_good(const Look& look, const std::string& dress, bool dark, int pictures) {
  ASSERT_EQ(look.views.size(), 3u) << dress;
  EXPECT_TRUE(look.complaints.empty()) << dress << joined(look.complaints);
  for (const auto& view : look.views) {
    const auto what = dress + ", " + view.name + ": ";
    EXPECT_LE(view.overflow, 0.0) << what << "wider than the window";
    EXPECT_TRUE(view.flat.empty()) << what << "without size" << joined(view.flat);
    EXPECT_TRUE(view.hidden.empty()) << what << "not shown" << joined(view.hidden);
    EXPECT_TRUE(view.cut.empty()) << what << "cut off" << joined(view.cut);
    EXPECT_TRUE(view.overlaps.empty()) << what << "words on words" << joined(view.overlaps);
    EXPECT_GE(view.pictures, pictures) << what;
    EXPECT_GE(view.contrast, 7.0) << what;
    if (dark && view.name != "paper")
      EXPECT_LT(view.brightness, 0.1) << what;
    else
      EXPECT_GT(view.brightness, 0.8) << what;
  }
}

void expect_good_page(const Folder& folder, const std::string& page, int pictures) {
  for (const bool dark : {false, true})
    expect_good(look(folder, page, dark), page + (dark ? ", dark" : ", light"), dark, pictures);
}

#define NEEDS_CHROMIUM    \
  if (chromium().empty()) \
  GTEST_SKIP() << "Chromium is not installed (Debian's package \"chromium\"): no page was looked at"

void make(const Folder& folder, const std::vector<std::string>& words) {
  const auto said = run(folder, words);
  ASSERT_TRUE(said.exit_code == 0 || said.exit_code == 1) << said.err;
}

TEST(Page, OfAnOverrun) {
  NEEDS_CHROMIUM;
  const Folder folder;
  make(folder, {"simulate", "--aircraft", "B737-800", "--bed", "emas_18in_50psi", "--speed", "70 kt", "--braking",
                "0.25", "-o", "o", "--quiet"});
  expect_good_page(folder, "o/report.html", 5);
}

TEST(Page, OfAStudy) {
  NEEDS_CHROMIUM;
  const Folder folder;
  make(folder, {"study", "--aircraft", "CRJ-200,B737-800", "--bed", "emas_18in_50psi", "--speeds", "40:70:10",
                "--masses", "0.8,1", "--tornado", "--envelope", "--quiet", "-o", "o"});
  expect_good_page(folder, "o/study.html", 3);
}

TEST(Page, OfADesignItsReliabilityAndItsReport) {
  NEEDS_CHROMIUM;
  const Folder folder;
  make(folder, {"design", "--fleet", "acrp29_crj_200", "-o", "d", "--quiet"});
  expect_good_page(folder, "d/design.html", 1);
  make(folder, {"reliability", "--design", "d/design.json", "--samples", "200", "-o", "r", "--quiet"});
  expect_good_page(folder, "r/reliability.html", 1);
  make(folder, {"report", "--design", "d/design.json", "--site", "example_runway_end", "-o", "c", "--quiet"});
  expect_good_page(folder, "c/report.html", 3);
}

TEST(Page, OfAParticleRun) {
  NEEDS_CHROMIUM;
  const Folder folder;
  folder.write("deck.json", R"({
  "schema": "apc-sph/1", "name": "a short run", "source": "made for a test", "tire": "R18x4.4", "material": "foam_50psi",
  "speed": "40 kt", "bed_depth": "9 in", "penetration": "4 in", "spacing": "1.0 in" })");
  make(folder, {"sph", "run", "deck.json", "-o", "o", "--quiet"});
  expect_good_page(folder, "o/report.html", 2);
}

TEST(Page, OfALearningLoop) {
  NEEDS_CHROMIUM;
  const Folder folder;
  const auto said =
      run(folder, {"learn", std::string(PROJECT_DIR) + "/tests/validation/cases/joints", "-o", "o", "--quiet"});
  ASSERT_NE(said.exit_code, 2) << said.err;
  expect_good_page(folder, "o/report.html", 3);
}

TEST(Page, OfANextRun) {
  NEEDS_CHROMIUM;
  const Folder folder;
  make(folder, {"next", std::string(PROJECT_DIR) + "/tests/validation/cases/joints", "--rivals",
                "inertial,slope+debris,nothing", "--speeds", "30:60:10 kt", "--masses", "17:21:2 t", "-o", "next.html",
                "--quiet"});
  expect_good_page(folder, "next.html", 1);
}

/// The test itself: a page with every fault is found at fault.
TEST(Look, SeesWhatIsWrong) {
  NEEDS_CHROMIUM;
  const Folder folder;
  folder.write("bad.html",
               R"(<!doctype html><style>body{background:#eee;color:#ccc}@media print{h2{display:none}}</style>
<h2>title</h2><div style="width:1600px">wide</div><table style="width:1500px"><tr><td>x</td></tr></table>
<svg role="img" aria-label="flat" width="0" height="0"></svg>
<svg role="img" aria-label="words" width="100" height="100"><text x="5" y="50">one</text><text x="6" y="50">two</text></svg>
<script>null.x</script>)");
  const auto seen = look(folder, "bad.html", false);
  ASSERT_EQ(seen.views.size(), 3u);
  EXPECT_FALSE(seen.complaints.empty());
  for (const auto& view : seen.views) {
    EXPECT_GT(view.overflow, 100.0);
    EXPECT_EQ(view.flat.size(), 1u);
    EXPECT_EQ(view.hidden.size(), view.name == "paper" ? 1u : 0u);
    EXPECT_EQ(view.overlaps.size(), 1u);
    EXPECT_FALSE(view.cut.empty());
    EXPECT_LT(view.contrast, 2.0);
  }
}

}  // namespace
}  // namespace apc::browser
