/// Shape of the furrow that a wheel leaves, from particles of a slice across it.
///
///   surface h(y): in strips one spacing wide, the highest place that is reached from the rigid plane upwards without a
///   gap of more than a spacing; fragments in flight do not count, a heap does
///   floor   median of h within half the wheel's half-width
///   wall    smallest y where h passes half-way from the floor to the original surface
///   width   from where h passes 10 % of that way to where it passes 90 %; a step in strips of d shows as 0.8 d
///   flank   half-width of the undeformed wheel at the height of the wall's place: what an ideal cut would leave
///   berm    highest h beyond the wall, above the original surface
/// The ideal floor is bed depth − penetration; what the tire gives way (its deflection) and the foam's rebound lie
/// above it. Between the centres of strips h is taken as linear.
#pragma once

#include <vector>

#include "sph_backend/tire_shape.h"

namespace apc::sph {

/// Extent of one particle in a slice: place across (or along) and the heights it fills, m above the rigid plane.
struct Grain {
  double place, bottom, top;
};

/// Heights over strips of equal width, the first one beginning at `start`.
struct Surface {
  double start = 0.0, strip = 0.0;
  std::vector<double> height;
  double centre(std::size_t k) const { return start + (static_cast<double>(k) + 0.5) * strip; }
};
Surface surface_of(std::vector<Grain>, double start, double end, double strip);

/// The wheel that made the furrow.
struct FurrowWheel {
  Section outline;
  double axle_height = 0.0;  ///< m above the rigid plane
  /// Half-width of what has passed at a height: the widest section below the axle sweeps all above it.
  double flank(double height) const;
};

/// All in m; NaN where there is nothing to measure.
struct RutShape {
  double behind = 0.0;       ///< of the axle: where the slice lies
  double floor = 0.0;        ///< above the rigid plane
  double floor_ideal = 0.0;  ///< bed depth − penetration
  double wall = 0.0;         ///< from the wheel's plane
  double flank = 0.0;
  double wall_width = 0.0;
  double flank_width = 0.0;  ///< the same of the ideal cut: the wheel is round
  double berm = 0.0;         ///< above the original surface
  double bow_wave = 0.0;     ///< highest surface ahead of the axle in the wheel's way, above the original one
};
/// Leaves `behind` and `bow_wave` to the caller.
RutShape rut_shape(const Surface& across, const FurrowWheel&, double bed_depth, double penetration);

/// One line of a report.
struct ShapeLine {
  const char* key;
  const char* name;
  double value;
};
std::vector<ShapeLine> lines_of(const RutShape&);

}  // namespace apc::sph
