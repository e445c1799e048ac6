#include "apc/base/csv.h"

#include <gmock/gmock.h>

#include <cmath>

#include "apc/base/require.h"

namespace apc {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    parse_csv(text, "run.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Csv, ReadsRemarksHeaderAndNumbers) {
  const auto table =
      parse_csv("# schema: x/1\n# source: a: b\ntime [s], speed [kt] ,note\n0, 70,1\n0.5,+6.9e1,\n", "f");
  EXPECT_EQ(table.remarks.at("schema"), "x/1");
  EXPECT_EQ(table.remarks.at("source"), "a: b");
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.columns[1].name, "speed");
  EXPECT_EQ(table.columns[1].unit, "kt");
  EXPECT_DOUBLE_EQ(table.column("speed", dimension::speed)[0], 70 * 1852.0 / 3600.0);
  EXPECT_TRUE(std::isnan(table.columns[2].values[1]));  // an empty cell is no sample
}

TEST(Csv, TakesWindowsLineEndsQuotesAndALastLineWithoutEnd) {
  const auto table = parse_csv("\"a [m]\",b\r\n1,2\r\n3,nan", "f");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.columns[0].unit, "m");
  EXPECT_EQ(table.columns[0].values[1], 3.0);
}

TEST(Csv, ColumnsAreAskedForByDimension) {
  const auto table = parse_csv("speed [kt],load [stone]\n1,2\n", "run.csv");
  EXPECT_THROW(table.column("speed", dimension::length), InputError);
  EXPECT_THROW(table.column("load", dimension::force), InputError);
  EXPECT_EQ(table.find("drag"), nullptr);
  try {
    table.column("sped", dimension::speed);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("speed"));
  }
}

TEST(Csv, MistakesNameTheirLine) {
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("# only: remarks\n"), HasSubstr("empty"));
  EXPECT_THAT(refusal("1,2\n3,4\n"), HasSubstr("header"));
  EXPECT_THAT(refusal("a,b\n1,2\n3\n"), HasSubstr("run.csv line 3"));
  EXPECT_THAT(refusal("a,b\n1,two\n"), HasSubstr("\"two\" is not a number"));
  EXPECT_THAT(refusal("a,b\n1,2x\n"), HasSubstr("2x"));
}

TEST(Csv, WhatIsWrittenCanBeRead) {
  const auto text = csv_text({{"schema", "x/1"}}, {{"speed", "m/s", {1.5, std::nan("")}}, {"n", "", {1, 2}}});
  const auto back = parse_csv(text, "f");
  EXPECT_EQ(back.remarks.at("schema"), "x/1");
  EXPECT_DOUBLE_EQ(back.columns[0].values[0], 1.5);
  EXPECT_TRUE(std::isnan(back.columns[0].values[1]));
  EXPECT_EQ(back.columns[0].unit, "m/s");
}

}  // namespace
}  // namespace apc
