/// Mirror planes: a particle near a frictionless wall or symmetry plane sees the images of its neighbours behind it.
/// An image has its parent's density and normal stresses; position, normal velocity and the shear stresses that belong
/// to the normal change sign.
#pragma once

#include <cstdint>
#include <vector>

#include "sph_backend/team.h"

namespace apc::sph {

struct MirrorPlane {
  int axis;         ///< 0 x, 1 y, 2 z
  double position;  ///< m
  int side;         ///< +1: the foam lies above `position` on the axis, −1: below
};

/// An image: record = parent with coordinate a replaced by sign_a · coordinate + shift_a.
struct Image {
  std::uint32_t parent;
  float sign[3];
  float shift[3];
};

/// Images of `count` records (and of images of earlier planes) within `range` of each plane, in the order of their
/// parents; positions are relative to `origin`. Skips empty lanes.
std::vector<Image> make_images(const std::vector<float>& records, const std::vector<std::int32_t>& ids,
                               std::size_t count, const std::vector<MirrorPlane>&, const double origin[3], float range,
                               Team&);

/// Copies everything but the stress (`motion`) or the stress of the parents into the image records behind `count`.
void refresh_motion(std::vector<float>& records, std::size_t count, const std::vector<Image>&, Team&);
void refresh_stress(std::vector<float>& records, std::size_t count, const std::vector<Image>&, Team&);

}  // namespace apc::sph
