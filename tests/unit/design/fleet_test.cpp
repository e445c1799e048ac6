#include "apc/design/fleet.h"

#include <gtest/gtest.h>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc::design {
namespace {

const std::string good = R"({ "schema": "apc-fleet/1", "name": "n", "source": "s",
  "aircraft": [ { "aircraft": "CRJ-200", "cases": [ { "name": "heavy", "speed": "70 kt", "braking": 0.25 } ] } ],
  "floor_speed": "40 kt",
  "limits": { "criterion": "limit", "loads": ["nose drag"], "deceleration": "1.5 g" },
  "bed": { "material": "foam_50psi", "setback": "50 ft", "width": "150 ft",
           "depth": { "minimum": "4 in", "maximum": "24 in" }, "ramp": { "minimum": "20 ft", "maximum": "50 ft" },
           "maximum_length": "600 ft", "nodes": 4, "blocks": { "length": "4 ft", "width": "4 ft", "depth_step": "0.5 in" } } })";

std::string replaced(const std::string& from, const std::string& to) {
  auto text = good;
  text.replace(text.find(from), from.size(), to);
  return text;
}

/// The message a file is refused with; "" when it is taken.
std::string refusal(const std::string& text) {
  try {
    read_fleet(parse_json(text, "fleet.json"));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Fleet, ReadsCasesLimitsAndSpace) {
  const auto fleet = read_fleet(parse_json(good, "fleet.json"));
  ASSERT_EQ(fleet.cases.size(), 1u);
  EXPECT_NEAR(fleet.cases[0].overrun.entry_speed, 36.011, 1e-3);
  EXPECT_EQ(fleet.cases[0].overrun.braking, 0.25);
  EXPECT_NEAR(fleet.limits.deceleration, 14.709975, 1e-6);
  EXPECT_TRUE(counts(fleet.limits, "nose", "drag"));
  EXPECT_FALSE(counts(fleet.limits, "wing", "vertical"));
  EXPECT_NEAR(fleet.bed.maximum_depth, 0.6096, 1e-9);
}

TEST(Fleet, IsRefusedByPlaceAndReason) {
  const struct {
    std::string from, to, place, reason;
  } slips[] = {
      {R"("cases": [ { "name": "heavy", "speed": "70 kt", "braking": 0.25 } ])", R"("cases": [])", "/aircraft/0",
       "has no case"},
      {R"(, "cases": [ { "name": "heavy", "speed": "70 kt", "braking": 0.25 } ])", "", "/aircraft/0", "cases"},
      {R"("speed": "70 kt")", R"("speed": 70)", "/aircraft/0/cases/0", "unit"},
      {R"("braking": 0.25)", R"("braking": 25)", "/aircraft/0/cases/0/braking", "0 to 1"},
      {R"("floor_speed": "40 kt")", R"("floor_speed": "75 kt")", "/floor_speed", "contradicts"},
      {R"("minimum": "4 in", "maximum": "24 in")", R"("minimum": "24 in", "maximum": "4 in")", "/bed/depth/maximum",
       "contradict"},
      {R"("maximum_length": "600 ft")", R"("maximum_length": "15 ft")", "/bed/maximum_length", "contradict"},
      {R"("nodes": 4)", R"("nodes": 4, "maximum_slope": 0.001)", "/bed/maximum_slope", "contradicts"},
      {R"(["nose drag"])", R"(["nose lift"])", "/limits/loads", "known are"},
      {R"("source": "s",)", "", "fleet.json", "source"},
      {R"("nodes": 4)", R"("node": 4)", "/bed", "node"},
      {"apc-fleet/1", "apc-fleet/2", "/schema", "apc-fleet/2"},
  };
  for (const auto& slip : slips) {
    const auto message = refusal(replaced(slip.from, slip.to));
    EXPECT_NE(message.find(slip.place), std::string::npos) << slip.to << ": " << message;
    EXPECT_NE(message.find(slip.reason), std::string::npos) << slip.to << ": " << message;
  }
}

TEST(Fleet, ShippedOnesAreGood) {
  for (const auto& name : shipped_names("designs/fleets"))
    EXPECT_NO_THROW(load_fleet(shipped("designs/fleets") / (name + ".json"))) << name;
}

}  // namespace
}  // namespace apc::design
