/// The balance of forces along the measured motion as pictures of the learning page.
#pragma once

#include <string>

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// HTML: a map of missing force, run by distance, and per run the measured deceleration at every place beside what the
/// tables say at the loads carried, without and with the effects the diagnosis would add. Empty where runs were not
/// weighed this way.
std::string along_charts(const Study&);

}  // namespace apc::learning
