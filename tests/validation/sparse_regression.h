/// The weakest way to name a force: differentiate the speed record, take the model's deceleration off, and regress what
/// is lacking on the catalogue's forces (sequentially thresholded least squares; Brunton, Proctor and Kutz 2016).
#pragma once

#include <utility>
#include <vector>

#include "apc/learning/background.h"

namespace scoring {

/// At most two effects, fixed probability 0.9; empty where nothing is left. `traces`: nominal free runs.
std::vector<std::pair<apc::effects::Applied, double>> sparse_regression(const apc::learning::Background&);

}  // namespace scoring
