/// `apc sph run` on a coarse deck, and on decks that cannot be run.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

const std::string& coarse_deck() {
  static const std::string text = R"({
  "schema": "apc-sph/1", "name": "coarse", "source": "made for a test",
  "tire": "H44.5x16.5-21", "material": "foam_50psi", "speed": "70 kt",
  "bed_depth": "12 in", "penetration": "6 in", "spacing": "3 in"
})";
  return text;
}

TEST(SphRun, RollsATireAndAccountsForItsEnergy) {
  const Folder folder;
  folder.write("deck.json", coarse_deck());
  const auto said = run(folder, {"sph", "run", "deck.json", "-o", "o", "--json", "record.json"});
  // Coarse particles make a rough ride: the loads may not settle, which exit code 3 tells; the record stands either
  // way.
  ASSERT_TRUE(said.exit_code == 0 || said.exit_code == 3) << said.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "record.json"));
  EXPECT_EQ(said.exit_code == 0, json.at("state") == "steady") << json.at("state");
  if (said.exit_code == 3) {
    EXPECT_NE(said.err.find(json.at("state").get<std::string>()), std::string::npos);
  }
  EXPECT_EQ(json.at("symmetry"), "full");
  EXPECT_GT(json.at("drag").get<double>(), 1e3);
  EXPECT_GT(json.at("vertical").get<double>(), 1e3);
  EXPECT_LT(std::abs(json.at("energy_residual").get<double>()), 0.05);
  EXPECT_GT(json.at("particle_steps_per_s").get<double>(), 0.0);
  EXPECT_EQ(json.at("energy_of_half").at("out").size(), 13u);
  for (const auto& name : json.at("energy_of_half").at("out").items())
    EXPECT_NE(said.out.find(name.key()), std::string::npos) << name.key() << " has no line in the report";
  EXPECT_NE(text_of(folder.path() / "o/report.html").find("The rut behind the tire"), std::string::npos);
}

struct Slip {
  std::string name, from, to;
  std::vector<std::string> mentions;
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

class BadDeck : public testing::TestWithParam<Slip> {};

TEST_P(BadDeck, IsRefusedBeforeAnyWork) {
  const Folder folder;
  folder.write("deck.json", with(coarse_deck(), GetParam().from, GetParam().to));
  for (const auto& words : {std::vector<std::string>{"sph", "run", "deck.json"}, {"check", "deck.json"}}) {
    const auto said = run(folder, words);
    EXPECT_EQ(said.exit_code, 2) << said.err;
    EXPECT_EQ(said.error_lines(), 1u) << said.err;
    for (const auto& part : GetParam().mentions) EXPECT_NE(said.err.find(part), std::string::npos) << said.err;
  }
  EXPECT_EQ(folder.files(), std::set<std::string>{"deck.json"});
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadDeck,
    testing::Values(Slip{"UnknownTire", "H44.5x16.5-21", "H44.5x16.5-22", {"/tire", "H44.5x16.5-21"}},
                    Slip{"UnknownMaterial", "foam_50psi", "foam_51psi", {"foam_51psi", "foam_50psi"}},
                    Slip{"TooDeep", "\"6 in\"", "\"30 in\"", {"/penetration", "30 in", "can sink"}},
                    Slip{"SpacingOfATire", "\"3 in\"", "\"30 in\"", {"/spacing", "30 in"}},
                    Slip{"BareNumber", "\"70 kt\"", "70", {"/speed", "no unit"}},
                    Slip{"MisspeltKey", "\"spacing\"", "\"spaceing\"", {"/spaceing", "spacing"}}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace apc::scenarios
