/// A pressurised deformable tire: a stretched membrane on a nonlinear foundation, over a grid that spins with the
/// wheel.
///
///   m ü = Q − q(u) + N_θ ∂²u/∂s_θ² + N_φ ∂²u/∂s_φ² − c u̇        per unit area, u ≥ 0 radially inward
/// N_φ = p (R² − Rc²)/(2R) and N_θ = R (p − N_φ/r_φ) are the membrane forces of a pressurised torus at its crown (r_φ
/// radius of the section there, Rc radius of the widest points), so the undeformed shape resists a pressure of about
/// the inflation before it flattens, and a wide soft load bends it gently. q(u), what carcass and side walls add, is
/// found so that pressing the tire on a rigid plane gives the catalogue's load–deflection curve (calibrate_foundation).
/// Simplifications: points move radially only; the widest points stand still; inertia of the tread without Coriolis and
/// centrifugal terms; the membrane forces do not change with deflection.
///
/// Half model: nodes (i, j) at angle φ_i = 2π i/around and lateral place y_j = a j/across; j = 0 on the symmetry plane,
/// j = across is fixed.
#pragma once

#include <vector>

#include "apc/base/curve.h"
#include "sph_backend/tire_shape.h"

namespace apc::sph {

struct TireGrid {
  int around = 96, across = 8;
};

struct Tire {
  TireShape shape;
  Section outline;
  TireGrid grid;
  LinearCurve foundation;           ///< q(u), Pa
  std::vector<double> ring_radius;  ///< of the undeformed nodes of line j
  std::vector<double> area, mass;   ///< of one node of line j (projected on the cylinder), m² and kg
  std::vector<double> hoop;         ///< spring to the next node around, line j, N/m
  std::vector<double> meridian;     ///< spring from line j to j + 1, N/m
  double damping = 0.0;             ///< c/m, 1/s
  double wheel_inertia = 0.0;       ///< of the half model, kg m²
  bool rigid = false;               ///< a roller: nodes never move

  std::vector<double> u, rate, force;  ///< per node i (across + 1) + j: deflection, its rate, load Q of this step
  double angle = 0.0, spin = 0.0;      ///< of the wheel; spin ≥ 0 rolls forward

  std::size_t node(int i, int j) const { return static_cast<std::size_t>(i) * (grid.across + 1) + j; }
};

/// What is not in a catalogue, with its rule of thumb. Steady loads depend on none of the three.
struct TireAssumptions {
  double areal_mass_per_width = 90.0;  ///< kg/m³: tread and carcass, 38 kg/m² for a 16.5 in wide tire
  double inertia_factor = 10.0;        ///< wheel inertia = factor · D⁴ W, kg/m³ (21 kg m² for the H44.5x16.5-21)
  double damping_ratio = 0.3;          ///< of the foundation mode
};

/// `threads` share the calibration of its foundation; the tire does not depend on them.
Tire make_tire(const TireShape&, const TireGrid& = {}, const TireAssumptions& = {}, unsigned threads = 1);

/// A rigid cylinder without ends, of the shape's diameter, for plane-strain studies.
Tire make_roller(const TireShape&, double half_width);

/// Tread: one leapfrog step under tire.force and the elastic forces. Sets the mean rates of the step and returns the
/// damping work.
double kick_tire(Tire&, double dt, std::vector<double>& mean_rate);

/// Elastic force −∂E/∂u at every node.
void elastic_force(const Tire&, std::vector<double>& force);
double stored_energy(const Tire&);
double tread_kinetic_energy(const Tire&);

struct GasState {
  double volume, volume_change, pressure;  ///< of the whole tire, m³; gauge Pa, isothermal
};
GasState gas_state(const Tire&);

/// Static state on a rigid frictionless plane at `deflection`: sets tire.u, returns the load of the whole tire in N.
/// `phase` turns the wheel by that share of a node spacing.
double press_on_plane(Tire&, double deflection, double phase = 0.0);

/// q(u) such that press_on_plane passes through the catalogue's curve; called by make_tire.
void calibrate_foundation(Tire&, unsigned threads = 1);

}  // namespace apc::sph
