/// What was learned, as a file ("apc-model/1") that is laid over a model and edits none of its files: effects with
/// their values, where they came from, and the range of runs they were learned on.
#pragma once

#include <filesystem>
#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

std::string overlay_json(const Study&, const std::string& command);

struct Overlay {
  std::vector<effects::Applied> effects;
  /// Factors on the strength of the bed that the runs were made in, fitted with the effects and without them.
  double bed_strength = 1.0, bed_strength_without_effects = 1.0;
  /// Speeds (m/s) and masses (kg) of those runs; beyond them the effects are extrapolated.
  double slowest = 0.0, fastest = 1e9, lightest = 0.0, heaviest = 1e9;
};

/// `known`: the catalogue and the user's own effects. InputError with file and place.
Overlay load_overlay(const std::filesystem::path&, const std::vector<effects::Effect>& known);

}  // namespace apc::learning
