#include "apc/effects/formula.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/effects/effect_json.h"

namespace apc::effects {
namespace {

const std::vector<FormulaName> names = {
    {"v", dimension::speed}, {"p", dimension::length}, {"k", dimension::pressure}, {"n", dimension::none}};
const double values[] = {3.0, 2.0, 5.0, 1.5};

TEST(Formula, ComputesWithTheUsualPrecedence) {
  EXPECT_DOUBLE_EQ(Formula("1 + 2*3^2 - 4/8", {}, dimension::none)(nullptr), 18.5);
  EXPECT_DOUBLE_EQ(Formula("k*p^2*n", names, dimension::force)(values), 30.0);
  EXPECT_DOUBLE_EQ(Formula("-exp(-p/p)", names, dimension::none)(values), -std::exp(-1.0));
  EXPECT_DOUBLE_EQ(Formula("max(n, 2)^n", names, dimension::none)(values), std::pow(2.0, 1.5));
}

TEST(Formula, NamesTheTermWhoseUnitDoesNotFit) {
  try {
    Formula("k*p^2 + v", names, dimension::force);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"v\" (m s^-1)"), std::string::npos) << error.what();
  }
  EXPECT_THROW(Formula("k*p", names, dimension::force), InputError);
  EXPECT_THROW(Formula("exp(v)", names, dimension::none), InputError);
  EXPECT_THROW(Formula("v^n", names, dimension::speed), InputError);
  EXPECT_THROW(Formula("k*(p", names, dimension::force), InputError);
  EXPECT_THROW(Formula("q + 1", names, dimension::none), InputError);
}

TEST(Formula, OwnEffectActsLikeAShippedOne) {
  const Effect own = read_own_effect(
      parse_json(R"({"schema": "apc-effect/1", "id": "crumbling", "source": "a guess", "acts_on": "drag",
    "formula": "k*b*p*(v/v0)^n", "parameters": {"k": {"unit": "kPa", "low": 0, "high": 40},
    "v0": {"unit": "kt", "low": 1, "high": 60, "usual": 36}, "n": {"low": 0, "high": 3, "usual": 2}}})",
                 "own.json"));
  TireState state;
  state.speed = 10.0, state.penetration = 0.2, state.tire_width = 0.5, state.bed_depth = 0.4;
  TireChange change;
  own.force(state, applied(own, 2e4).values, change);
  const double v0 = 36.0 * 1852.0 / 3600.0;
  EXPECT_NEAR(change.drag, 2e4 * 0.5 * 0.2 * std::pow(10.0 / v0, 2.0), 1e-9);
}

TEST(Formula, OwnEffectWithWrongUnitsIsRefusedByItsPlace) {
  try {
    read_own_effect(
        parse_json(R"({"schema": "apc-effect/1", "id": "x", "source": "s", "acts_on": "drag", "formula": "k*v",
      "parameters": {"k": {"unit": "N", "low": 0, "high": 1}}})",
                   "own.json"));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("own.json"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("formula"), std::string::npos);
  }
}

}  // namespace
}  // namespace apc::effects
