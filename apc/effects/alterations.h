/// Everything that makes the bed other than the plain steady tables: effects, the individual strength of blocks, and
/// smooth errors of the load tables. Empty alterations cost nothing and change no bit.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "apc/effects/effect.h"
#include "loadtables/load_table.h"

namespace apc::effects {

/// Logarithm of the bed's strength along the way of one gear group: linear between knots `spacing` apart, the first at
/// the leading edge; constant beyond the ends. Empty = 0.
struct StrengthProfile {
  double spacing = 1.0;
  std::vector<double> log_strength;
  double at(double bed_distance) const;
};

/// Smooth relative error of one table: logarithms of factors on drag and vertical load at 3 speeds × 3 relative
/// penetrations (quadratic in between, constant outside). Knots: 5, 17.5, 36 m/s; 0.15, 0.5, 0.9 of `P_max`.
struct TableError {
  std::array<double, 9> drag{}, vertical{};  ///< index 3 · speed + penetration
  bool none() const;
  /// {log factor of drag, of vertical}
  std::array<double, 2> at(double speed, double relative_penetration) const;
};

/// What a run brings along that effects may depend on.
struct Conditions {
  double years = 0.0;           ///< age of the bed
  double temperature = 293.15;  ///< K
};

/// Leads a run along a measured speed: a force at ground level, gain × mass × (measured − own speed), from entry on.
/// What the force has to be is what the model's own forces lack; without it small errors of a run that is nearly
/// bistable (tires close to crushing through) grow until model and measurement are two different runs.
struct Guide {
  std::vector<double> time, speed;  ///< evenly spaced from time.front(); s, m/s
  double gain = 10.0;               ///< 1/s
  double speed_at(double at) const;
};

struct Alterations {
  std::vector<Applied> effects;
  double bed_strength = 1.0;              ///< × crush strength everywhere
  std::vector<StrengthProfile> strength;  ///< per gear group, or empty
  std::vector<TableError> table_errors;   ///< per gear group, or empty
  Conditions conditions;
  std::shared_ptr<const Guide> guide;  ///< null: the run is free
  /// Where fine effects see a wheel: bed distance · (1 + stretch) + shift. The measured way of a run may be wrong by
  /// decimetres, which matters to joints every metre.
  double place_shift = 0.0, place_stretch = 0.0;  ///< m, 1

  bool alter_tires() const;          ///< false: tires see the plain tables
  bool alter_thrust() const;         ///< a force that depends on time acts, the guide included
  double thrust(double time) const;  ///< N forward, all effects
};

/// Applies the `site` laws to copies of aircraft and bed.
void alter_site(const Alterations&, Site&);

/// Facts about a gear group that laws ask for.
struct TireFacts {
  std::size_t gear = 0;  ///< index in the aircraft's order
  bool nose = false;
  int wheels = 2;
  double width = 0.0, radius = 0.0, density = 0.0;
};

/// Where a tire is; what the table needs is `contact`.
struct TirePlace {
  TireContact contact;
  double bed_distance = 0.0, nose_distance = 0.0, time = 0.0;
};

/// The altered load, per tire (mean over the group when one tire differs).
TireLoad load(const loadtables::LoadTable&, const Alterations&, const TireFacts&, const TirePlace&);

/// The same with derivatives by speed, bed depth, penetration and bed distance: of the balance in closed form, of the
/// laws by differences (they cost no table look-up).
struct AlteredLoad {
  TireLoad load;
  std::array<double, 4> drag{}, vertical{}, rut_depth{}, spin_ratio{};
};
AlteredLoad load_with_slopes(const loadtables::LoadTable&, const Alterations&, const TireFacts&, const TirePlace&);

}  // namespace apc::effects
