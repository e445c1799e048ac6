/// What a gear is certified to carry, from weights, unless the aircraft file says so itself. Per strut, N.
///
///   nose drag      14 CFR 25.509: tow load F_TOW = 0.3 W (W < 30,000 lb), (6 W + 450,000)/70 (to 100,000 lb),
///                  0.15 W above, W the design ramp weight; the criterion of ACRP Report 29
///   main drag      14 CFR 25.493(b): 0.8 × vertical at each braked wheel, n_z 1.2 at the design landing weight or 1.0
///                  at the ramp weight; an unbraked main gear: 0.75 F_TOW (25.509)
///   nose vertical  the larger of 14 CFR 25.493(e), sudden braking with μ = 0.8 and dynamic factor 2 at the design
///                  take-off weight W (25.493(d)),
///                    V = W/(A + B) [B + f μ A E/(A + B + μ E)],  A, B from the cg to nose and main gear, E its height
///                  (recalled, unverified), and 25.499(b), 0.8 × one main gear's load acting forward at the cg, at the
///                  ramp weight (25.489)
///   main vertical  14 CFR 25.493(b), the vertical reaction itself
///   ultimate       1.5 × limit (14 CFR 25.303)
#pragma once

#include <string>

#include "aircraft/aircraft.h"

namespace apc::aircraft {

struct LoadLimits {
  double drag_limit = 0.0, drag_ultimate = 0.0, vertical_limit = 0.0;  ///< N per strut
  std::string drag_rule, vertical_rule;                                ///< "14 CFR 25.509 from the ramp weight"
};

/// 25.509 for the whole aircraft; weight and load in N.
double tow_load(double ramp_weight);
LoadLimits load_limits(const Aircraft&, const Gear&);

}  // namespace apc::aircraft
