/// The rig: one tire rolled through a bed of foam at a given speed, depth and penetration, until its loads are steady.
///
/// Sequence (ACRP 29, 9.4.3.3): press to the penetration → accelerate and spin up to v/(3R) → release the spin →
/// settle → measure. The tire is the pressurised membrane of tire.h, free-rolling and unbraked; the bed is a moving
/// window of the half y ≥ 0: fresh lattice columns ahead, columns left behind dropped.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sph_backend/energy.h"
#include "sph_backend/foam.h"
#include "sph_backend/pair_kernels.h"
#include "sph_backend/rut_shape.h"
#include "sph_backend/tire_shape.h"

namespace apc::sph {

/// How the wheel turns once it rolls: let go, held at ω R = v, or not at all.
enum class WheelSpin { free, driven, locked };

struct RollingCase {
  TireShape tire;
  Foam foam;
  double bed_depth = 0.0;    ///< m of foam above the rigid plane
  double penetration = 0.0;  ///< m, of the undeformed tire's lowest point below the top surface
  double speed = 0.0;        ///< m/s
  double spacing = 0.0;      ///< particle spacing, m
  double friction = 0.3;     ///< of tire on foam; state it with every load

  double bed_half_width = 0.0;  ///< m; 0 = half the tire's width + bed_margin times its width
  double bed_margin = 0.5;      ///< free width beside the tire in tire widths
  bool outer_wall = true;       ///< mirror plane at the half-width, otherwise a free face
  bool hold_bottom = true;      ///< lowest layer held on the rigid plane, otherwise free to slip on it
  double ahead = 0.0;           ///< m of free foam ahead of the axle; 0 = first touch + 0.35 R (at least 5 spacings)
  double behind = 0.0;          ///< m behind once it rolls; 0 = R (at least 8 spacings)
  double press_speed = 0.0;     ///< m/s, highest while pressing; 0 = 0.6 of `speed`, 4 to 15 m/s
  double accelerate_distance = 0.0;  ///< m; 0 = R/2
  double entry = 0.0;                ///< m; 0 = pressed at rest; else rolled in at full speed, coming down on this way
  WheelSpin spin = WheelSpin::free;
  /// Slope of the way down, positive while it sinks: loads are then means over two windows around the nominal
  /// penetration, and settling is not asked for.
  double fall = 0.0;
  double release_spin_ratio = 1.0 / 3.0;  ///< ω R/v when the spin is released
  double alpha = 0.1, beta = 2.0;         ///< artificial viscosity
  double cfl = 0.35;
  PairForm form = PairForm::mass;
  double tire_overload = 0.8;  ///< share of the bottoming load (and the deflection there) above which a run is refused

  double residual_limit = 0.03;  ///< energy account more open than this: the run is called unstable
  /// Plane strain: a rigid cylinder of the tire's diameter across the whole block instead of the tire. Give
  /// bed_half_width; loads are then those of twice that width.
  bool rigid_roller = false;

  // Settling: the loads are averaged over windows of travel; a run is steady when the last two windows differ by less.
  double window = 0.0;            ///< m; 0 = R
  double longest = 0.0;           ///< m of travel after the release; 0 = 10 R
  double load_tolerance = 0.02;   ///< relative change of drag and vertical (against the larger of the two)
  double spin_tolerance = 0.015;  ///< absolute change of ω R/v

  /// Travel until the wheel has reached speed and depth.
  double transient() const { return entry > 0.0 ? entry : accelerate_distance; }
};

/// Particle spacing for a load campaign: an eighth of the tire's width for wide tires, a sixth for the narrowest, and
/// at least five layers in the bed.
double recommended_spacing(const TireShape&, double bed_depth);

enum class RunState { steady, did_not_settle, tire_overloaded, unstable };
const char* name_of(RunState);

/// Averages over bins of travel since the start of rolling, SI; loads of the whole tire.
struct RollingHistory {
  std::vector<double> time, distance, drag, vertical, spin_ratio, deflection;
};

struct RollingResult {
  RunState state = RunState::unstable;
  std::string message;
  double drag = 0.0, vertical = 0.0;  ///< N, whole tire: twice the modelled half
  double rut_depth = 0.0;             ///< m: penetration − tire deflection, the crush under the tire
  double rut_left = 0.0;              ///< m, surface left behind on the centreline (after elastic rebound, no debris)
  double spin_ratio = 0.0;            ///< ω R/v, R undeformed
  double tire_deflection = 0.0;       ///< m, largest on the crown
  double drag_change = 0.0, vertical_change = 0.0, spin_change = 0.0;  ///< between the last two windows
  double internal_energy_rate = 0.0;                   ///< J/m of travel in the last two windows, whole tire
  double gas_pressure = 0.0, gas_volume_change = 0.0;  ///< Pa gauge, m³, at the end
  EnergyAccount energy;                                ///< of the modelled half
  double residual = 0.0;                               ///< of the account, relative to the work put in
  double compaction = 0.0, partition_min = 1.0, partition_mean = 1.0;  ///< Σ V W over particles beyond 50 % compaction
  double particles = 0.0, steps = 0.0, particle_steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
  double bytes_per_particle = 0.0;
  RollingHistory history;
  std::vector<double> section_y, section_z, section_compaction;  ///< particles of one slice behind the tire, m
  RutShape shape;                                                ///< of that slice; of particles only
};

struct RollOptions {
  unsigned threads = 1;
  std::function<void(double share, const std::string& remark)> progress;
  std::function<bool()> stop;        ///< asked now and then; true ends the run with Interrupted
  std::filesystem::path checkpoint;  ///< HDF5; written now and then, and resumed from when it exists
  double checkpoint_every_s = 60.0;
  std::filesystem::path snapshots;  ///< folder for VTU + PVD; empty = none
  double snapshot_distance = 0.0;   ///< m of travel between them; 0 = R/2
};

/// Runs the case. Bad input throws InputError; whatever physics does is in the result's state. Only a steady run's drag
/// and vertical may be used as loads; the others keep what they had.
RollingResult roll(const RollingCase&, const RollOptions& = {});

}  // namespace apc::sph
