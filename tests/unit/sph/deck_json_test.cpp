#include "sph_backend/deck_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "apc/base/require.h"
#include "cases.h"
#include "sph_backend/material_json.h"

namespace apc::sph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Keys = std::vector<std::pair<std::string, std::string>>;

const DeckNames names{[](const std::string&) { return testing::main_tire(); },
                      [](const std::string&) -> std::filesystem::path {
                        return std::string(PROJECT_DIR) + "/designs/materials/foam_50psi.json";
                      }};

/// A JSON object of `keys` with one value replaced, or one key added.
std::string with(const std::string& schema, const Keys& keys, const std::string& key, const std::string& value) {
  std::string text = "{\"schema\": \"" + schema + "\", \"source\": \"test\"";
  bool placed = key.empty();
  for (const auto& [k, v] : keys) {
    text += ", \"" + k + "\": " + (k == key ? value : v);
    placed |= k == key;
  }
  return text + (placed ? "}" : ", \"" + key + "\": " + value + "}");
}

std::string deck(const std::string& key = "", const std::string& value = "") {
  return with("apc-sph/1",
              {{"tire", "\"H44.5x16.5-21\""},
               {"material", "\"foam_50psi\""},
               {"bed_depth", "\"24 in\""},
               {"penetration", "\"16 in\""},
               {"speed", "\"70 kt\""},
               {"spacing", "\"2 in\""}},
              key, value);
}

std::string foam(const std::string& key = "", const std::string& value = "") {
  return with("apc-material/1",
              {{"name", "\"f\""},
               {"density", "\"3.75e-5 lbf-s^2/in^4\""},
               {"youngs_modulus", "\"2000 lbf/in^2\""},
               {"tension_cutoff", "\"10 psi\""},
               {"load_curve", R"({"strain": [0, 0.85, 1], "stress": {"unit": "lbf/in^2", "values": [50, 50, 1000]}})"},
               {"nominal", R"({"strength": "50 psi", "density": "25 pcf", "bottoming_strain": 0.85})"}},
              key, value);
}

template <class Read>
std::string complaint(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
std::string deck_complaint(const std::string& key, const std::string& value) {
  return complaint([&] { read_deck(parse_json(deck(key, value), "deck.json"), names); });
}
std::string foam_complaint(const std::string& key, const std::string& value) {
  return complaint([&] { read_foam(parse_json(foam(key, value), "foam.json")); });
}

TEST(Deck, ReadsQuantitiesIntoSi) {
  const RollingCase c = read_deck(parse_json(deck(), "deck.json"), names);
  EXPECT_NEAR(c.speed, 36.011, 1e-3);
  EXPECT_DOUBLE_EQ(c.spacing, 2.0 * units::in);
  EXPECT_NEAR(c.foam.density, 400.76, 0.05);
  EXPECT_DOUBLE_EQ(c.friction, 0.3);
}

TEST(Deck, SpeaksPoundForceInchSecond) {
  const RollingCase c = read_deck(parse_json(deck("material", foam()), "deck.json"), names);
  EXPECT_NEAR(c.foam.sound_speed() / units::in, 7303.0, 1.0);
}

TEST(Deck, RefusesNonsenseWithPlaceAndRemedy) {
  EXPECT_THAT(deck_complaint("speed", "\"-5 kt\""),
              AllOf(HasSubstr("deck.json"), HasSubstr("speed"), HasSubstr("positive")));
  EXPECT_THAT(deck_complaint("speed", "70"), HasSubstr("speed"));
  EXPECT_THAT(deck_complaint("speed", "\"70 lbs\""), HasSubstr("speed"));
  EXPECT_THAT(deck_complaint("bed_depth", "\"7 in\""), HasSubstr("four particles"));
  EXPECT_THAT(deck_complaint("spacing", "\"7 in\""), HasSubstr("four particles"));
  EXPECT_THAT(deck_complaint("penetration", "\"40 in\""), HasSubstr("penetration"));
  EXPECT_THAT(deck_complaint("cfl", "0.9"), HasSubstr("unstable"));
  EXPECT_THAT(deck_complaint("bed_half_width", "\"9 in\""), HasSubstr("beside the tire"));
  EXPECT_THAT(deck_complaint("frction", "0.3"), HasSubstr("frction"));
}

TEST(Material, RefusesNonsenseWithPlaceAndRemedy) {
  EXPECT_EQ(foam_complaint("", ""), "accepted");
  EXPECT_THAT(
      foam_complaint("load_curve", R"({"strain": [0, 0.9, 0.85], "stress": {"unit": "psi", "values": [1, 2, 3]}})"),
      AllOf(HasSubstr("foam.json"), HasSubstr("load_curve"), HasSubstr("does not increase")));
  EXPECT_THAT(foam_complaint("load_curve", R"({"strain": [0, 1], "stress": {"unit": "psi", "values": [1, 2, 3]}})"),
              HasSubstr("3 values for 2 strains"));
  EXPECT_THAT(foam_complaint("load_curve", R"({"strain": [0, 1.2], "stress": {"unit": "psi", "values": [1, 2]}})"),
              HasSubstr("between 0 and 1"));
  EXPECT_THAT(foam_complaint("density", "\"-25 pcf\""), HasSubstr("density"));
  EXPECT_THAT(foam_complaint("youngs_modulus", "\"0 psi\""), HasSubstr("youngs_modulus"));
  EXPECT_THAT(foam_complaint("tension_cutoff", "\"-1 psi\""), HasSubstr("negative"));
}

TEST(Material, ShippedFoamIsThePublishedIdealFoam) {
  const Foam shipped = load_foam(std::string(PROJECT_DIR) + "/designs/materials/foam_50psi.json").foam;
  const Foam ideal = ideal_foam_50psi();
  EXPECT_NEAR(shipped.density, ideal.density, 1e-9);
  for (const double strain : {0.0, 0.5, 0.85, 0.88, 0.95, 0.99})
    EXPECT_NEAR(shipped.yield_stress(strain), ideal.yield_stress(strain), 1e-3);
}

}  // namespace
}  // namespace apc::sph
