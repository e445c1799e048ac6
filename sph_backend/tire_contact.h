/// Contact of foam with the deformed surface of a spinning tire.
///
/// The foam side is points: particles with a radius, or the surface nodes of a mesh, whose radius is zero.
///   gap g = distance of the particle from the section deflected by u(φ, y);  overlap δ = r_c − g, r_c = ½ layer ρ0/ρ
///   normal force N = k δ − c ġ ≥ 0 along ∇g, which contains the slopes of u: the force is the exact gradient of ½ k δ²
///   c = 2 ζ √(k m), m of the particle and the tread in series
///   friction −μ N v_t/max(|v_t|, v_slip) on the relative tangential velocity, spin included
/// The reaction on the tire does work on the axle (F·v), on the spin (r F_α ω) and on the nodes (n_r N, friction's
/// radial part); the same weights interpolate u and spread the reaction, so no energy is made or lost in between. The
/// contact radius shrinks as the particle is compacted; what that releases is booked as radius work.
#pragma once

#include <vector>

#include "sph_backend/contact_points.h"
#include "sph_backend/tire.h"

namespace apc::sph {

struct ContactLaw {
  double damping_ratio = 0.1;  ///< ζ
  double friction = 0.3;       ///< Coulomb coefficient of tire on foam
  double slip_speed = 0.0;     ///< v_slip, m/s: below it friction is viscous
};

struct AxleState {
  double x = 0.0, z = 0.0, vx = 0.0, vz = 0.0;
};

/// One particle in contact in this step.
struct Touch {
  std::uint32_t particle;
  double force[3];  ///< on the particle, N
  double overlap;   ///< δ
  double elastic;   ///< k δ
  double damping;   ///< −c ġ as applied
  double gap_rate;  ///< ġ with the velocities before the kick
  double friction[3];
  double gradient[3];    ///< ∇g in x, y, z
  double e_radial[2];    ///< outward radial direction in x, z
  double radius;         ///< r
  double normal_radial;  ///< ∂g/∂u
  std::size_t nodes[4];
  double weights[4];
};

struct ContactResult {
  double force_x = 0.0, force_z = 0.0;  ///< of the foam on the half tire, N
  double torque = 0.0;                  ///< about the axle, spinning up positive
  std::vector<Touch> touches;
  std::vector<std::vector<Touch>> parts;  ///< of `touches`, as several threads found them
};

/// Finds the contacts and adds to tire.force; the caller puts the touches' forces on the foam.
void find_contact(const ContactPoints&, Tire&, const AxleState&, const ContactLaw&, ContactResult&);

/// Longest step that a node of the tread bears under the penalty springs of four points at once, more than were seen:
///   Δt = (√(1 + ζ²) − ζ)/ω,  ω² = k (1/m_point + 1/m_node)
/// half of what one point allows. Beyond, the tread shakes by itself and makes energy out of nothing: particles that
/// are coarse beside the tire are heavier than its nodes.
double longest_step(const ContactPoints&, const Tire&, const ContactLaw&);

struct ContactWork {
  double on_axle = 0.0;  ///< work of the axle against the foam in this step
  double penalty = 0.0;  ///< stored now
  double damping = 0.0, friction = 0.0, radius = 0.0;
};
/// Work of one step of length `points.dt`; call after the kick, with the velocities before it in `before` (3 per
/// touch), the stretches of the last step in `stretch_before` (null for points without radius), and the mean spin and
/// node rates of the step.
ContactWork book_contact(const ContactPoints& points, const AxleState&, const ContactResult&,
                         const std::vector<double>& before, const float* stretch_before, double mean_spin,
                         const std::vector<double>& mean_rate);
/// Velocities of the touched points, 3 per touch.
void touched_velocities(const ContactPoints&, const ContactResult&, std::vector<double>& out);

}  // namespace apc::sph
