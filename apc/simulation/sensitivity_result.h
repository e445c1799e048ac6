/// What the end of a run gives its sensitivities: stop, exit, times, means and the energy account.
#pragma once

#include "apc/simulation/carried_works.h"

namespace apc::simulation {

/// State and sensitivity are those at `t`, where the run ended at rest or at the bed's far end. Peaks are left open.
Sensitivity sensitivity_at_end(Neighbours&, bool stopped, double t, const std::vector<double>& y,
                               const std::vector<double>& s, CarriedWorks&);

}  // namespace apc::simulation
