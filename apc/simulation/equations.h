/// The planar equations of motion, exact in pitch: a sprung body, struts sliding on it (with rake), unsprung masses at
/// their lower ends, bogie beams on those, wheels on the beams. Loads act at the axles.
///
/// With e the strut axis (up), n = e^⊥, ρ the axle from S, F the tires' force, P = F + m g − m (2 θ′s′e^⊥ − θ′²ρ):
///   strut      s″ = (e·P − S)/m − e·(a + θ″ ρ^⊥)
///   body       m_s a + Σ m n (n·(a + θ″ρ^⊥)) = F_aero + F_thrust + m_s g + Σ [S e + (n·P) n]
///              I θ″ + Σ m (ρ^⊥·n)(n·(a + θ″ρ^⊥)) = M + Σ [ρ^⊥·(S e + (n·P) n) + T]
///   bogie      J φ″ = Σ r_i × F_i − c (φ′ − θ′);   T = c (φ′ − θ′) − T_b: brake rods lead the brakes' torque past the
///              beam to the strut; without them −T_b stands in the beam's row instead
///   wheel      I ω′ = F_slip R_r − T_b;             R_r = R / spin ratio, the table's free rolling radius
/// a symmetric 3 × 3 solve whatever the number of struts. The tread's force reaches the airframe through the axle; its
/// moment about the axle goes to the spin, so that only brake torque comes back as a moment.
#pragma once

#include <array>
#include <vector>

#include "apc/simulation/plant.h"

namespace apc::simulation {

/// What changes between solver restarts: which rows are in the bed, and the ruts behind the rows.
struct Surroundings {
  std::array<bool, most_rows> in_bed{};
  std::vector<RutLog> ruts;  ///< per row; only rows that are followed are written
};

/// One row of wheels at an instant, forces of all its tires.
struct RowMoment {
  double distance = 0.0, speed = 0.0, penetration = 0.0, bed_depth = 0.0;
  GroundLoad ground;                        ///< per tire
  double force_x = 0.0, force_z = 0.0;      ///< N on the axle, all tires, brake and slip included
  double contact_x = 0.0, contact_z = 0.0;  ///< the ground's part of it: drag and vertical load
  double brake_force = 0.0, brake_torque = 0.0, slip_force = 0.0;
  double roll_radius = 0.0, spin = 0.0;
  Vector velocity, tangent;  ///< of the axle; unit vector along the base
};

struct GroupMoment {
  double stroke = 0.0, stroke_rate = 0.0;
  double gas = 0.0, orifice = 0.0, friction = 0.0, stop = 0.0;  ///< N per strut
  Vector axle, axle_velocity;                                   ///< pivot
};

/// Everything about an instant, for observers.
struct Moment {
  std::array<RowMoment, most_rows> rows;
  std::array<GroupMoment, most_groups> groups;
  Vector cg_position, cg_velocity, cg_acceleration;  ///< of the static centre of gravity
  Vector aero, thrust;                               ///< N, ground axes
  double aero_moment = 0.0;                          ///< N m about S, force included
  double thrust_moment = 0.0;
};

/// dy/dt; `moment` (may be null) receives the details.
void derivatives(const Plant&, const Surroundings&, double time, const double* y, double* dydt,
                 Moment* moment = nullptr);

/// ∂(dy/dt)/∂y, row-major states × states, and dy/dt itself. Exact up to the ground's altered loads (differences).
void jacobian(const Plant&, const Surroundings&, double time, const double* y, double* dydt, double* matrix,
              Moment* moment = nullptr);

/// Directional derivative of dy/dt along `direction`.
void directional(const Plant&, const Surroundings&, double time, const double* y, const double* direction,
                 double* result);

/// Where the tires of one row are, as the ground is asked about it.
effects::TirePlace row_place(const Plant&, const Surroundings&, int row, double time, const double* y);

/// Bed distance of the nose row's axle.
double nose_distance(const Plant&, const double* y);
/// Distance and forward speed of any row's axle.
std::array<double, 2> row_motion(const Plant&, int row, const double* y);

}  // namespace apc::simulation
