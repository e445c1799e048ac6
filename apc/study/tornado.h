/// Which input matters: each one moved down and up by its own uncertainty, all others held, and what that does to the
/// stop distance and to the worst margin.
#pragma once

#include "apc/study/sweep.h"

namespace apc::study {

struct TornadoBar {
  std::string input;                               ///< "exit speed", "mass", …
  std::string low, high;                           ///< what was set, in words: "−5 %"
  double distance_low = 0.0, distance_high = 0.0;  ///< m: stop distance at either end
  double margin_low = 0.0, margin_high = 0.0;      ///< worst margin, limit criterion
  double reach = 0.0;                              ///< m, largest move of the stop distance from the centre
};

struct Tornado {
  std::string aircraft, bed;
  double distance = 0.0, margin = 0.0, entry_speed = 0.0;  ///< of the centre
  std::vector<TornadoBar> bars;                            ///< longest first
};

/// Half widths of the inputs: exit speed 5 kt, mass 5 %, centre of gravity 1 % of the wheelbase, pitch inertia 25 %,
/// braking 0.1 (never below 0), headwind 10 kt, bed strength 10 %, bed depth 5 %. The bed is continued at its last
/// depth so that every case stops.
Tornado tornado(const simulation::Model&, const simulation::Overrun&, const Solve&, Store&, const SweepOptions& = {});

}  // namespace apc::study
