/// Pictures of what can and cannot be told: which effects look alike in these runs, how well each found parameter is
/// known, and what the added effects do to free runs. HTML without head or body.
#pragma once

#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// |correlation| of the leading effects' responses, as a matrix of greys with its numbers.
std::string confusion_matrix(const Study&);
/// Every claimed amplitude: range of the catalogue, 95 % interval, value, neutral value; one scale per row.
std::string parameter_intervals(const Study&);
/// Error of free runs before and after the effects are added, per run at hand. Empty where nothing is added.
std::string before_and_after(const Study&);

}  // namespace apc::learning
