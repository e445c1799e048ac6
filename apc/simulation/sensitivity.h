/// How results move with a parameter: forward sensitivities carried along the run by CVODES, right across events.
///
///   ds/dt = (∂f/∂y) s + ∂f/∂p          exact Jacobian; ∂f/∂p by a central difference of the plant alone
///   entry of a row with a jump at t_r:   s⁺ = s⁻ + (f⁻ − f⁺) dt_r/dp,   dt_r/dp = −(dx_row/dp)/ẋ_row
///   stop at t_s:                         dX/dp = X_y s + Ẋ dt_s/dp, whose second term vanishes with the speed
///   peaks, inside and at corners:        carried_peak.h;   works: carried_works.h
/// Ruts move along: the log a trailing row reads is carried for p ± ε as well.
/// Source: W. F. Feehery, J. E. Tolsma, P. I. Barton, Appl. Numer. Math. 25 (1997) 41–54, for the staggered method.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apc/simulation/simulate.h"

namespace apc::simulation {

/// Any scalar the model or the overrun holds: `shift` adds an amount to it.
struct ScalarParameter {
  std::string name, unit;
  double step = 1e-5;  ///< of the central difference ∂f/∂p, in the parameter's unit
  double scale = 1.0;  ///< its usual size: errors of derivatives are weighed per change of this much
  std::function<void(Model&, Overrun&, double amount)> shift;
};

namespace parameters {
ScalarParameter entry_speed(), mass(), cg_behind_nose_gear(), pitch_inertia(), braking(), thrust(), headwind();
ScalarParameter bed_depth();     ///< factor on every depth
ScalarParameter bed_strength();  ///< factor on the crush strength
ScalarParameter grade();
/// All of the above.
std::vector<ScalarParameter> all();
}  // namespace parameters

/// Derivatives of a result's scalars (result.h) by one parameter, in SI per unit of the parameter.
struct Sensitivity {
  std::string parameter;
  Outcome outcome = Outcome::stopped;  ///< stopped or left_bed
  double stop_distance = 0.0;          ///< m; NaN when it left the bed
  double exit_speed = 0.0;             ///< m/s; 0 when it stopped
  double peak_deceleration = 0.0;      ///< m/s²
  struct Gear {
    std::string name;
    double peak_drag = 0.0, peak_vertical = 0.0, mean_drag = 0.0;  ///< N per strut
    double drag_margin = 0.0, ultimate_margin = 0.0, vertical_margin = 0.0;
    double peak_stroke = 0.0, peak_rut = 0.0, peak_penetration = 0.0;  ///< m
    double peak_tire_load = 0.0;                                       ///< N
  };
  std::vector<Gear> gears;
  double stop_time = 0.0;                                         ///< s
  double peak_deceleration_100ms = 0.0, mean_deceleration = 0.0;  ///< m/s²
  double peak_pitch = 0.0, lowest_pitch = 0.0;                    ///< rad
  std::map<std::string, double> energy;                           ///< J by sink and store; no "residual"
  SolverStatistics solver;
};

/// Always by the reference method; `options.rtol` and `time_limit` hold. SolveError as simulate.
Sensitivity sensitivity(const Model&, const Overrun&, const ScalarParameter&, const Options& = {});

}  // namespace apc::simulation
