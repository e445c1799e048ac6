/// The diagnosis as a file ("apc-diagnosis/1"), the overlay that adds effects to a model ("apc-model/1"), and the
/// predictions of held-out runs.
#pragma once

#include <filesystem>
#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

std::string diagnosis_json(const Study&);

/// The overlay: effects with their values, where they came from, and the range of runs they were learned on.
std::string overlay_json(const Study&, const std::string& command);

/// Speeds (m/s) and masses (kg) of the runs an overlay was learned on; beyond them its effects are extrapolated.
struct LearnedRange {
  double slowest = 0.0, fastest = 1e9, lightest = 0.0, heaviest = 1e9;
};
LearnedRange learned_range(const std::filesystem::path& overlay);

/// Overlay read back; `own` holds the user's effects.
std::vector<effects::Applied> load_overlay(const std::filesystem::path&, const std::vector<effects::Effect>& known);

/// Effects of a diagnosis file: those it found, or the most probable explanation it names.
std::vector<effects::Applied> effects_of_diagnosis(const std::filesystem::path&,
                                                   const std::vector<effects::Effect>& known);

/// RUN.base.csv and RUN.augmented.csv in `folder` for every run to be predicted.
void write_predictions(const Study&, const std::filesystem::path& folder);

}  // namespace apc::learning
