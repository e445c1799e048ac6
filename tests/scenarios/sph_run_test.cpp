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
  const auto& loads = said.exit_code == 0 ? json : json.at("last_window");
  EXPECT_GT(loads.at("drag").get<double>(), 1e3);
  EXPECT_GT(loads.at("vertical").get<double>(), 1e3);
  EXPECT_LT(std::abs(json.at("energy_residual").get<double>()), 0.05);
  EXPECT_GT(json.at("particle_steps_per_s").get<double>(), 0.0);
  EXPECT_NE(said.out.find(" bytes per particle"), std::string::npos);
  EXPECT_EQ(json.at("energy_of_half").at("out").size(), 13u);
  for (const auto& name : json.at("energy_of_half").at("out").items())
    EXPECT_NE(said.out.find(name.key()), std::string::npos) << name.key() << " has no line in the report";
  EXPECT_NE(said.out.find("shape of the rut"), std::string::npos);
  EXPECT_GT(json.at("rut_shape").at("floor").get<double>(), json.at("rut_shape").at("floor_ideal").get<double>());
  const auto page = text_of(folder.path() / "o/report.html");
  EXPECT_NE(page.find("The rut behind the tire"), std::string::npos);
  EXPECT_NE(page.find("across the rut, in"), std::string::npos);
  EXPECT_NE(page.find("across the rut, mm"), std::string::npos);
}

TEST(SphRun, ThatDoesNotSettleYieldsNoLoadButWhatItHad) {
  const Folder folder;
  folder.write("deck.json", with(coarse_deck(), R"("spacing": "3 in")", R"("spacing": "3 in", "longest": "20 in")"));
  const auto said = run(folder, {"sph", "run", "deck.json", "-o", "o", "--json", "record.json"});
  EXPECT_EQ(said.exit_code, 3) << said.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "record.json"));
  EXPECT_EQ(json.at("state"), "did_not_settle");
  EXPECT_NE(said.err.find("did_not_settle"), std::string::npos);
  EXPECT_NE(said.out.find("no load"), std::string::npos);
  for (const char* load : {"drag", "vertical", "rut_depth"}) {
    EXPECT_TRUE(json.at(load).is_null()) << load;
    EXPECT_TRUE(json.at("last_window").contains(load)) << load;
  }
}

/// The shipped foam written into the deck, with one entry changed.
std::string foam(const std::string& from, const std::string& to) {
  static const std::string text = R"({
  "schema": "apc-material/1", "name": "own", "source": "made for a test", "density": "25 pcf",
  "youngs_modulus": "2000 psi", "tension_cutoff": "10 psi",
  "load_curve": {"strain": [0.0, 0.85, 1.0], "stress": {"unit": "psi", "values": [50, 50, 1500]}},
  "nominal": {"strength": "50 psi", "density": "25 pcf", "bottoming_strain": 0.85}})";
  return with(text, from, to);
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
                    Slip{"FallingLoadCurve",
                         "\"foam_50psi\"",
                         foam("0.85, 1.0", "1.0, 0.85"),
                         {"/material/load_curve/strain", "does not increase", "0.85 follows 1", "Sort"}},
                    Slip{"NegativeDensity",
                         "\"foam_50psi\"",
                         foam("\"density\": \"25 pcf\",\n", "\"density\": \"-25 pcf\",\n"),
                         {"/material/density", "-25 pcf", "not positive"}},
                    Slip{"BedOfThreeParticles",
                         "\"12 in\"",
                         "\"9 in\"",
                         {"/spacing", "thinner than four particles", "9 in at 3 in", "2.25 in"}},
                    Slip{"SidewaysSpin", "\"3 in\"", "\"3 in\", \"spin\": \"sideways\"", {"/spin", "free, driven"}},
                    Slip{"SpacingOfATire", "\"3 in\"", "\"30 in\"", {"/spacing", "30 in"}},
                    Slip{"BareNumber", "\"70 kt\"", "70", {"/speed", "no unit"}},
                    Slip{"MisspeltKey", "\"spacing\"", "\"spaceing\"", {"/spaceing", "spacing"}}),
    [](const auto& each) { return each.param.name; });

