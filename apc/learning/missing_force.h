/// The force the model lacks, reading by reading, beside everything it may depend on: speed, place, penetration, load,
/// time. Which of these it follows is seen by eye (charts) and by how much of its variance each of them takes.
#pragma once

#include <string>
#include <vector>

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// A tenth of a second of one run. `missing`: longitudinal force the model lacks over the weight, positive where the
/// bed held more than the model; `left`: the same with the effects the diagnosis would add (NaN where not known).
struct MissingForce {
  std::size_t run = 0;
  double time = 0.0, place = 0.0, speed = 0.0;  ///< s, m (nose wheel), m/s
  double penetration = 0.0, vertical = 0.0;     ///< main gear: m; N
  double missing = 0.0, left = 0.0;
};

/// Inside the bed, from the balance along the measured motion where there is one, else from the fitted runs; each run's
/// mean before the bed is taken off (the accelerometer's bias).
std::vector<MissingForce> missing_forces(const Study&);

/// Share of the variance of `missing` that ten classes of one coordinate take, adjusted for their number (ω² ≥ 0).
struct Attribution {
  std::string coordinate;
  double share = 0.0;
};
std::vector<Attribution> attributions(const std::vector<MissingForce>&, double pitch);

/// Length after which joints come back: of the seams found, else of the blocks, m.
double joint_pitch(const Study&);

/// Bars of the attributions; missing force against speed, penetration, place within a joint's pitch, and load. HTML.
std::string missing_force_charts(const Study&);

}  // namespace apc::learning
