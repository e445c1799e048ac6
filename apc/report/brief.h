/// The short report of one overrun for a terminal: warnings first, then outcome, margins, energy, coverage, solver,
/// inputs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apc/report/record.h"
#include "apc/report/unit_system.h"

namespace apc::report {

std::string brief(const OverrunRecord&, UnitSystem);

/// One sentence: "B737-800 leaves the runway at 70.0 kt into "demo bed"".
std::string headline(const OverrunRecord&, UnitSystem);

/// What the model holds beyond the steady tables, one sentence each: learned effects, the response to sinking.
std::vector<std::string> additions(const OverrunRecord&);

/// What a key of Result::energy means to a reader: "oleo_damping" → "strut damping".
std::string energy_name(const std::string& key);

/// The entry's energy of motion, J; the denominator of every share.
double entry_energy(const simulation::Result&);

/// Where the entry's energy went, largest first; terms below a millionth are left out.
std::vector<std::pair<std::string, double>> energy_sinks(const simulation::Result&);

/// Coverage in words: "97 % of the time inside; speed below the range 3 %".
std::string coverage_text(const simulation::CoverageSummary&);

}  // namespace apc::report
