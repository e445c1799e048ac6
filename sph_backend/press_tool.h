/// A rigid tool that comes down on foam: a platen as wide as the block, or a punch with a flat face and vertical
/// flanks.
///
///   overlap δ = r_c − distance of the point's centre to the tool (sphere against box, so the edge is round for
///   particles) force k δ − c δ′ ≥ 0 along the distance; k of contact_points.h, c = 2 ζ √(k m), frictionless
/// The contact radius r_c of a particle shrinks with its compaction; what that releases is booked as radius work.
#pragma once

#include <limits>
#include <vector>

#include "sph_backend/contact_points.h"

namespace apc::sph {

struct PressTool {
  double half_width = std::numeric_limits<double>::infinity();  ///< of the face, from the symmetry plane y = 0
  double height = 0.0, speed = 0.0;                             ///< of the face, m; m/s downwards
  double damping_ratio = 0.1;

  struct Touch {
    std::uint32_t point;
    double force_y, force_z;  ///< on the foam, N
    double elastic, damping, gradient_y, gradient_z;
    double before_y, before_z;  ///< velocity before the kick
  };
  std::vector<Touch> touches;
  double force = 0.0;   ///< of the foam on the tool, upwards, N
  double stored = 0.0;  ///< in the contact now, J
  double damped = 0.0, radius_work = 0.0;
};

/// Finds the contacts; the caller puts the touches' forces on the foam.
void find_contact(const ContactPoints&, PressTool&, const float* stretch_before);
/// After the kick: damping work of the step.
void book_contact(const ContactPoints&, PressTool&);

}  // namespace apc::sph
