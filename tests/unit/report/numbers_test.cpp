#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "apc/base/units.h"
#include "apc/report/sha256.h"
#include "apc/report/svg.h"
#include "apc/report/unit_system.h"

namespace apc::report {
namespace {

TEST(ReportNumber, SeparatesThousandsAndRounds) {
  EXPECT_EQ(number(1234567.89, 1), "1,234,567.9");
  EXPECT_EQ(number(-1234.0, 0), "-1,234");
  EXPECT_EQ(number(999.4, 0), "999");
  EXPECT_EQ(number(0.0, 2), "0.00");
}

TEST(ReportNumber, NeverShowsMinusZeroOrNotANumber) {
  EXPECT_EQ(number(-1e-9, 1), "0.0");
  EXPECT_EQ(number(std::nan(""), 1), "-");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity(), 1), "-");
}

TEST(ReportNumber, ShowsQuantitiesInEitherSystem) {
  EXPECT_EQ(shown(70 * units::kt, measure::speed, UnitSystem::field), "70.0 kt");
  EXPECT_EQ(shown(70 * units::kt, measure::speed, UnitSystem::si), "36.01 m/s");
  EXPECT_EQ(shown(18 * units::in, measure::depth, UnitSystem::field), "18.0 in");
  EXPECT_EQ(shown(0.5 * units::g0, measure::acceleration, UnitSystem::field), "0.500 g");
}

TEST(ReportHash, AgreesWithThePublishedExamples) {
  // FIPS 180-4 examples.
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(ReportTicks, AreRoundInTheUnitShownAndInsideTheRange) {
  const auto found = ticks(0.0, 100 * units::ft, measure::distance.field, 5);
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[1].label, "20");
  EXPECT_NEAR(found[1].value, 20 * units::ft, 1e-12);
  EXPECT_EQ(found.back().label, "100");
}

TEST(ReportTicks, HaveEnoughDigitsForSmallSteps) {
  const auto found = ticks(0.0, 0.08, {"m", 1.0, 2}, 4);
  ASSERT_GE(found.size(), 4u);
  EXPECT_EQ(found[1].label, "0.02");
}

TEST(ReportTicks, AreNoneForAnEmptyRange) { EXPECT_TRUE(ticks(1.0, 1.0, measure::distance.si, 5).empty()); }

TEST(ReportSvg, PathBreaksWhereThereIsNoValue) {
  const Axis axis{0.0, 10.0, 0.0, 10.0};
  EXPECT_EQ(path({0, 1, 2, 3}, {0, 1, std::nan(""), 3}, axis, axis), "M0,0L1,1M3,3");
}

TEST(ReportSvg, EscapesWhatHtmlWouldRead) { EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;"); }

}  // namespace
}  // namespace apc::report
