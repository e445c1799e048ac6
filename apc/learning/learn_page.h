/// One self-contained HTML page of a study: verdict, ranked explanations, measured against model per run, the misfit
/// along the bed, what cannot be told apart.
#pragma once

#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

std::string learn_page(const Study&);

}  // namespace apc::learning
