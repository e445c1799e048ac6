/// Drawings of the bed along the runway: the aircraft at rest to true scale, the section with the ruts at a stated
/// vertical exaggeration, and the wheels at rest to true scale.
#pragma once

#include <string>

#include "apc/report/record.h"

namespace apc::report {

/// Whole bed with aircraft, 1 : 1, and below it the section with exaggerated heights. One SVG.
std::string bed_section(const OverrunRecord&);

/// One <figure> per gear: its wheels where they came to rest, 1 : 1. Empty when the aircraft left the bed.
std::string wheels_at_rest(const OverrunRecord&);

/// A style per gear, the same in every drawing: "nose", "main", "third", "fourth".
std::string gear_look(std::size_t gear);

}  // namespace apc::report
