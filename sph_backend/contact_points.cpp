#include "sph_backend/contact_points.h"

#include "sph_backend/foam_bed.h"

namespace apc::sph {

ContactPoints contact_points(const Bed& bed) {
  const Particles& p = bed.particles;
  ContactPoints points;
  points.count = p.size();
  points.x = p.x.data(), points.y = p.y.data(), points.z = p.z.data();
  points.vx = p.vx.data(), points.vy = p.vy.data(), points.vz = p.vz.data();
  points.id = p.id.data(), points.stretch = p.stretch.data();
  points.reach = 0.5 * bed.layer;
  points.stiffness = 2.0 * bed.spec.foam.youngs_modulus * bed.spec.spacing;
  points.mass = bed.mass, points.dt = bed.dt;
  points.team = bed.team.get();
  return points;
}

}  // namespace apc::sph
