#include "apc/base/json.h"

#include <gmock/gmock.h>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

Json parse(const std::string& text) { return parse_json(text, "bed.json"); }

TEST(JsonFile, AnswersByNameAndDimension) {
  const auto json = parse(R"({"schema": "s/1", "speed": "10 m/s", "list": {"unit": "cm", "values": [1, 2]},
    "other": ["1 m", "2 ft"], "n": 3, "x": 0.5, "on": true, "words": ["a", "b"], "inner": {"k": "v"}})");
  json.schema("s/1");
  EXPECT_DOUBLE_EQ(json.quantity("speed", dimension::speed), 10.0);
  EXPECT_DOUBLE_EQ(json.quantity("absent", dimension::speed, 4.0), 4.0);
  EXPECT_THAT(json.quantities("list", dimension::length), ElementsAre(0.01, 0.02));
  EXPECT_THAT(json.quantities("other", dimension::length), ElementsAre(1.0, 2 * units::ft));
  EXPECT_EQ(json.integer("n"), 3);
  EXPECT_EQ(json.number("x"), 0.5);
  EXPECT_TRUE(json.flag("on", false));
  EXPECT_THAT(json.texts("words"), ElementsAre("a", "b"));
  EXPECT_EQ(json.object("inner").text("k"), "v");
  EXPECT_NO_THROW(json.finish());
}

TEST(JsonFile, KeysNobodyAskedForAreRefusedAtAnyDepth) {
  const auto json = parse(R"({"a": 1, "inner": {"k": 1, "kk": 2}})");
  json.number("a");
  const auto inner = json.object("inner");
  inner.number("k");
  EXPECT_THAT(refusal([&] { json.finish(); }), AllOf(HasSubstr("bed.json /inner/kk"), HasSubstr("unknown key")));
  inner.ignore("kk");
  EXPECT_EQ(refusal([&] { json.finish(); }), "accepted");
}

TEST(JsonFile, MissingAndMisspeltKeysNameTheNearestOne) {
  const auto json = parse(R"({"setbak": "50 ft"})");
  EXPECT_THAT(refusal([&] { json.quantity("setback", dimension::length); }),
              AllOf(HasSubstr("bed.json /setback"), HasSubstr("is missing"), HasSubstr("setbak")));
}

TEST(JsonFile, BareNumbersAreRefusedWhereAUnitIsNeeded) {
  const auto json = parse(R"({"depth": 24, "list": [0, 18], "width": "24"})");
  EXPECT_THAT(refusal([&] { json.quantity("depth", dimension::length); }),
              AllOf(HasSubstr("/depth: 24 has no unit"), HasSubstr("\"24 in\"")));
  EXPECT_THAT(refusal([&] { json.quantities("list", dimension::length); }), HasSubstr("/list/0"));
  EXPECT_THAT(refusal([&] { json.quantity("width", dimension::length); }), HasSubstr("has no unit"));
}

TEST(JsonFile, WrongTypesAreNamedWithTheirValue) {
  const auto json = parse(R"({"a": "x", "b": [1], "c": {"unit": "s", "values": [1]}, "d": {"unit": "in", "values": 3},
    "e": 1.5, "f": "", "g": [1, "x"], "h": [1, 2]})");
  EXPECT_THAT(refusal([&] { json.number("a"); }), HasSubstr("/a: \"x\" is not a number"));
  EXPECT_THAT(refusal([&] { json.text("b"); }), HasSubstr("not a text"));
  EXPECT_THAT(refusal([&] { json.object("b"); }), HasSubstr("not an object"));
  EXPECT_THAT(refusal([&] { json.quantities("c", dimension::length); }), HasSubstr("a length is needed"));
  EXPECT_THAT(refusal([&] { json.quantities("d", dimension::length); }), HasSubstr("/d/values"));
  EXPECT_THAT(refusal([&] { json.integer("e"); }), HasSubstr("whole number"));
  EXPECT_THAT(refusal([&] { json.text("f"); }), HasSubstr("is empty"));
  EXPECT_THAT(refusal([&] { json.numbers("g"); }), HasSubstr("/g/1"));
  EXPECT_THAT(refusal([&] { json.objects("h"); }), HasSubstr("/h/0"));
  EXPECT_THAT(refusal([&] { json.flag("e", true); }), HasSubstr("true nor false"));
  EXPECT_THAT(refusal([&] { json.quantity("h", dimension::length); }), HasSubstr("not a quantity"));
}

TEST(JsonFile, OtherSchemasAreRefused) {
  EXPECT_THAT(refusal([&] { parse(R"({"schema": "apc-bed/2"})").schema("apc-bed/1"); }),
              AllOf(HasSubstr("apc-bed/2"), HasSubstr("apc-bed/1")));
}

TEST(JsonFile, WhatIsNoJsonObjectIsSaidSo) {
  EXPECT_THAT(refusal([] { parse(""); }), HasSubstr("is empty"));
  EXPECT_THAT(refusal([] { parse("  \n"); }), HasSubstr("is empty"));
  EXPECT_THAT(refusal([] { parse("depth: 3"); }), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal([] { parse("{\"a\": NaN}"); }), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal([] { parse("{\"a\": 1"); }), HasSubstr("line 1"));
  EXPECT_THAT(refusal([] { parse("[1]"); }), HasSubstr("not an object"));
  EXPECT_THAT(refusal([] { read_json("/no/such/file.json"); }), HasSubstr("no such file"));
}

}  // namespace
}  // namespace apc
