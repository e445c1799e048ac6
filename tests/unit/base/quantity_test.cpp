#include "apc/base/quantity.h"

#include <gmock/gmock.h>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace u = units;

std::string refusal(const std::string& text, const Dimension& wanted) {
  try {
    parse_quantity(text, wanted);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Quantity, ConvertsByExactDefinitions) {
  EXPECT_DOUBLE_EQ(parse_quantity("70 kt", dimension::speed), 70 * 1852.0 / 3600.0);
  EXPECT_DOUBLE_EQ(parse_quantity("14.1 in", dimension::length), 14.1 * 0.0254);
  EXPECT_DOUBLE_EQ(parse_quantity("50 psi", dimension::pressure), 50 * 0.45359237 * 9.80665 / (0.0254 * 0.0254));
  EXPECT_DOUBLE_EQ(parse_quantity("44700 lbf", dimension::force), 44700 * 0.45359237 * 9.80665);
  EXPECT_DOUBLE_EQ(parse_quantity("15 degC", dimension::temperature), 288.15);
  EXPECT_NEAR(parse_quantity("59 degF", dimension::temperature), 288.15, 1e-10);
  EXPECT_DOUBLE_EQ(parse_quantity("0.5 g", dimension::acceleration), 0.5 * 9.80665);
}

TEST(Quantity, ReadsProductsQuotientsAndPowers) {
  EXPECT_DOUBLE_EQ(parse_quantity("3.0e6 kg m^2", dimension::inertia), 3.0e6);
  EXPECT_DOUBLE_EQ(parse_quantity("9.0e4 N s^2/m^2", dimension::square_damping), 9.0e4);
  EXPECT_DOUBLE_EQ(parse_quantity("320 kg/m^3", dimension::density), 320.0);
  EXPECT_DOUBLE_EQ(parse_quantity("78 MN/m", dimension::stiffness), 78e6);
  EXPECT_DOUBLE_EQ(parse_quantity("0.5 1/m", dimension::per_length), 0.5);
  // The density of the published foam deck: 3.75e-5 lbf s²/in⁴ is 401 kg/m³.
  EXPECT_NEAR(parse_quantity("3.75e-5 lbf-s^2/in^4", dimension::density), 400.8, 0.05);
}

TEST(Quantity, TakesSignsSpacesAndExponents) {
  EXPECT_DOUBLE_EQ(parse_quantity("-5 kt", dimension::speed), -5 * u::kt);  // whether that makes sense is the asker's
  EXPECT_DOUBLE_EQ(parse_quantity("  +1.5e1ft ", dimension::length), 15 * u::ft);
  EXPECT_DOUBLE_EQ(parse_quantity("0.25", dimension::none), 0.25);
}

struct BadQuantity {
  const char* text;
  Dimension wanted;
  const char* says;
};
class QuantityMistake : public ::testing::TestWithParam<BadQuantity> {};

TEST_P(QuantityMistake, IsRefusedWithWhatToWrite) {
  const auto& [text, wanted, says] = GetParam();
  EXPECT_THAT(refusal(text, wanted), HasSubstr(says));
}

INSTANTIATE_TEST_SUITE_P(Each, QuantityMistake,
                         ::testing::Values(BadQuantity{"70", dimension::speed, "has no unit"},
                                           BadQuantity{"70", dimension::speed, "70 kt"},  // the example to copy
                                           BadQuantity{"70 lbs", dimension::speed, "a mass, but a speed is needed"},
                                           BadQuantity{"70 knots", dimension::speed, "unknown unit \"knots\""},
                                           BadQuantity{"70 ktt", dimension::speed, "Did you mean \"kt\""},
                                           BadQuantity{"70 kg/m^3", dimension::speed, "density"},
                                           BadQuantity{"fast", dimension::speed, "does not start with a number"},
                                           BadQuantity{"", dimension::speed, "does not start with a number"},
                                           BadQuantity{"kt", dimension::speed, "does not start with a number"},
                                           BadQuantity{"nan kt", dimension::speed, "not a finite number"},
                                           BadQuantity{"inf kt", dimension::speed, "not a finite number"},
                                           BadQuantity{"70 m^/s", dimension::speed, "power"},
                                           BadQuantity{"70 %", dimension::speed, "%"},
                                           BadQuantity{"18 in", dimension::pressure, "a pressure is needed"}));

TEST(Quantity, OverflowIsNoNumber) { EXPECT_NE(refusal("1e999 kt", dimension::speed), "accepted"); }

TEST(Units, AreRefusedWithTheNearestOne) {
  EXPECT_THROW(parse_unit(""), InputError);
  EXPECT_THROW(parse_unit("furlong"), InputError);
  EXPECT_EQ(parse_unit("kN/in").dimension, dimension::stiffness);
  EXPECT_DOUBLE_EQ(parse_unit("km/h").factor, 1.0 / 3.6);
}

TEST(Units, NearestIsWithinReach) {
  const std::string words[] = {"setback", "width", "material"};
  EXPECT_EQ(nearest("setbak", words, 3), "setback");
  EXPECT_EQ(nearest("xylophone", words, 3), "");
}

}  // namespace
}  // namespace apc
