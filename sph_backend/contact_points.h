/// What a tool may touch: particles of the foam, which have a contact radius that shrinks as they are compacted, or
/// nodes on the surface of a mesh, which have none. Plain pointers into the owner's arrays, valid for one step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace apc::sph {

struct Bed;
class Team;

struct ContactPoints {
  std::size_t count = 0;                 ///< of `which`, or of all points
  const std::uint32_t* which = nullptr;  ///< numbers of the points to look at; null = 0 … count − 1
  const double *x = nullptr, *y = nullptr, *z = nullptr;     ///< m
  const double *vx = nullptr, *vy = nullptr, *vz = nullptr;  ///< m/s
  const std::int32_t* id = nullptr;                          ///< negative: no point there; null = all are
  const float* stretch = nullptr;                            ///< (ρ/ρ0)^⅓; null: no radius
  double reach = 0.0;                                        ///< radius of an intact point, ½ layer
  double stiffness = 0.0;                                    ///< penalty k of one point, N/m
  double mass = 0.0;                                         ///< of one point, kg (the lightest, if they differ)
  double dt = 0.0;                                           ///< s
  Team* team = nullptr;                                      ///< looks through the points; null: the caller alone

  /// r_c = reach · min(ρ0/ρ, 1), with the stretches of this or of the last step: what a torn particle has swollen by is
  /// void and touches nothing.
  double radius(const float* stretches, std::size_t i) const {
    if (stretches == nullptr) return 0.0;
    const double s = std::max(1.0, static_cast<double>(stretches[i]));
    return reach / (s * s * s);
  }
};

/// All particles of a bed: radius ½ layer · ρ0/ρ, k = 2 E · spacing.
ContactPoints contact_points(const Bed&);

}  // namespace apc::sph
