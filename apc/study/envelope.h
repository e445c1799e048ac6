/// The design envelope: for beds of one depth behind a ramp, how long a bed must be to stop an aircraft at a given exit
/// speed, over depth; and the depth from which on a gear load passes its limit. Its contours of exit speed over
/// depth × length are what a designer reads first.
#pragma once

#include "apc/study/sweep.h"

namespace apc::study {

struct EnvelopeInput {
  simulation::Model model;  ///< aircraft, tables; the bed gives setback, width, material, flush side and grade
  simulation::Overrun overrun;
  double ramp = 15.24;         ///< m from depth 0 to the full depth
  std::vector<double> depths;  ///< m, increasing
  std::vector<double> speeds;  ///< m/s, increasing
};

struct Envelope {
  std::string aircraft;
  std::vector<double> depths, speeds;
  /// stop distance and worst margin (limit criterion) per [speed][depth]; NaN where the solver gave up or the aircraft
  /// did not stop within 2 km
  std::vector<std::vector<double>> stop_distance, margin;
  /// m of depth at which the worst margin becomes 0, per speed; NaN when it does not within the depths
  std::vector<double> limit_depth;
};

/// A bed of constant depth behind a straight ramp, long enough for any stop.
bed::Bed uniform_bed(const bed::Bed& site, double depth, double ramp, double length);

Envelope envelope(const EnvelopeInput&, const Solve&, Store&, const SweepOptions& = {});

}  // namespace apc::study
