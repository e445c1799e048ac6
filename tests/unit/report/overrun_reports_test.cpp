#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apc/base/csv.h"
#include "apc/base/hdf5.h"
#include "apc/report/brief.h"
#include "apc/report/history_table.h"
#include "apc/report/result_json.h"
#include "tests/unit/report/synthetic_record.h"

namespace apc::report {
namespace {

TEST(WorstMargin, IsTheSmallestOfAllGearsAndLoads) {
  auto record = synthetic::record();
  const auto worst = worst_margin(record.result);
  EXPECT_EQ(worst.gear, "nose");
  EXPECT_EQ(worst.load, "drag");
  EXPECT_NEAR(worst.margin, 116.6 / 108.0 - 1.0, 1e-12);
  record.result.gears[1].vertical_margin = -0.2;
  EXPECT_EQ(worst_margin(record.result).gear, "main");
  EXPECT_EQ(worst_margin(record.result).load, "vertical");
}

TEST(WorstMargin, IsUnnamedWithoutAnyLimit) {
  auto record = synthetic::record();
  for (auto& gear : record.result.gears) gear.drag_limit = gear.vertical_limit = 0.0;
  EXPECT_EQ(worst_margin(record.result).gear, "");
}

TEST(ThinnedRows, KeepEndsAndPeaks) {
  const auto record = synthetic::record();
  const auto& history = record.result.history;
  const auto rows = thinned_rows(history, 100);
  EXPECT_LT(rows.size(), 160u);
  EXPECT_GT(rows.size(), 60u);
  EXPECT_EQ(rows.front(), 0u);
  EXPECT_EQ(rows.back(), history.time.size() - 1);
  double kept = 0.0;
  for (const auto row : rows) kept = std::max(kept, history.gears[0].drag[row]);
  EXPECT_EQ(kept, *std::max_element(history.gears[0].drag.begin(), history.gears[0].drag.end()));
}

TEST(BriefReport, BeginsWithTheWarnings) {
  const auto text = brief(synthetic::record(), UnitSystem::field);
  EXPECT_TRUE(text.starts_with("warning: nose: 7.0 %")) << text.substr(0, 80);
  EXPECT_NE(text.find("14 CFR 25.509"), std::string::npos);
  EXPECT_NE(text.find("24,279 lbf"), std::string::npos);
}

TEST(BriefReport, SpeaksSiWhenAsked) {
  const auto text = brief(synthetic::record(), UnitSystem::si);
  EXPECT_NE(text.find("108.0 kN"), std::string::npos);
  EXPECT_EQ(text.find("lbf"), std::string::npos);
}

TEST(ResultJson, HoldsTheKeysOtherProgramsRelyOn) {
  const auto record = synthetic::record();
  const auto json = nlohmann::json::parse(result_json(record));
  EXPECT_EQ(json.at("outcome"), "stopped");
  EXPECT_NEAR(json.at("stop_distance").get<double>(), record.result.stop_distance, 1e-12);
  EXPECT_NEAR(json.at("runway_distance").get<double>(), record.result.stop_distance + 15.24, 1e-9);
  for (const char* key : {"exit_speed", "peak_deceleration", "mean_deceleration"})
    EXPECT_TRUE(json.at(key).is_number()) << key;
  for (const char* key : {"peak_drag", "peak_vertical", "drag_margin"})
    EXPECT_TRUE(json.at("gears").at("nose").at(key).is_number()) << key;
  EXPECT_TRUE(json.at("energy").at("residual").is_number());
  EXPECT_DOUBLE_EQ(json.at("table_coverage").at("N27").get<double>(), 0.93);
  for (const char* key : {"steps", "rhs_calls", "wall_s"}) EXPECT_TRUE(json.at("solver").at(key).is_number()) << key;
  EXPECT_EQ(json.at("provenance").at("files").size(), 2u);
}

TEST(ResultJson, WritesNullForAStopThatNeverCame) {
  auto record = synthetic::record();
  record.result.stop_distance = std::nan("");
  EXPECT_TRUE(nlohmann::json::parse(result_json(record)).at("stop_distance").is_null());
}

TEST(HistoryCsv, ReadsBackWithUnitsAndInputs) {
  const auto record = synthetic::record();
  const auto table = parse_csv(history_csv(record), "history.csv");
  const auto speed = table.column("speed", dimension::speed);
  ASSERT_EQ(speed.size(), record.result.history.time.size());
  EXPECT_NEAR(speed.front(), 36.011, 1e-5);
  EXPECT_NEAR(table.column("main_drag", dimension::force).at(400), record.result.history.gears[1].drag.at(400), 1.0);
  EXPECT_EQ(table.remarks.at("aircraft"), "Testjet-200");
}

TEST(HistoryHdf5, CarriesUnitsAndProvenance) {
  const auto record = synthetic::record();
  const auto path = std::filesystem::temp_directory_path() / "apc_history_test" / "history.h5";
  save_history(record, path);
  {
    const Hdf5Reader reader(path);
    EXPECT_EQ(reader.array("history/nose_rut").values, record.result.history.gears[0].rut);
    EXPECT_EQ(reader.text("history/nose_rut", "unit"), "m");
    EXPECT_EQ(reader.text("/", "command"), record.manifest.command);
  }
  std::filesystem::remove_all(path.parent_path());
}

}  // namespace
}  // namespace apc::report
