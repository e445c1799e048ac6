/// Where to make further runs: far from the runs there are, and where leaving a run out costs most. Each new run
/// maximises (distance to the nearest run) × (error of leaving out its neighbours), and counts as a run for the next
/// one. Places whose nearest run was refused are not tried again.
#pragma once

#include <vector>

#include "loadtables/campaign.h"

namespace apc::loadtables {

/// `count` runs that continue the plan's numbering. InputError when fewer than 12 runs are finished and steady.
std::vector<PlannedRun> further_runs(const Plan&, const std::vector<RunStatus>&, int count);

}  // namespace apc::loadtables
