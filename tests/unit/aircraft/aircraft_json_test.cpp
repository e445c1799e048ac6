#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc::aircraft {
namespace {

using testing::HasSubstr;

std::string shipped_text(const std::string& name) { return read_text(shipped("aircraft/data") / name); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// The message with which the altered 737 is refused; empty when it is accepted.
std::string refusal(const std::string& text) {
  const auto path =
      std::filesystem::temp_directory_path() / ("aircraft_json_test_" + std::to_string(::getpid()) + ".json");
  write_text(path, text);
  std::string message;
  try {
    load_aircraft(path, load_tires(shipped("aircraft/data") / "tires.json"));
  } catch (const InputError& error) {
    message = error.what();
  }
  std::filesystem::remove(path);
  return message;
}

std::string refusal(const std::string& what, const std::string& with) {
  return refusal(replaced(shipped_text("B737-800.json"), what, with));
}

TEST(AircraftFile, ShippedAircraftLoad) {
  const auto tires = load_tires(shipped("aircraft/data") / "tires.json");
  EXPECT_EQ(tires.size(), 7u);
  for (const auto* name : {"CRJ-200", "B727-100", "B737-800", "B747-400"}) {
    const auto plane = load_aircraft(shipped("aircraft/data") / (std::string(name) + ".json"), tires);
    EXPECT_EQ(plane.name, name);
    EXPECT_TRUE(plane.gears.front().is_nose());
  }
}

TEST(AircraftFile, TheJumboHasFourBogiesInTwoGroups) {
  const auto plane =
      load_aircraft(shipped("aircraft/data") / "B747-400.json", load_tires(shipped("aircraft/data") / "tires.json"));
  ASSERT_EQ(plane.gears.size(), 3u);
  EXPECT_EQ(plane.gears[1].wheels() + plane.gears[2].wheels(), 16);
  EXPECT_NEAR(plane.gears[1].axle_spacing, 1.473, 1e-12);
}

TEST(AircraftFile, RefusesAStrutThatCannotCarryItsLoad) {
  const auto message = refusal("\"2.575 MPa\"", "\"0.15 MPa\"");
  EXPECT_THAT(message, HasSubstr("/gears/1/strut/extended_pressure: \"0.15 MPa\" cannot carry the static load"));
  EXPECT_THAT(message, HasSubstr("Raise extended_pressure"));
}

TEST(AircraftFile, RefusesACentreOfGravityBehindTheMainGear) {
  EXPECT_THAT(refusal("\"14.5 m\"", "\"15.7 m\""),
              HasSubstr("/cg/behind_nose_gear: \"15.7 m\" lies behind the main gear"));
}

TEST(AircraftFile, RefusesACentreOfGravityAheadOfTheNose) {
  EXPECT_THAT(refusal("\"14.5 m\"", "\"-0.5 m\""), HasSubstr("lies ahead of the nose gear"));
}

TEST(AircraftFile, RefusesANegativeInertia) {
  EXPECT_THAT(refusal("\"3.0e6 kg m^2\"", "\"-3.0e6 kg m^2\""),
              HasSubstr("/pitch_inertia: \"-3.0e6 kg m^2\" must be positive"));
}

TEST(AircraftFile, RefusesARampMassBelowTheMass) {
  EXPECT_THAT(refusal("\"79243 kg\"", "\"60000 kg\""),
              HasSubstr("/ramp_mass: \"60000 kg\" is below the mass of 66361 kg"));
}

TEST(AircraftFile, RefusesATakeOffMassAboveTheRampMass) {
  EXPECT_THAT(refusal("\"79016 kg\"", "\"79500 kg\""),
              HasSubstr("/takeoff_mass: \"79500 kg\" is above the ramp_mass of 79243 kg"));
}

TEST(AircraftFile, BogiesHaveBrakeRodsUnlessItSaysOtherwise) {
  const auto path = std::filesystem::temp_directory_path() / ("brake_rods_" + std::to_string(::getpid()) + ".json");
  const auto tires = load_tires(shipped("aircraft/data") / "tires.json");
  write_text(
      path, replaced(shipped_text("B747-400.json"), "\"name\": \"body\"", "\"name\": \"body\", \"brake_rods\": false"));
  const auto plane = load_aircraft(path, tires);
  std::filesystem::remove(path);
  EXPECT_TRUE(plane.gears[1].brake_rods);
  EXPECT_FALSE(plane.gears[2].brake_rods);
  EXPECT_THAT(refusal("\"name\": \"main\"", "\"name\": \"main\", \"brake_rods\": false"),
              HasSubstr("brake_rods"));  // one axle has no beam
}

TEST(AircraftFile, RefusesAnUltimateLoadBelowTheLimitInForceThoughARuleGivesThat) {
  // 14 CFR 25.509 from the ramp weight: 116.6 kN.
  const auto message = refusal("\"name\": \"nose\"", "\"name\": \"nose\", \"limits\": {\"drag_ultimate\": \"100 kN\"}");
  EXPECT_THAT(message, HasSubstr("/limits/drag_ultimate: \"100 kN\" is below the limit load of 116.566"));
  EXPECT_EQ(refusal("\"name\": \"nose\"", "\"name\": \"nose\", \"limits\": {\"drag_ultimate\": \"120 kN\"}"), "");
}

TEST(AircraftFile, RefusesAnInertiaBelowThatOfTheUnsprungMassesAlone) {
  const auto message = refusal("\"3.0e6 kg m^2\"", "\"2e4 kg m^2\"");
  EXPECT_THAT(message, HasSubstr("/pitch_inertia: \"2e4 kg m^2\""));
  EXPECT_THAT(message, HasSubstr("is less than the unsprung masses on the axles alone contribute"));
}

TEST(AircraftFile, RefusesATireThatIsNotInTheLibrary) {
  const auto message = refusal("\"H27x7.7-15\"", "\"H27x7.7-51\"");
  EXPECT_THAT(message, HasSubstr("/gears/0/tire: \"H27x7.7-51\" is not in the tire library"));
  EXPECT_THAT(message, HasSubstr("Did you mean \"H27x7.7-15\"?"));
}

TEST(AircraftFile, RefusesAStrutWithoutStroke) {
  EXPECT_THAT(refusal("\"0.36 m\"", "\"0 m\""), HasSubstr("/gears/1/strut/stroke: \"0 m\" leaves the strut no travel"));
}

TEST(AircraftFile, RefusesGasCompressedToNothing) {
  EXPECT_THAT(refusal("\"0.01421 m^3\"", "\"0.0130 m^3\""), HasSubstr("the gas would be compressed to nothing"));
}

TEST(AircraftFile, RefusesUnknownKeysAndBareNumbers) {
  EXPECT_THAT(refusal("\"unsprung_mass\"", "\"unsprung_maas\""), HasSubstr("unsprung_mass"));
  EXPECT_THAT(refusal("\"66361 kg\"", "66361"), HasSubstr("/mass: 66361 has no unit"));
  EXPECT_THAT(refusal("\"braked\": true", "\"braked\": true, \"brakes\": 4"), HasSubstr("is an unknown key"));
}

TEST(AircraftFile, RefusesAGearOutOfOrder) {
  EXPECT_THAT(refusal("\"name\": \"nose\"", "\"name\": \"front\""), HasSubstr("/gears/0/name"));
}

TEST(TireFile, CurvePassesRatedAndBottomingPoints) {
  for (const auto& [name, tire] : load_tires(shipped("aircraft/data") / "tires.json")) {
    EXPECT_NEAR(tire.load_curve(tire.rated_deflection), tire.rated_load, 1e-6) << name;
    EXPECT_NEAR(tire.load_curve(tire.bottoming_deflection), tire.bottoming_load, 1e-6) << name;
  }
}

TEST(TireFile, RefusesATireThatBottomsBelowItsRating) {
  const auto path = std::filesystem::temp_directory_path() / ("tire_json_test_" + std::to_string(::getpid()) + ".json");
  write_text(path, replaced(shipped_text("tires.json"), "\"152800 lbf\"", "\"52800 lbf\""));
  try {
    load_tires(path);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/tires/0/bottoming_load: \"52800 lbf\" must exceed the rated load"));
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace apc::aircraft
