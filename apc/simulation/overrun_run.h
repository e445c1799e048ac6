/// The course of one run, whatever the solver: steps, events at jumps, ruts, observation, energy.
#pragma once

#include "apc/base/units.h"
#include "apc/simulation/energy.h"
#include "apc/simulation/observer.h"

namespace apc::simulation {

enum class End { rest, far_end, pitched_over };

/// The pitch, up or down from the static one, at which a run ends. Turned by 20° about the main wheels the nose of the
/// smallest shipped aircraft (wheelbase 11.4 m) is 3.9 m lower, in the ground: fuselage and foam, which have no law
/// here, met before. What comes so far is falling over, whatever the exact angle.
inline constexpr double overturning_pitch = 20.0 * units::deg;

/// Where and how the motion ended.
struct Ending {
  End end = End::rest;
  double time = 0.0;  ///< s after entry, of the last computed state
  std::vector<double> state;
  double acceleration = 0.0;  ///< m/s² of the cg there
  double unfaded = 0.0;       ///< m/s², deceleration where only fading drag balances the thrust; 0 = not so ended
  std::array<double, sinks> dissipated{};
  SolverStatistics statistics;
};

/// From `state` (nose at the leading edge, t = 0) to rest or out of the bed.
Ending run_reference(const Plant&, const std::vector<double>& state, double rtol, double time_limit, Observer&);
Ending run_fast(const Plant&, const std::vector<double>& state, double rtol, double time_limit, Observer&);

/// Which rows must be told apart by an event when they enter the bed: there the equations jump.
bool enters_with_a_jump(const Plant&, int row);
/// Rows in the bed at entry: the nose, and all rows that enter smoothly.
Surroundings surroundings_at_entry(const Plant&);
/// Writes what the rows that are followed leave behind at an instant; ignored where something was written already.
void write_ruts(const Plant&, Surroundings&, const Moment&);
void write_ruts(const Plant&, Surroundings&, double time, const double* y);
inline constexpr double rut_spacing = 0.2;  ///< m between entries of a rut log, at most
/// Longest way of one step: a trailing row must never outrun the ruts written so far, and no step may jump a ramp.
double longest_way(const Plant&);
/// Whether a piece of the bed is shorter than a step may be: it could lie between two steps and not be felt at all. The
/// reference method then ends its steps at corners, as the fast one always does.
bool has_narrow_pieces(const Plant&);
/// Time until the first row of wheels comes to a corner of its ground, s; infinite when none lies ahead. A step that
/// ends there has no kink within: error estimates do not see what one does to a step.
double time_to_corner(const Plant&, const Moment&);
inline constexpr double at_corner = 0.5e-3;  ///< m from it: there
/// From the last computed state (`creep_speed`, drag faded by tanh) to rest at the unfaded deceleration.
struct Rest {
  double distance = 0.0, time = 0.0;
};
Rest come_to_rest(double deceleration);
/// Absolute tolerances of the reference method for every state.
std::vector<double> absolute_tolerances(const Plant&, double rtol);
/// Thrust against a drag that fades below a few `creep_speed` would roll on for ever where the unfaded drag is larger:
/// the deceleration (> 0, m/s²) with which it really comes to rest. 0 while the speed still falls, or would not.
double held_up_by_fading(const Plant&, const Surroundings&, double time, const double* y, const Moment&);
/// A state in words, for messages: speed, place, pitch, strokes.
std::string in_words(const Plant&, const double* y);
/// The cg's ground speed at a state.
double cg_speed(const Plant&, const double* y);

}  // namespace apc::simulation
