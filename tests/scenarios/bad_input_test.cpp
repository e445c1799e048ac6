/// Every kind of bad input: one message that says where, what and what to do; exit code 2; nothing written.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/scenarios/refusal.h"

namespace apc::scenarios {
namespace {

struct Mistake {
  std::string name, bed;              ///< the altered bed file
  std::vector<std::string> mentions;  ///< what the message must hold: place, value, remedy
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class BadBed : public testing::TestWithParam<Mistake> {};

TEST_P(BadBed, IsRefusedBySimulateAndCheck) {
  const Folder folder;
  folder.write("bed.json", GetParam().bed);
  auto mentions = GetParam().mentions;
  mentions.push_back("bed.json");
  expect_refused(folder, {"simulate", "--aircraft", "B737-800", "--bed", "bed.json", "--speed", "70 kt"}, mentions);
  expect_refused(folder, {"check", "bed.json"}, mentions);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadBed,
    testing::Values(
        Mistake{"EmptyFile", "", {"is empty", "JSON object"}},
        Mistake{"NoJson", "setback = 50 ft", {"is not JSON", "line 1"}},
        Mistake{"CutOff", good_bed().substr(0, 150), {"is not JSON"}}, Mistake{"AList", "[1, 2]", {"not an object"}},
        Mistake{"MissingKey", with(good_bed(), "\"setback\": \"50 ft\", ", ""), {"/setback", "missing", "Add"}},
        Mistake{"MissingSource", with(good_bed(), ", \"source\": \"made for a test\"", ""), {"/source", "missing"}},
        Mistake{"MisspeltKey", with(good_bed(), "\"setback\"", "\"setbak\""), {"setback", "setbak"}},
        Mistake{"UnknownKey",
                with(good_bed(), "\"grade\": 0.0", "\"grade\": 0.0, \"colour\": \"grey\""),
                {"/colour", "unknown key", "grey"}},
        Mistake{"BareNumber", with(good_bed(), "\"50 ft\"", "50"), {"/setback", "50", "no unit", "Write"}},
        Mistake{"UnknownUnit", with(good_bed(), "\"50 ft\"", "\"50 feets\""), {"/setback", "feets"}},
        Mistake{"WrongDimension", with(good_bed(), "\"50 ft\"", "\"50 kt\""), {"/setback", "50 kt", "a length"}},
        Mistake{"WrongDimensionOfList", with(good_bed(), "\"in\"", "\"psi\""), {"/profile/depth/unit", "a length"}},
        Mistake{"DistancesFallBack",
                with(good_bed(), "[0, 50, 500]", "[0, 500, 50]"),
                {"/profile/distance", "50", "increase"}},
        Mistake{
            "NegativeDepth", with(good_bed(), "[0, 18, 18]", "[0, -18, 18]"), {"/profile/depth", "-18", "negative"}},
        Mistake{"AbsurdDepth", with(good_bed(), "[0, 18, 18]", "[0, 1800, 1800]"), {"/profile/depth", "1800"}},
        Mistake{"NotANumber", with(good_bed(), "[0, 18, 18]", "[0, NaN, 18]"), {"is not JSON"}},
        Mistake{"NullInAList", with(good_bed(), "[0, 18, 18]", "[0, null, 18]"), {"/profile/depth/values/1", "null"}},
        Mistake{"NotANumberAsText", with(good_bed(), "\"50 ft\"", "\"nan ft\""), {"/setback", "nan", "finite"}},
        Mistake{"UnequalLengths", with(good_bed(), "[0, 18, 18]", "[0, 18]"), {"/profile/depth", "2 values", "3"}},
        Mistake{"OtherSchema", with(good_bed(), "apc-bed/1", "apc-bed/9"), {"/schema", "apc-bed/9"}}),
    [](const auto& each) { return each.param.name; });

TEST(BadInput, UnknownMaterialIsNamedWithTheOnesThereAre) {
  const Folder folder;
  folder.write("bed.json", with(good_bed(), "foam_50psi", "foam_51psi"));
  expect_refused(folder, {"simulate", "--aircraft", "B737-800", "--bed", "bed.json", "--speed", "70 kt"},
                 {"bed.json /material", "foam_51psi", "foam_50psi"});
}

struct Words {
  std::string name;
  std::vector<std::string> words, mentions;
};

void PrintTo(const Words& words, std::ostream* out) { *out << words.name; }

class BadArgument : public testing::TestWithParam<Words> {};

TEST_P(BadArgument, IsRefused) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  std::vector<std::string> all{"simulate"};
  const auto& words = GetParam().words;
  const auto give = [&](const char* option, const char* value) {
    if (std::find(words.begin(), words.end(), option) == words.end()) all.insert(all.end(), {option, value});
  };
  give("--aircraft", "B737-800");
  give("--bed", "bed.json");
  give("--speed", "70 kt");
  all.insert(all.end(), words.begin(), words.end());
  expect_refused(folder, all, GetParam().mentions);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadArgument,
    testing::Values(
        Words{"SpeedWithoutUnit", {"--speed", "70"}, {"--speed", "70", "no unit", "70 kt"}},
        Words{"NegativeSpeed", {"--speed", "-5 kt"}, {"--speed", "-5 kt", "above zero"}},
        Words{"SpeedInPounds", {"--speed", "70 lbs"}, {"--speed", "70 lbs", "a mass", "a speed"}},
        Words{"SpeedNan", {"--speed", "nan kt"}, {"--speed", "nan", "finite"}},
        Words{"AbsurdSpeed", {"--speed", "700 kt"}, {"--speed", "700 kt", "200 kt"}},
        Words{"SpeedOfZero", {"--speed", "0 kt"}, {"--speed", "above zero"}},
        Words{"SpeedAtRest", {"--speed", "0.05 m/s"}, {"--speed", "0.05 m/s", "at rest"}},
        Words{"ReverseWithoutASource", {"--thrust", "reverse-idle"}, {"--thrust", "no sourced value", "Write the net"}},
        Words{"UnknownBrakeMode", {"--brake-mode", "drum"}, {"--brake-mode", "drum", "friction or torque"}},
        Words{"UnknownSensitivity", {"--sensitivities", "entry_speed, colour"}, {"--sensitivities", "colour", "grade"}},
        Words{"InertiaOfAnotherAircraft", {"--pitch-inertia", "1 kg m^2"}, {"--pitch-inertia", "1 kg m^2"}},
        Words{"ToleranceThatMisleads", {"--rtol", "2e-4"}, {"--rtol", "2e-4", "0.0001"}},
        Words{"SpeedNoNumber", {"--speed", "fast"}, {"--speed", "fast", "number"}},
        Words{"UnknownAircraft", {"--aircraft", "B737-80"}, {"B737-80", "B737-800"}},
        Words{"MissingBed", {"--bed", "nowhere.json"}, {"nowhere.json", "no such bed"}},
        Words{"BedIsAnAircraft", {"--bed", PROJECT_DIR "/aircraft/data/B737-800.json"}, {"/schema", "apc-aircraft/1"}},
        Words{"MassOfAnotherAircraft", {"--mass", "400000 kg"}, {"--mass", "400000 kg"}},
        Words{"CgBehindTheMainGear", {"--cg", "40 m"}, {"--cg", "40 m", "tip over"}},
        Words{"BrakingBeyondOne", {"--braking", "25"}, {"--braking", "25"}},
        Words{"UnknownMethod", {"--method", "euler"}, {"--method", "euler", "reference"}},
        Words{"LooseTolerance", {"--rtol", "1"}, {"--rtol"}},
        Words{"MissingFolderOfTables", {"--loads", "nowhere"}, {"nowhere", "no such folder"}},
        Words{"MisspeltOption", {"--brakng", "0.2"}, {"--brakng", "--braking"}},
        Words{"UnknownUnits", {"--units", "furlongs"}, {"--units", "furlongs", "field"}}),
    [](const auto& each) { return each.param.name; });

TEST(BadInput, UnknownCommandGetsTheNearestOne) {
  const Folder folder;
  expect_refused(folder, {"simulat"}, {"simulat", "Did you mean \"simulate\"?"});
}

TEST(BadInput, MissingRequiredOptionIsNamed) {
  const Folder folder;
  expect_refused(folder, {"simulate", "--aircraft", "B737-800"}, {"--bed"});
}

TEST(BadInput, TruncatedAndForeignTablesAreNamed) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  std::filesystem::create_directory(folder.path() / "tables");
  const std::vector<std::string> words{"simulate", "--aircraft", "B737-800", "--bed", "bed.json",
                                       "--speed",  "70 kt",      "--loads",  "tables"};
  folder.write("tables/H27x7.7-15_foam_50psi.h5", "this is no table");
  expect_refused(folder, words, {"tables"});
  expect_refused(folder, {"check", "tables/H27x7.7-15_foam_50psi.h5"}, {"H27x7.7-15_foam_50psi.h5", "HDF5"});
  const auto whole = text_of(PROJECT_DIR "/loadtables/data/H27x7.7-15_foam_50psi.h5");
  ASSERT_GT(whole.size(), 1000u);
  folder.write("tables/H27x7.7-15_foam_50psi.h5", whole.substr(0, whole.size() / 2));
  expect_refused(folder, words, {"tables"});
  expect_refused(folder, {"check", "tables/H27x7.7-15_foam_50psi.h5"}, {"H27x7.7-15_foam_50psi.h5"});
}

TEST(BadInput, OutputThatCannotBeWrittenLeavesNothing) {
  const Folder folder;
  folder.write("bed.json", good_bed());
  folder.write("in_the_way", "a file where a folder is wanted");
  expect_refused(folder,
                 {"simulate", "--aircraft", "B737-800", "--bed", "bed.json", "--speed", "70 kt", "-o", "in_the_way"},
                 {"in_the_way"});
}

TEST(BadInput, CheckReportsAllFilesAndFailsForOne) {
  const Folder folder;
  folder.write("good.json", good_bed());
  folder.write("bad.json", with(good_bed(), "\"50 ft\"", "50"));
  const auto said = run(folder, {"check", "bad.json", "good.json"});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.out.find("good  good.json"), std::string::npos) << said.out;
  EXPECT_NE(said.err.find("bad.json /setback"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace apc::scenarios
