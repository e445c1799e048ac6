/// How the bed pushes back on one tire, remembered: a C² table of drag, vertical load, rut depth and spin ratio over
/// speed × bed depth × relative penetration, made from SPH runs (or any other samples) through an RBF metamodel.
///
/// The relative penetration is r = P / P_max(h) with P_max(h) = min(0.85 h + δ₈₀, D): full compaction of the bed plus
/// the tire's deflection at 80 % of its bottoming load, at most the tire's diameter D (ACRP Report 29, §9.4.4.1). The
/// row h = 0 is the pavement: the tire's load–deflection curve with rolling resistance, so that pavement, ramp and bed
/// are one smooth function.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apc/base/tire_contact.h"

namespace apc::loadtables {

/// Where in the fitted range a contact lies. Outside, values continue, never clamped: linearly along speed and depth,
/// by the tire on crushed foam beyond P_max (out_of_range.h).
struct Coverage {
  bool speed = true, bed_depth = true, penetration = true;  ///< true = inside
  bool inside() const { return speed && bed_depth && penetration; }
};

/// Partial derivatives of one response.
struct Slopes {
  double speed = 0.0, bed_depth = 0.0, penetration = 0.0;
};

/// A load with its derivatives, for Jacobians.
struct LoadWithSlopes {
  TireLoad load;
  Slopes drag, vertical, rut_depth, spin_ratio;
};

/// A load at one speed and bed depth with its derivatives by penetration.
struct LoadAlong {
  TireLoad load;
  double drag = 0.0, vertical = 0.0, rut_depth = 0.0, spin_ratio = 0.0;  ///< by penetration
};

/// How well a response was fitted. Relative to the mean absolute response of the samples.
struct FitQuality {
  std::string response;  ///< "drag", "vertical", "rut_depth", "spin_ratio"
  int points = 0;
  double rms_relative = 0.0, loo_rms_relative = 0.0, r2 = 0.0;  ///< loo = leave one out
  double loo_rms_to_axle = 0.0;  ///< of the samples with penetrations up to the tire's radius, where tires ride
};

/// The tire a table belongs to, as numbers (SI): enough to evaluate P_max and the pavement row.
struct TableTire {
  std::string name;
  double diameter = 0.0, width = 0.0;
  double rated_load = 0.0, rated_deflection = 0.0, bottoming_load = 0.0, bottoming_deflection = 0.0;
  std::vector<double> curve_deflection, curve_load;  ///< load–deflection points (PCHIP), starting at (0, 0)
};

/// Where a table comes from; written into every file and every report.
struct Provenance {
  std::string material, source, command, date, version;
  double friction = 0.0, spacing = 0.0;  ///< of the SPH runs; 0 when they came from elsewhere
  int runs = 0, refused = 0;             ///< refused: not settled, tire overloaded, unstable
};

struct TableNumbers;  ///< table_lanes.h

class LoadTable {
 public:
  LoadTable();  ///< empty; only assignable
  ~LoadTable();
  LoadTable(LoadTable&&) noexcept;
  LoadTable& operator=(LoadTable&&) noexcept;
  LoadTable(const LoadTable&);
  LoadTable& operator=(const LoadTable&);

  /// Loads ≥ 0 for penetration ≥ 0, all zero (and spin 1) for penetration ≤ 0. C² inside a smooth bed; any arguments.
  TireLoad load(const TireContact&) const;
  LoadWithSlopes load_with_slopes(const TireContact&) const;
  /// On pavement, where loads do not depend on speed (a table's own residue of it is averaged out): a curve along the
  /// penetration alone.
  LoadAlong load_on_pavement(double penetration) const;
  Coverage coverage(const TireContact&) const;
  double maximum_penetration(double bed_depth) const;
  /// For callers that keep maximum_penetration() of the contact's depth.
  Coverage coverage(const TireContact&, double maximum_penetration) const;

  const TableTire& tire() const;
  const Provenance& provenance() const;
  const std::vector<FitQuality>& quality() const;
  /// Fitted ranges {low, high}: speed (m/s), bed depth (m), relative penetration.
  std::array<double, 2> speed_range() const, depth_range() const, ratio_range() const;

  TableNumbers numbers() const;  ///< for look-ups of several runs side by side; points into this

  struct Data;  ///< knots and coefficients; load_table_data.h, for the builder and the HDF5 file only
  struct Derived;
  explicit LoadTable(std::shared_ptr<const Data>);
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
  std::shared_ptr<const Derived> derived_;  ///< what every look-up wants, computed once
};

/// The loads of a table along the penetration alone, for searches at a fixed speed and bed depth: the other two axes
/// are summed once, a few intervals at a time.
class PenetrationLine {
 public:
  /// The table must outlive this.
  PenetrationLine(const LoadTable&, double speed, double bed_depth);
  LoadAlong at(double penetration);

 private:
  static constexpr int window = 8;  ///< coefficients held
  const LoadTable& table_;
  double speed_, depth_, scale_ = 1.0, speed_weight_[4] = {}, depth_weight_[4] = {};
  int speed_first_ = 0, depth_first_ = 0, first_ = -1;
  bool outside_ = false;
  double sum_[4 * window] = {};
};

/// What a file says it is for; empty when it is no load table. Never throws for foreign content.
struct TableHead {
  std::string tire, material;
};
TableHead table_head(const std::filesystem::path&);

/// Native container (HDF5). Throws InputError for truncated, foreign or other-version files.
LoadTable load_table(const std::filesystem::path&);
void save_table(const LoadTable&, const std::filesystem::path&);

}  // namespace apc::loadtables
