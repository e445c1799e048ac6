/// One self-contained HTML page of a study: verdict, ranked explanations, measured against model per run, the misfit
/// along the bed, what cannot be told apart.
#pragma once

#include <string>

#include "apc/learning/next_run.h"

namespace apc::learning {

/// `next`: the plan of the next run, where there is one.
std::string learn_page(const Study&, const NextPlan* next = nullptr);

}  // namespace apc::learning
