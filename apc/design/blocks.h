/// From the optimum's smooth depth to what can be built: rows of blocks of one length, each row of one depth, depths in
/// steps. To the tires, whose footprints are about as long as a block, the depth then runs straight from the middle of
/// one row to the middle of the next.
#pragma once

#include "apc/design/evaluator.h"

namespace apc::design {

struct Blocks {
  double row_length = 0.0;    ///< m
  std::vector<double> depth;  ///< m, per row from the leading edge
};

/// A depth h becomes step · ⌊h/step + share⌋: `share` 0.5 rounds to the nearest step, 0 down, 1 up. It may go straight
/// from `near` at the leading edge to `far` at `reach` and beyond.
struct Rounding {
  double near = 0.5, far = 0.5, reach = 1.0;
};

/// Rows that cover `length`, each of the rounded depth at its middle. Never less than one step, never deeper than the
/// space allows.
Blocks blocks_of(const BedSpace&, const Profile&, double length, const Rounding&);

/// The bed these rows make; rows in a line are one piece of the profile.
bed::Bed bed_of(const BedSpace&, const Blocks&);

/// Steepest change of depth from row to row, over the allowed slope and one step of depth, which rounding may add.
double slope_use(const BedSpace&, const Blocks&);

/// What is left of the optimum after building it.
struct Built {
  Blocks blocks;
  bed::Bed bed;
  Rounding rounding;                        ///< that kept every limit
  std::vector<simulation::Result> results;  ///< one per case, by the reference method, with history
  std::vector<Figures> figures;
  double worst_use = 0.0;  ///< largest use of any load limit; ≤ 1 when the limits are kept
  Constraint worst;        ///< the limit it belongs to
};

/// Rounds to the nearest step; where that breaks a limit, tries other roundings and takes the shortest bed that keeps
/// all. Then, unless one depth is asked for, raises rows by a step where that shortens it. When no rounding keeps the
/// limits, takes the one that oversteps least. `length` 0: as long as the longest stop needs, in whole rows; otherwise
/// that length.
Built build(Evaluator&, const Profile&, double length, double speed_factor);

}  // namespace apc::design
