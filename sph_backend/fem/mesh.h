/// A block of foam as a mesh of 8-node hexahedra, and one explicit step of it: the comparator of the particles.
///
///   leapfrog: xⁿ⁺¹ = xⁿ + Δt vⁿ⁺½; strain from the geometry at mid-step, forces from that at tⁿ⁺¹;
///   vⁿ⁺³ᐟ² = vⁿ⁺½ + ½ (Δtₙ + Δtₙ₊₁) f/m, lumped masses
///   Δt = cfl · 2/ω, ω² = 8 c² max b_iI b_iI (Flanagan and Belytschko's bound; ρ and b as they are now)
///   bulk viscosity q = ρ l (Q1 l d² − Q2 c d), d = tr D < 0, l = 1/√(2 max b_iI b_iI)   (LS-DYNA's 1.5 and 0.06)
/// Same law (crushable_foam.h), axes and boundaries as foam_bed.h. Columns outside the active range are held at rest.
#pragma once

#include <cstdint>
#include <vector>

#include "sph_backend/contact_points.h"
#include "sph_backend/crushable_foam.h"
#include "sph_backend/fem/hexahedron.h"

namespace apc::sph::fem {

enum class Integration { one_point, full };
/// Against the modes that one-point integration does not see: stiffness κ (λ + 2μ) V b_jI b_jI, or viscosity
/// κ ρ c V^⅔ · 2 per unit of hourglass velocity.
enum class Hourglass { stiffness, viscosity };

struct MeshSpec {
  Foam foam;
  double size = 0.0;   ///< of the undeformed elements in x and y, m
  double depth = 0.0;  ///< m
  double half_width = 0.0;
  int first_column = 0, columns = 0;
  bool outer_wall = true;    ///< y held at half_width
  bool hold_bottom = true;   ///< lowest nodes do not slide
  bool mirror_ends = false;  ///< x held at both ends
  bool free_body = false;    ///< nothing held
  Integration integration = Integration::one_point;
  Hourglass hourglass = Hourglass::stiffness;
  double hourglass_factor = 0.05;  ///< κ
  double quadratic_viscosity = 1.5, linear_viscosity = 0.06;
  double cfl = 0.5;
};

/// Foam's part of the energy account, J; sums over all steps, except kinetic.
struct MeshEnergy {
  double internal = 0.0, hourglass = 0.0, viscous = 0.0, damping = 0.0;
  double kinetic = 0.0;
  double removed = 0.0;  ///< kinetic energy of columns that were put to rest
};

struct Mesh {
  MeshSpec spec;
  CrushLaw law;
  int nx = 0, ny = 0, nz = 0;  ///< elements
  double layer = 0.0, half_width = 0.0;
  double dt = 0.0;       ///< of the step just drifted
  double next_dt = 0.0;  ///< limit found by the forces
  double kick_dt = 0.0;
  double time = 0.0;
  int active_first = 0, active_end = 0;  ///< columns of elements

  std::vector<double> x[3], v[3], force[3], mass;        ///< per node (ix (ny + 1) + iy)(nz + 1) + iz
  std::vector<std::uint8_t> hold, boundary_hold;         ///< bits of Hold: now, and for ever
  std::vector<Stress> stress;                            ///< per point; 1 or 8 per element (ix ny + iy) nz + iz
  std::vector<double> volume, volume0;                   ///< per point
  std::vector<std::array<double, 3 * modes>> hourglass;  ///< per element: Q_iα, N
  std::vector<std::uint32_t> surface;                    ///< nodes of the top face, column by column
  MeshEnergy energy;
  std::int64_t steps = 0, element_steps = 0;
  std::int64_t inverted = 0;  ///< elements or points turned inside out in the last step

  int points() const { return spec.integration == Integration::one_point ? 1 : 8; }
  std::size_t node(int ix, int iy, int iz) const {
    return (static_cast<std::size_t>(ix) * (ny + 1) + iy) * (nz + 1) + iz;
  }
  std::size_t element(int ix, int iy, int iz) const { return (static_cast<std::size_t>(ix) * ny + iy) * nz + iz; }
};

Mesh make_mesh(const MeshSpec&);

/// Numbers of the nodes at the corners of an element, in the order of hexahedron.h.
std::array<std::size_t, corners> corner_nodes(const Mesh&, int ix, int iy, int iz);

/// Only columns [first, end) of the bed move from now on; the others are put to rest.
void set_active(Mesh&, int first_column, int end_column);

/// Positions, with the time step found by the last forces.
void drift(Mesh&);
/// Stress at the new positions and nodal forces; tools may add to `force` afterwards.
void internal_forces(Mesh&);
/// Velocities.
void kick(Mesh&);

/// Nodes of the top face in the active columns.
ContactPoints contact_points(const Mesh&);

double largest_compaction(const Mesh&);

}  // namespace apc::sph::fem
