#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "apc/report/page.h"
#include "tests/unit/report/synthetic_record.h"

namespace apc::report {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(Page, NeedsNoNetwork) {
  const auto html = page(synthetic::record());
  for (const char* word : {"http:", "https:", "src=", "@import", "url(//", "<link rel=\"stylesheet"})
    EXPECT_EQ(html.find(word), std::string::npos) << word;
}

TEST(Page, ShowsEveryPlotOverDistanceAndTime) {
  const auto html = page(synthetic::record());
  for (const char* title :
       {"Speed", "Deceleration", "Drag per nose strut", "Drag per main strut", "Vertical load per strut",
        "Strut stroke", "Penetration, rut dashed", "Pitch, nose up", "Energy"})
    EXPECT_NE(html.find(std::string("<b>") + title + "</b>"), std::string::npos) << title;
  EXPECT_EQ(count(html, "<svg class=\"chart\""), 9u);
  EXPECT_EQ(count(html, "<g class=\"by-distance\">"), 9u);
  EXPECT_EQ(count(html, "<g class=\"by-time\">"), 9u);
  EXPECT_EQ(count(html, "<svg class=\"section\""), 1u);
  EXPECT_EQ(count(html, "<svg class=\"rest\""), 2u);
}

TEST(Page, HoldsOnlyFiniteNumbers) {
  auto record = synthetic::record();
  record.result.stop_distance = std::nan("");
  record.result.history.pitch[50] = std::nan("");
  const auto html = page(record);
  EXPECT_FALSE(std::regex_search(html, std::regex("[^a-zA-Z](nan|inf|NaN|Infinity)[^a-zA-Z]")));
}

TEST(Page, ReadsBackItsOwnSeries) {
  const auto record = synthetic::record();
  const auto html = page(record);
  const std::string opening = "<script type=\"application/json\" id=\"series\">";
  const auto begin = html.find(opening) + opening.size();
  const auto json = nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  ASSERT_EQ(json.at("plots").size(), 9u);
  const auto rows = json.at("distance").size();
  EXPECT_GT(rows, 300u);
  for (const auto& plot : json.at("plots"))
    for (const auto& curve : plot) EXPECT_EQ(curve.at("values").size(), rows);
  EXPECT_NEAR(json.at("plots")[0][0].at("values")[0].get<double>(), 36.011, 1e-3);
}

TEST(Page, EscapesNamesFromFiles) {
  const auto html = page(synthetic::record());
  EXPECT_EQ(html.find("<test>"), std::string::npos);
  EXPECT_NE(html.find("18 in, 400 ft &lt;test&gt;"), std::string::npos);
}

TEST(Page, NamesTheRuleOfTheWorstMargin) {
  const auto html = page(synthetic::record());
  const auto card = html.find("Worst margin");
  ASSERT_NE(card, std::string::npos);
  EXPECT_NE(html.substr(card, 600).find("14 CFR 25.509"), std::string::npos);
}

TEST(Page, StandsWithoutHistories) {
  auto record = synthetic::record();
  record.result.history = {};
  EXPECT_NE(page(record).find("Gear loads and margins"), std::string::npos);
}

}  // namespace
}  // namespace apc::report
