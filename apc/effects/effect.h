/// A physical effect that may be missing from the model: an id, a law with its source, parameters with units and prior
/// ranges, and up to four places where it acts. Every effect is neutral when its first parameter (the amplitude) has
/// its neutral value: the model is then the same, bit for bit.
///
/// Order in which effects act on one tire:
///   1. `bed`     factors on crush strength, tire stiffness and usable depth, multiplied over all effects; the balance
///                of tire and foam is solved again with them (balance.h)
///   2. `force`   increments of drag and vertical load, added over all effects, with the load of step 1 known
/// and on the run: `site` changes aircraft and bed before the run starts; `thrust` adds a force along the runway.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "aircraft/aircraft.h"
#include "apc/base/quantity.h"
#include "apc/bed/bed.h"

namespace apc::effects {

/// What is known about one tire when an effect acts. SI.
struct TireState {
  double bed_distance = 0.0;   ///< of this wheel from the leading edge
  double nose_distance = 0.0;  ///< of the nose wheel
  double time = 0.0;           ///< since the nose wheel crossed the leading edge
  double speed = 0.0, bed_depth = 0.0, penetration = 0.0;
  double vertical = 0.0;  ///< load of the altered bed; only known to `force` laws
  double tire_width = 0.0, tire_radius = 0.0;
  double density = 0.0;         ///< nominal, of the bed
  double years = 0.0;           ///< age of the bed at the run
  double temperature = 293.15;  ///< K
  bool nose = false;
  int wheels = 2;  ///< in the gear group
};

/// What effects may change of one tire; the defaults change nothing.
struct TireChange {
  double strength = 1.0;              ///< × crush stress below lock-up
  double depth = 1.0;                 ///< × depth of crushable material the lock-up refers to
  double tire_pressure = 1.0;         ///< × contact pressure at a given deflection, of one tire of the group
  double drag = 0.0, vertical = 0.0;  ///< N per tire, added
};

/// What an effect may change before the run.
struct Site {
  aircraft::Aircraft& aircraft;
  bed::Bed& bed;
  double mass = 0.0, cg_behind_nose_gear = 0.0;  ///< of this run
  double headwind = 0.0;                         ///< m/s, added to the run's
};

using Values = std::span<const double>;

struct Parameter {
  std::string name, unit;
  Dimension dimension;
  double low = 0.0, high = 1.0;  ///< prior range, SI; low < neutral means the sign is free
  double usual = 0.0;            ///< taken when nobody says otherwise
  double neutral = 0.0;          ///< amplitudes only: the value that changes nothing
};

struct Effect {
  std::string id, title, law, source;
  std::string touches, confused_with;  ///< which signals move; the usual mimics
  std::string form;                    ///< of a law other than the catalogue's for the same id; empty: the catalogue's
  std::vector<Parameter> parameters;   ///< the first is the amplitude
  /// Shapes worth trying, values of the parameters after the amplitude; empty: over the range of the second one.
  std::vector<std::vector<double>> shapes;
  std::function<void(const TireState&, Values, TireChange&)> bed, force;
  std::function<void(Site&, Values)> site;
  std::function<double(double time, Values)> thrust;  ///< N forward; `time` after entry, negative before
  bool own = false;                                   ///< written by the user
  bool fine = false;  ///< acts on places finer than the measured way is known: found and fitted run by run
};

/// An effect with its parameter values, SI, in the order of `Effect::parameters`.
struct Applied {
  Effect effect;
  std::vector<double> values;
};

/// The effect with its usual shape and the given amplitude.
Applied applied(const Effect&, double amplitude);

/// 0 on the pavement, 1 where there is more than 20 mm of bed; C¹. Keeps in-bed laws off the runway.
inline double in_bed(double bed_depth) {
  const double u = bed_depth / 0.02;
  return u <= 0.0 ? 0.0 : u >= 1.0 ? 1.0 : u * u * (3.0 - 2.0 * u);
}

}  // namespace apc::effects
