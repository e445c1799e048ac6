/// What came out of one overrun: outcome, histories, extremes, energy, table coverage, solver statistics.
/// A value; reports only read it. SI throughout.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace apc::simulation {

enum class Outcome {
  stopped,       ///< came to rest in the bed (or before it)
  left_bed,      ///< the nose wheel passed the far end of the bed still moving
  gear_limit,    ///< stopped or not, but drag or vertical load of a gear passed its ultimate: taken as failed there
  pitched_over,  ///< the pitch passed `overturning_pitch` (overrun_run.h); the run ends there, still moving
};
const char* text(Outcome);

/// One gear group ("nose", "main"): forces per strut, as certification limits are.
struct GearSummary {
  std::string name;
  int struts = 1, wheels = 2;                                ///< wheels per strut
  double peak_drag = 0.0, peak_drag_distance = 0.0;          ///< N per strut; nose-wheel bed distance where it occurs
  double peak_vertical = 0.0, peak_vertical_distance = 0.0;  ///< N per strut
  double mean_drag = 0.0;                                    ///< N per strut, mean over distance in the bed
  double drag_limit = 0.0, drag_ultimate = 0.0;              ///< N per strut; 0 = no limit known
  double vertical_limit = 0.0, vertical_ultimate = 0.0;
  std::string drag_rule, vertical_rule;  ///< "14 CFR 25.509 from ramp weight", "aircraft file"
  double drag_margin = 0.0, ultimate_margin = 0.0, vertical_margin = 0.0;  ///< limit/peak − 1
  double peak_stroke = 0.0, stroke = 0.0;                                  ///< m; stroke = available
  bool bottomed = false;                                                   ///< the strut reached its stop
  /// "drag" or "vertical": the load that passed its ultimate first; empty when the gear held.
  std::string failed_by;
  double failed_at = std::numeric_limits<double>::quiet_NaN();    ///< m: the nose wheel then; NaN when the gear held
  double failed_time = std::numeric_limits<double>::quiet_NaN();  ///< s after entry
  double airborne = 0.0;                                          ///< s after entry with all its tires off the ground
  double lifted_at = std::numeric_limits<double>::quiet_NaN();    ///< m: the nose wheel when it first lifted off
  std::string tire;
  double peak_tire_load = 0.0, tire_bottoming_load = 0.0;  ///< N on one tire
  bool tire_bottomed = false;                              ///< one carried more than its bottoming load
  double peak_rut = 0.0, peak_penetration = 0.0;           ///< m
  double static_vertical = 0.0;                            ///< N per strut, at rest
};

/// Share of the time in the bed during which the contacts of a gear's tires, all rows of them, lay inside the table's
/// fitted range.
struct CoverageSummary {
  std::string gear, tire;
  double inside = 1.0, speed_below = 0.0, speed_above = 0.0, depth_outside = 0.0,
         penetration_outside = 0.0;  ///< shares of time
};

/// One row per sample, all columns of equal length. Gear columns are indexed like `gears`.
struct History {
  struct Gear {
    std::vector<double> drag, vertical;       ///< N, whole gear group (all struts): tire forces on the axles
    std::vector<double> stroke, stroke_rate;  ///< m, m/s, mean over the group's struts
    std::vector<double> penetration, rut, bed_depth, spin;  ///< leading row of the group; m, m, m, rad/s
    std::vector<double> distance;                           ///< bed distance of the leading row, m
  };
  std::vector<double> time;          ///< s, 0 when the nose wheel crosses the leading edge
  std::vector<double> distance;      ///< m, nose wheel from the bed's leading edge (negative before it)
  std::vector<double> speed;         ///< m/s, ground speed of the centre of gravity
  std::vector<double> deceleration;  ///< m/s², −x″ of the centre of gravity
  std::vector<double> acceleration_x, acceleration_z;  ///< m/s², what body-fixed accelerometers read at the CG
  std::vector<double> pitch, pitch_rate, heave;        ///< rad (nose up, 0 static), rad/s, m (CG height − static)
  std::vector<Gear> gears;
  std::vector<double> dissipated;  ///< J, all sinks so far
};

struct SolverStatistics {
  std::string method;  ///< "CVODE BDF" or "RODAS4"
  long steps = 0, rhs_calls = 0, jacobians = 0, error_test_failures = 0, newton_failures = 0;
  double wall_s = 0.0, rtol = 0.0;
};

struct Result {
  Outcome outcome = Outcome::stopped;
  std::string message;       ///< one sentence: what happened, where
  double entry_speed = 0.0;  ///< m/s, nose wheel at the leading edge
  double stop_distance =
      0.0;  ///< m, nose wheel from the leading edge at rest; NaN when it left the bed or pitched over
  double runway_distance = 0.0;                                 ///< m, from the pavement end
  double exit_speed = 0.0;                                      ///< m/s when it left the bed or pitched over, else 0
  double stop_time = 0.0;                                       ///< s after entry
  double peak_deceleration = 0.0, mean_deceleration = 0.0;      ///< m/s²; mean = v²/(2 · distance in the bed)
  double peak_deceleration_100ms = 0.0;                         ///< largest mean over 0.1 s
  double peak_pitch = 0.0, lowest_pitch = 0.0;                  ///< rad
  double airborne = 0.0;                                        ///< s after entry with no tire on the ground
  double lifted_at = std::numeric_limits<double>::quiet_NaN();  ///< m: the nose wheel when all had first lifted off
  std::vector<GearSummary> gears;
  /// Whether a gear failed: what comes after is what would happen if it had held.
  bool gear_failed() const {
    for (const auto& gear : gears)
      if (!gear.failed_by.empty()) return true;
    return false;
  }
  std::vector<CoverageSummary> coverage;
  /// J by sink and store: kinetic, potential, bed, tires, oleo_gas, oleo_damping, strut_friction, stops, brakes, aero,
  /// thrust, … ; "residual" is |balance| relative to the entry's kinetic energy.
  std::map<std::string, double> energy;
  double mass = 0.0, cg_behind_nose_gear = 0.0;  ///< as simulated
  std::vector<std::string> warnings;             ///< first lines of every report: table left, strut bottomed, …
  SolverStatistics solver;
  History history;  ///< empty when Options::sampling is 0
};

}  // namespace apc::simulation
