/// The diagnosis as a file ("apc-diagnosis/1"), and the predictions of held-out runs.
#pragma once

#include <filesystem>
#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

std::string diagnosis_json(const Study&);

/// Effects of a diagnosis file: those it found, or the most probable explanation it names.
std::vector<effects::Applied> effects_of_diagnosis(const std::filesystem::path&,
                                                   const std::vector<effects::Effect>& known);

/// RUN.base.csv and RUN.augmented.csv in `folder` for every run to be predicted.
void write_predictions(const Study&, const std::filesystem::path& folder);

}  // namespace apc::learning
