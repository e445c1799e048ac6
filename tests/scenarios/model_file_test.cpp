/// Learned effects as a file (apc-model/1): what --model does to an overrun, a design and a report, and how it is
/// refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/scenarios/design_files.h"

namespace apc::scenarios {
namespace {

const std::string model = R"({ "schema": "apc-model/1", "source": "made for a test",
  "effects": [ { "id": "inertial", "parameters": { "C": 0.6 } } ],
  "learned_on": { "runs": ["a", "b"], "speed": ["60 kt", "75 kt"], "mass": ["20 t", "22 t"] } })";

double stop_in(const Folder& folder, const std::string& file) {
  return nlohmann::json::parse(text_of(folder.path() / file)).at("stop_distance").get<double>();
}

TEST(Model, OfLearnedEffectsIsCheckedAndShortensAStop) {
  const Folder folder;
  folder.write("model.json", model);
  const auto checked = run(folder, {"check", "model.json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_NE(checked.out.find("inertial"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("60"), std::string::npos) << checked.out;
  const std::vector<std::string> words{"simulate", "--aircraft", "CRJ-200", "--bed",    "emas_18in_50psi",
                                       "--speed",  "70 kt",      "--quiet", "--method", "fast"};
  auto plain = words, learned = words;
  plain.insert(plain.end(), {"-o", "plain"});
  learned.insert(learned.end(), {"-o", "learned", "--model", "model.json"});
  ASSERT_EQ(run(folder, plain).exit_code, 0);
  const auto said = run(folder, learned);
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(said.err, "");
  EXPECT_LT(stop_in(folder, "learned/result.json"), 0.99 * stop_in(folder, "plain/result.json"));
}

TEST(Model, OfLearnedEffectsChangesADesignAndIsReported) {
  const Folder folder;
  make_design(folder);
  folder.write("model.json", model);
  const auto designed =
      run(folder, {"design", "--fleet", "acrp29_crj_200", "--model", "model.json", "-o", "m", "--quiet"});
  ASSERT_EQ(designed.exit_code, 0) << designed.err;
  const auto length = [&](const char* file) {
    const auto bed = nlohmann::json::parse(text_of(folder.path() / file)).at("bed");
    return bed.at("profile").at("distance").at("values").back().get<double>();
  };
  EXPECT_LE(length("m/design.json"), length("d/design.json"));
  EXPECT_NE(text_of(folder.path() / "m/design.json"), text_of(folder.path() / "d/design.json"));

  const auto said = run(folder, {"report", "--design", "d/design.json", "--model", "model.json", "-o", "r"});
  ASSERT_TRUE(said.exit_code == 0 || said.exit_code == 1) << said.err;
  const auto page = text_of(folder.path() / "r/report.html");
  EXPECT_NE(page.find("inertial"), std::string::npos);
  const auto again = run(folder, {"report", "--manifest", "r/manifest.json", "-o", "again"});
  EXPECT_EQ(again.exit_code, said.exit_code) << again.err;
  EXPECT_TRUE(text_of(folder.path() / "again/report.html") == page);
}

struct Mistake {
  std::string name, text;
  std::vector<std::string> mentions;
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class BadModel : public testing::TestWithParam<Mistake> {};

TEST_P(BadModel, IsRefusedByEveryCommandThatTakesOne) {
  const Folder folder;
  folder.write("model.json", GetParam().text);
  auto mentions = GetParam().mentions;
  mentions.push_back("model.json");
  expect_refused(folder, {"check", "model.json"}, mentions);
  expect_refused(
      folder,
      {"simulate", "--aircraft", "CRJ-200", "--bed", "emas_18in_50psi", "--speed", "70 kt", "--model", "model.json"},
      mentions);
  expect_refused(folder, {"design", "--fleet", "acrp29_crj_200", "--model", "model.json", "-o", "m", "--quiet"},
                 mentions);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadModel,
    testing::Values(
        Mistake{"NoSource", with(model, "\"source\": \"made for a test\",", ""), {"/source", "missing"}},
        Mistake{"UnknownEffect", with(model, "inertial", "inertia"), {"/effects/0/id", "inertia", "apc effects list"}},
        Mistake{"MisspeltParameter", with(model, "\"C\"", "\"Cx\""), {"/effects/0/parameters", "Cx", "unknown key"}},
        Mistake{"WordForANumber", with(model, "0.6", "\"much\""), {"/effects/0/parameters/C", "much"}},
        Mistake{"NoEffects", with(model, "\"effects\"", "\"effect\""), {"/effects", "missing"}},
        Mistake{"SpeedWithoutUnit", with(model, "\"60 kt\"", "60"), {"/learned_on/speed", "60", "no unit"}},
        Mistake{"OneSpeed", with(model, "\"60 kt\", ", ""), {"/learned_on/speed", "lowest and highest"}},
        Mistake{"SpeedsSwapped", with(model, "\"60 kt\", \"75 kt\"", "\"75 kt\", \"60 kt\""), {"/learned_on/speed"}},
        Mistake{"UnknownKey", with(model, "\"effects\"", "\"colour\": \"grey\", \"effects\""), {"/colour", "unknown"}}),
    [](const auto& each) { return each.param.name; });

TEST(Model, ThatDoesNotExistIsRefused) {
  const Folder folder;
  expect_refused(folder, {"check", "none.json"}, {"none.json"});
  expect_refused(folder, {"design", "--fleet", "acrp29_crj_200", "--model", "none.json", "-o", "m", "--quiet"},
                 {"none.json"});
}

}  // namespace
}  // namespace apc::scenarios
