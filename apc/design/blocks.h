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

/// Rows that cover `length`. A row gets step · ⌊h/step + share⌋ of the depth h at its middle: `share` 0.5 rounds to the
/// nearest step, 0 down. Never less than one step, never outside the space's depths behind the ramp.
Blocks blocks_of(const BedSpace&, const Profile&, double length, double share);

/// The bed these rows make; rows in a line are one piece of the profile.
bed::Bed bed_of(const BedSpace&, const Blocks&);

/// All cases of the fleet in one bed, continued beyond its end at its last depth when `continued`.
enum class End { as_built, continued };
std::vector<simulation::Result> run_fleet(const Problem&, const bed::Bed&, End, const simulation::Options&);

/// What is left of the optimum after building it.
struct Built {
  Blocks blocks;
  bed::Bed bed;
  double share = 0.5;                       ///< rounding that kept every limit
  std::vector<simulation::Result> results;  ///< one per case, by the reference method, with history
  std::vector<Figures> figures;
  double worst_use = 0.0;  ///< largest use of any load limit; ≤ 1 when the limits are kept
  Constraint worst;        ///< the limit it belongs to
};

/// Tries roundings from the nearest step downwards and takes the shortest bed that keeps all limits; when none does,
/// the one that oversteps least. `length` 0: as long as the longest stop needs, in whole rows; otherwise that length.
Built build(const Problem&, const Profile&, double length, double speed_factor);

}  // namespace apc::design
