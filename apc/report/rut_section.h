/// Drawing of the section that a wheel left in the foam.
#pragma once

#include <string>

#include "apc/report/rolling_record.h"

namespace apc::report {

/// Particles of one slice seen along the runway, both halves, to scale: every particle as high as it still is, the
/// darker the more compacted; beside them the original surface, the ideal floor and what the undeformed wheel would
/// leave. Empty without particles.
std::string rut_section(const RollingRecord&);

}  // namespace apc::report
