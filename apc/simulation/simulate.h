/// One overrun: `simulate(model, overrun, options)`. What exists (Model), what happens (Overrun), how it is solved and
/// observed (Options) stay apart; all three are const, the Result is a value.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aircraft/aircraft.h"
#include "apc/bed/bed.h"
#include "apc/effects/alterations.h"
#include "apc/simulation/result.h"
#include "loadtables/load_table.h"

namespace apc::simulation {

/// Everything that exists, checked for consistency by make_model.
struct Model {
  aircraft::Aircraft aircraft;
  bed::Bed bed;
  std::vector<loadtables::LoadTable> tables;  ///< one per gear group, in the aircraft's order
};

/// Pairs every gear's tire with its table by name. InputError when a table is missing.
Model make_model(aircraft::Aircraft, bed::Bed, const std::vector<loadtables::LoadTable>&);

/// How brakes act on the braked wheels.
enum class BrakeMode {
  friction,  ///< retarding force `braking` × vertical load, independent of the wheel's slip
  torque,    ///< brake torque `braking` × vertical load × rolling radius; the force follows from the wheel's slip
};

/// Whether the wheels' own rotation takes part in the motion.
enum class WheelSpin {
  inertial,  ///< the tread must spin the wheel up and down: Σ I/R² adds to the mass
  free,      ///< wheels follow the table's spin ratio without effort
};

/// How trailing rows of a bogie use the rut ahead of them (see tire_bed.h); estimated, no public data.
struct RutFollowing {
  double bearing_gain = 2.0;         ///< yield load on an old rut floor over the one in virgin material
  double rolling_resistance = 0.02;  ///< drag / vertical on the floor of a rut
};

/// How the bed answers a tire that sinks or rises as it rolls, beyond the steady table: on a path inclined by α (down
/// positive) against the base, vertical × (1 + `vertical` · α/sin θ) and drag + `drag` · α · vertical, with
/// sin θ = √(2RP − P²)/R at the front end of the contact. A rigid wheel in foam of constant pressure gives 1 and 0: the
/// arc in contact grows by α behind the lowest point, where pressure acts straight up. SPH of flexible
/// tires gives 1.5 to 1.9 and 0.2 to 0.5. Off by default until it is tabulated per tire.
struct Sinking {
  double vertical = 0.0, drag = 0.0;
  bool counts() const { return vertical != 0.0 || drag != 0.0; }
};

inline constexpr double creep_speed = 0.05;  ///< m/s: drag fades with tanh(u / creep_speed); a stop is called here

/// What happens. Defaults are ACRP Report 29's assumptions except braking, which is off unless asked for.
struct Overrun {
  double entry_speed = 0.0;          ///< m/s, when the nose wheel crosses the bed's leading edge
  double mass = 0.0;                 ///< kg; 0 = the aircraft file's
  double cg_behind_nose_gear = 0.0;  ///< m; 0 = the aircraft file's
  double pitch_inertia = 0.0;        ///< kg m²; 0 = the file's, scaled with mass
  double braking = 0.0;              ///< friction coefficient on the braked wheels' vertical load, before the bed
  double braking_in_bed = -1.0;      ///< same inside the bed; < 0 = as before the bed
  double thrust = 0.0;               ///< N, net, forward positive (reverse negative)
  double headwind = 0.0;             ///< m/s
  BrakeMode brake_mode = BrakeMode::friction;
  WheelSpin wheel_spin = WheelSpin::inertial;
  RutFollowing rut_following;
  Sinking sinking;
  double bed_depth = 1.0;            ///< × the bed file's depth
  effects::Alterations alterations;  ///< effects, block strengths, table errors; nothing by default
};

enum class Method {
  reference,  ///< CVODE BDF, dense Newton
  fast,       ///< fixed-size Rosenbrock; same results within 1 mm
};

/// Looser, stops are off by centimetres and more.
inline constexpr double loosest_rtol = 1e-4;

struct Options {
  Method method = Method::reference;
  double rtol = 1e-6;
  double sampling = 0.005;    ///< s between history rows; 0 = no history
  double time_limit = 600.0;  ///< s of motion; reaching it is a SolveError
};

/// Throws SolveError (time, state, what to try) when trim or integration fails; physical outcomes are results.
Result simulate(const Model&, const Overrun&, const Options& = {});

}  // namespace apc::simulation