TEST(SphVerify, PutsParticlesAndElementsBesideThePaper) {
  const Folder folder;
  const auto said = run(folder, {"sph", "verify", "roller_2d", "--h", "4 in", "--method", "both", "--json", "v.json"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "v.json"));
  EXPECT_NEAR(json.at("reference").at("drag").get<double>() / 195.6e3, 1.0, 1e-3);  // 1,117 lbf/in
  EXPECT_NEAR(json.at("fem").at("reference").at("drag").get<double>() / 191.1e3, 1.0, 1e-3);
  for (const auto* method : {&json, &json.at("fem")}) {
    double sum = method->at("energy_residual").get<double>();
    for (const auto& share : method->at("energy_shares")) sum += share.get<double>();
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_LT(std::abs(method->at("energy_residual").get<double>()), 0.015);
  }
  EXPECT_EQ(json.at("hourglass_share"), 0.0);
  EXPECT_GT(json.at("fem").at("hourglass_share").get<double>(), 0.02);
  EXPECT_GT(json.at("bytes_per_particle").get<double>(), 100.0);
  EXPECT_LT(json.at("bytes_per_particle").get<double>(), 2000.0);
  EXPECT_GE(json.at("assumptions").size(), 5u);
  for (const char* line : {"hourglass over internal", "residual", "bytes per particle", "Not printed in the study"})
    EXPECT_NE(said.out.find(line), std::string::npos) << line;
}

TEST(SphConverge, StatesTheErrorOfAnyDeck) {
  const Folder folder;
  folder.write("deck.json", with(with(coarse_deck(), "H44.5x16.5-21", "R18x4.4"),
                                 "\"12 in\", \"penetration\": \"6 in\"", "\"6 in\", \"penetration\": \"3 in\""));
  const auto said = run(folder, {"sph", "converge", "deck.json", "--method", "sph", "--sizes", "1.1 in, 0.9 in, 0.7 in",
                                 "--json", "c.json"});
  ASSERT_EQ(said.exit_code, 2) << said.err;  // the deck's own spacing does not resolve this tire
  EXPECT_NE(said.err.find("/spacing"), std::string::npos) << said.err;
  folder.write("deck.json", with(text_of(folder.path() / "deck.json"), "\"3 in\"\n", "\"0.9 in\"\n"));
  const auto again = run(folder, {"sph", "converge", "deck.json", "--method", "sph", "--sizes",
                                  "1.1 in, 0.9 in, 0.7 in", "--json", "c.json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "c.json"));
  EXPECT_EQ(json.at("sizes").size(), 3u);
  EXPECT_EQ(json.at("values").at("drag").size(), 3u);
  EXPECT_TRUE(json.at("reference").at("drag").is_null());
  EXPECT_EQ(run(folder, {"sph", "verify", "deck.json", "--spin", "locked"}).exit_code, 2);
}

TEST(SphVerify, UnknownWordsAreRefused) {
  const Folder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"sph", "verify", "tire_4d"}, "tire_3d"},
      {{"sph", "verify", "roller_2d", "--method", "bem"}, "sph, fem, both"},
      {{"sph", "verify", "roller_2d", "--spin", "sideways"}, "free, driven, locked"},
      {{"sph", "verify", "roller_2d", "--entry", "50"}, "no unit"},
      {{"sph", "converge", "roller_2d", "--sizes", "2 in"}, "fewer than three"}};
  for (const auto& [words, mention] : wrong) {
    const auto said = run(folder, words);
    EXPECT_EQ(said.exit_code, 2) << said.err;
    EXPECT_EQ(said.error_lines(), 1u) << said.err;
    EXPECT_NE(said.err.find(mention), std::string::npos) << said.err;
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(SphBench, PrintsThroughputBesideTheLimitsOfTheProcessor) {
  const Folder folder;
  const auto said = run(folder, {"sph", "bench", "--quick", "--threads", "2", "--json", "bench.json"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const auto json = nlohmann::json::parse(text_of(folder.path() / "bench.json"));
  const auto& one = json.at("rows").at(0);
  const auto& two = json.at("rows").at(1);
  EXPECT_EQ(one.at("threads"), 1);
  EXPECT_EQ(two.at("threads"), 2);
  EXPECT_EQ(one.at("drag"), two.at("drag"));  // same bits
  EXPECT_EQ(one.at("vertical"), two.at("vertical"));
  const double wall = one.at("window_wall_s"), steps = json.at("window_steps"), particles = json.at("particles");
  EXPECT_NEAR(one.at("nominal").get<double>() / (particles * steps / wall), 1.0, 1e-9);
  const auto& each = json.at("per_particle_step");
  EXPECT_GT(each.at("pairs").get<double>(), each.at("pairs_within").get<double>());
  const double share =
      one.at("rest").get<double>() * each.at("operations").get<double>() / one.at("limit_operations").get<double>();
  EXPECT_GT(share, 0.0);  // how large is for a benchmark to say: a busy machine measures both at different times
  EXPECT_GT(json.at("crushed_cost").get<double>(), 0.0);
  EXPECT_LT(json.at("bytes_per_particle").get<double>(), 2000.0);
  for (const char* word :
       {"foam at rest", "nominal", "same bits", "Gflop/s", "share of the limit", "bytes per particle"})
    EXPECT_NE(said.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace apc::scenarios
