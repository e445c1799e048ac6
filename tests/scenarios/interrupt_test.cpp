/// ^C: the program ends with 130, says so, and leaves no half file.
#include <gtest/gtest.h>

#include "tests/scenarios/program.h"

namespace apc::scenarios {
namespace {

const std::string& slow_deck() {
  static const std::string text = R"({
  "schema": "apc-sph/1", "name": "a long run", "source": "made for a test",
  "tire": "H29x9.0-15", "material": "foam_50psi", "speed": "40 kt",
  "bed_depth": "18 in", "penetration": "10 in", "spacing": "0.6 in"
})";
  return text;
}

void expect_no_half_file(const Folder& folder) {
  for (const auto& name : folder.files()) EXPECT_FALSE(name.ends_with(".part")) << name;
}

TEST(Interrupt, EndsALongParticleRunWithoutFiles) {
  const Folder folder;
  folder.write("deck.json", slow_deck());
  Running program(folder, {"sph", "run", "deck.json", "--threads", "1"});
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  ASSERT_FALSE(program.ended()) << "the run is too short for this test";
  program.interrupt();
  const auto said = program.wait();
  EXPECT_EQ(said.exit_code, 130) << said.err;
  EXPECT_NE(said.err.find("interrupted"), std::string::npos) << said.err;
  EXPECT_EQ(folder.files(), std::set<std::string>{"deck.json"});
}

TEST(Interrupt, AKilledParticleRunGoesOnFromItsCheckpointToTheSameBits) {
  const Folder folder;
  folder.write("deck.json", with(with(slow_deck(), "0.6 in", "1.2 in"), "18 in", "12 in"));
  const std::vector<std::string> plain{"sph", "run", "deck.json", "--threads", "1", "-o", "whole"};
  auto kept = plain;
  kept.back() = "resumed";
  kept.insert(kept.end(), {"--checkpoint", "state.h5", "--checkpoint-every", "0 s", "--snapshots", "s"});
  const int code = run(folder, plain).exit_code;
  Running program(folder, kept);
  const auto there = [&](const char* name) { return std::filesystem::exists(folder.path() / name); };
  for (int k = 0; k < 400 && !(there("state.h5") && there("s/run.pvd")) && !program.ended(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // a state later than the first snapshot
  ASSERT_FALSE(program.ended()) << "the run is too short for this test";
  program.kill();
  program.wait();
  ASSERT_TRUE(there("state.h5"));
  EXPECT_FALSE(there("resumed/result.json"));
  folder.write("s/particles_0000.vtu", "kept");  // a run that began anew would write it again
  EXPECT_EQ(run(folder, kept).exit_code, code);
  EXPECT_EQ(text_of(folder.path() / "s/particles_0000.vtu"), "kept");
  const auto drop_command = [](std::string text) { return text.substr(text.find("time")); };
  EXPECT_EQ(drop_command(text_of(folder.path() / "resumed/history.csv")),
            drop_command(text_of(folder.path() / "whole/history.csv")));
  EXPECT_FALSE(there("state.h5"));
  EXPECT_NE(text_of(folder.path() / "s/run.pvd").find("particles_0001.vtu"), std::string::npos);
}

TEST(Interrupt, LeavesAnOverrunWholeOrNotThereAtAnyMoment) {
  // The run takes a fraction of a second; ^C falls into reading, integrating or writing.
  for (const int milliseconds : {5, 20, 60, 120, 200, 400}) {
    const Folder folder;
    folder.write("bed.json", good_bed());
    Running program(folder, {"simulate", "--aircraft", "B737-800", "--bed", "bed.json", "--speed", "70 kt", "-o", "o"});
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.interrupt();
    const auto said = program.wait();
    EXPECT_TRUE(said.exit_code == 0 || said.exit_code == 130) << said.exit_code << said.err;
    expect_no_half_file(folder);
    const auto page = folder.path() / "o/report.html";
    if (said.exit_code == 0) {
      EXPECT_TRUE(std::filesystem::exists(page));
    }
    if (std::filesystem::exists(page)) {
      EXPECT_TRUE(text_of(page).ends_with("</body></html>\n"));
    }
  }
}

}  // namespace
}  // namespace apc::scenarios
