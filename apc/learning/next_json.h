/// The plan of the next run as a file ("apc-next/1"), and the explanations a diagnosis file leaves standing.
#pragma once

#include <filesystem>

#include "apc/learning/next_run.h"

namespace apc::learning {

std::string next_json(const NextPlan&);

/// Reads "set90", "rivals" and "effects" of an "apc-diagnosis/1". InputError with file and place.
std::vector<std::vector<effects::Applied>> contenders_of_file(const std::filesystem::path&,
                                                              const std::vector<effects::Effect>& known);

}  // namespace apc::learning
