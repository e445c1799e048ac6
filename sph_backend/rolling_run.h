/// A rolling run under way: everything that changes, as one value, and one step of it.
#pragma once

#include "sph_backend/energy.h"
#include "sph_backend/foam_bed.h"
#include "sph_backend/rolling_history.h"
#include "sph_backend/rut_shape.h"
#include "sph_backend/tire.h"
#include "sph_backend/tire_contact.h"
#include "sph_backend/tire_rig.h"
#include "sph_backend/wheel_path.h"

namespace apc::sph {

/// A tire rolling through a block of foam: particles (`RollingRun`) or elements.
template <class Block>
struct RollingRunOf {
  RollingCase setup;  ///< with every default written out
  Block bed;
  Tire tire;
  WheelPath path;
  ContactLaw law;
  EnergyAccount energy;
  RollingSums sums;
  RollingHistory history;
  std::vector<double> internal;  ///< foam internal energy at the end of each bin
  ContactResult contact;

  double radius() const { return 0.5 * setup.tire.diameter; }
  double bin() const { return 0.25 * setup.window; }
};
using RollingRun = RollingRunOf<Bed>;

/// `setup` with the zeros replaced by the defaults they stand for; InputError for a senseless case.
RollingCase completed(const RollingCase& setup);

RollingRun start_run(const RollingCase& completed, unsigned threads);
void step(RollingRun&);
/// Moves the window of foam along when the axle has reached the end of a column.
void follow(RollingRun&, const AxleState&);

/// Height of the crushed surface behind the tire, m above the rigid plane.
double surface_behind(const RollingRun&);

/// The last free columns of the window, m along the bed: what the wheel leaves.
struct Slice {
  double from, to;
};
Slice settled_slice(const RollingRun&);
RutShape shape_behind(const RollingRun&);

}  // namespace apc::sph
