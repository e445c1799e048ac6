/// One overrun as one self-contained HTML page: no network, readable on a phone, in the dark and on paper, in field
/// units and SI. Plots are SVG drawn here; a small script adds a hover cross-hair and nothing else depends on it.
#pragma once

#include <string>

#include "apc/report/record.h"

namespace apc::report {

std::string page(const OverrunRecord&);

}  // namespace apc::report
