/// The free form of a bed's depth: a straight ramp from 0 to the first node, then straight lines through nodes at even
/// distances; the last depth continues to the end.
///
///   station_j = ramp + j (reference − ramp)/m,  j = 0 … m − 1
///
/// `reference` is a fixed length (that of the best bed of one depth), so that a node keeps its place while the bed's
/// length is still being looked for.
#pragma once

#include "apc/design/fleet.h"

namespace apc::design {

struct Profile {
  double ramp = 0.0, reference = 0.0;  ///< m
  std::vector<double> depth;           ///< m, at the nodes
  std::vector<double> stations() const;
  double depth_at(double distance) const;
  /// m²: depth integrated from the leading edge to `length`.
  double section(double length) const;
};

/// Edges of the windows in which loads are watched: every piece of the profile in as many equal parts as make them at
/// most `width` wide, by a number that depends on the space of beds and the reference length alone.
std::vector<double> window_edges(const Profile&, double width);

/// The bed of this profile cut at `length`.
bed::Bed bed_of(const BedSpace&, const Profile&, double length);

/// Slopes as shares of the allowed one: of the ramp, then of each piece behind it, falling slopes as positive numbers.
std::vector<double> slope_use(const BedSpace&, const Profile&);

}  // namespace apc::design
