/// Watches one run on a dense grid of instants (never on the solver's own steps): histories, peaks, limits passed,
/// table coverage. Peaks are the vertices of parabolas through three neighbouring instants.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "aircraft/limits.h"
#include "apc/simulation/energy.h"
#include "apc/simulation/equations.h"
#include "apc/simulation/simulate.h"

namespace apc::simulation {

/// Largest value of a sampled signal, and where. Instants need not be equally spaced.
struct Peak {
  double value = -1e300, distance = 0.0;
  void see(double time, double sample, double at);

 private:
  double time_[2] = {0.0, 0.0}, last_[2] = {-1e300, -1e300}, where_[2] = {0.0, 0.0};
  int count_ = 0;
};

class Observer {
 public:
  /// `interval` between instants, s (0 = wherever the solver's steps begin, halve and end); a history row at every
  /// `rows_every`-th one (0 = no history).
  Observer(const Model&, const Plant&, double interval, int rows_every);

  double interval() const { return interval_; }
  /// One instant at or after entry, in the order of time.
  void see(double time, const double* y, const Surroundings&, const Moment&, double dissipated);
  /// The same between the instants of the grid: no history row.
  void see_between(double time, const double* y, const Surroundings&, const Moment&);
  /// A history row before entry or at the end of the run (not counted in peaks or means).
  void record(double time, const double* y, const Moment&, double dissipated);
  /// Fills extremes, gears, coverage and history.
  void finish(Result&) const;

 private:
  /// Time off the ground, and where it began.
  struct Airborne {
    double time = 0.0, first_at = std::numeric_limits<double>::quiet_NaN();
    void see(bool now, double passed, double at);

   private:
    bool before_ = false;
  };
  struct GearWatch {
    Peak drag, vertical, stroke, rut, penetration;
    double drag_work = 0.0, last_drag = 0.0;
    Peak tire;                        ///< load of one tire
    const char* failed_by = nullptr;  ///< the load that first passed its ultimate, and the nose wheel's place and the
    double failed_at = 0.0, failed_time = 0.0;  ///< time then
    Airborne airborne;
    double depth = -1.0, maximum_penetration = 0.0;                        ///< of the table at the depth seen last
    double in_bed = 0.0, below_speed = 0.0, above_speed = 0.0;             ///< s
    double outside_depth = 0.0, outside_penetration = 0.0, outside = 0.0;  ///< s
  };
  const Model& model_;
  const Plant& plant_;
  double interval_;
  int rows_every_;
  long instants_ = 0;
  std::vector<aircraft::LoadLimits> limits_;
  std::vector<GearWatch> gears_;
  void see_coverage(std::size_t group, double passed, const Surroundings&, const Moment&);
  void report_failures(Result&) const;
  void report_lift_off(Result&) const;

  Airborne all_airborne_;
  Peak deceleration_, mean_100ms_, pitch_up_, pitch_down_;
  std::vector<std::array<double, 2>> speeds_;  ///< {time, speed}, all instants
  std::size_t window_ = 0;                     ///< the last of them at least 0.1 s ago
  double last_distance_ = 0.0, last_time_ = 0.0;
  History history_;
};

/// Sum over the rows of a group of what the tires do to the axles, wheel inertia left out: {drag, vertical}, N.
std::array<double, 2> group_load(const Plant&, std::size_t group, const Moment&);

}  // namespace apc::simulation
