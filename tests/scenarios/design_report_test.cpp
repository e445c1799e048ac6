/// A bed is designed, driven through, and judged: the report must not pass what the overrun shows to be overloaded.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

const nlohmann::json& requirement(const nlohmann::json& report, const std::string& beginning) {
  for (const auto& each : report.at("requirements"))
    if (each.at("clause").get<std::string>().starts_with(beginning)) return each;
  throw std::runtime_error("no requirement begins with " + beginning);
}

TEST(DesignReport, CountsEveryKnownGearLimitWhateverTheDesignCounted) {
  const Folder folder;
  const auto made = run(folder, {"design", "--fleet", "acrp29_crj_200", "-o", "d"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("counted        nose drag only"), std::string::npos) << made.out;
  const auto judged = run(folder, {"report", "--design", "d/design.json", "-o", "r"});
  const auto report = nlohmann::json::parse(text_of(folder.path() / "r/report.json"));

  const auto driven = run(folder, {"simulate", "--aircraft", "CRJ-200", "--mass", "53000 lb", "--bed", "d/bed.json",
                                   "--speed", "70 kt", "--braking", "0.25", "--json", "s.json", "-o", "s"});
  ASSERT_EQ(driven.exit_code, 0) << driven.err;
  const auto run70 = nlohmann::json::parse(text_of(folder.path() / "s.json"));
  double worst = 1.0;
  for (const auto& [name, gear] : run70.at("gears").items())
    for (const char* margin : {"drag_margin", "vertical_margin"})
      if (gear.at(margin).is_number()) worst = std::min(worst, gear.at(margin).get<double>());
  // The clause at 70 kt is recalled, so it never passes; whether it would be met must agree with the overrun.
  const auto at70 = requirement(report, "At 70 kt no load beyond");
  EXPECT_EQ(at70.at("result"), "not verified");
  EXPECT_NEAR(report.at("cases").at(0).at("use").get<double>(), 1.0 / (1.0 + worst), 0.01);
  EXPECT_EQ(report.at("cases").at(0).at("intact_speed").get<double>() >= 36.0, worst >= 0.0);
  EXPECT_EQ(judged.exit_code == 1, std::any_of(report.at("requirements").begin(), report.at("requirements").end(),
                                               [](const auto& each) { return each.at("result") == "fail"; }));
}

}  // namespace
}  // namespace apc::scenarios
