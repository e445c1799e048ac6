// What a diagnosis writes about an effect is what the next command reads.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "apc/base/file.h"
#include "apc/effects/other_forms.h"
#include "apc/learning/overlay_json.h"

namespace apc::learning {
namespace {

TEST(Overlay, EveryEffectOfTheCatalogueIsReadBackAsItWasWritten) {
  Case data;
  data.title = "made for a test";
  Study study;
  study.background.data = &data;
  study.background.training = 1;
  study.background.runs.resize(1);
  study.background.runs[0].overrun.entry_speed = 30.0, study.background.runs[0].overrun.mass = 60000.0;
  for (const auto& effect : effects::catalogue())
    study.diagnosis.augmented.push_back(effects::applied(effect, effect.parameters.front().usual));
  for (const auto& effect : effects::other_forms())
    study.diagnosis.augmented.push_back(effects::applied(effect, effect.parameters.front().usual));
  const auto path = std::filesystem::path(testing::TempDir()) / "apc_overlay_test.json";
  study.strength = std::log(0.93);
  study.free.emplace().none.strength = std::log(0.97);
  write_text(path, overlay_json(study, "apc learn"));
  const Overlay overlay = load_overlay(path, effects::catalogue());
  const auto& read = overlay.effects;
  std::filesystem::remove(path);
  EXPECT_NEAR(overlay.bed_strength, 0.93, 1e-4);
  EXPECT_NEAR(overlay.bed_strength_without_effects, 0.97, 1e-4);
  EXPECT_NEAR(overlay.slowest, 30.0, 1e-3);
  ASSERT_EQ(read.size(), study.diagnosis.augmented.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const auto& wanted = study.diagnosis.augmented[i];
    EXPECT_EQ(read[i].effect.id, wanted.effect.id);
    EXPECT_EQ(read[i].effect.form, wanted.effect.form);
    for (std::size_t k = 0; k < wanted.values.size(); ++k)
      EXPECT_NEAR(read[i].values[k], wanted.values[k], 1e-4 * std::abs(wanted.values[k]))
          << wanted.effect.id << "." << wanted.effect.parameters[k].name;
  }
}

}  // namespace
}  // namespace apc::learning
