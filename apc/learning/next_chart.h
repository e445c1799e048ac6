/// How far apart explanations would stand, run by run: speed across, mass upward, the number in every field.
#pragma once

#include <string>

#include "apc/learning/next_run.h"

namespace apc::learning {

/// SVG; its text takes the colour `--ink` of the page around it. `set`: which instruments, index in `NextPlan::sets`.
std::string next_map(const NextPlan&, std::size_t set);

/// Map, recommendation and what each explanation would show, as HTML without head or body.
std::string next_section(const NextPlan&);
/// The section as a page of its own.
std::string next_page(const NextPlan&, const std::string& title);

}  // namespace apc::learning
