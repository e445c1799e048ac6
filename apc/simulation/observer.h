/// Watches one run on a dense grid of instants (never on the solver's own steps): histories, peaks, limits passed,
/// table coverage. Peaks are the vertices of parabolas through three neighbouring instants.
#pragma once

#include <array>
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
  /// A history row before entry or at the end of the run (not counted in peaks or means).
  void record(double time, const double* y, const Moment&, double dissipated);
  /// Fills extremes, gears, coverage and history.
  void finish(Result&) const;

 private:
  struct GearWatch {
    Peak drag, vertical, stroke, rut, penetration;
    double drag_work = 0.0, last_drag = 0.0;
    double ultimate_at = -1.0;  ///< bed distance of the nose where the drag first passed its ultimate load
    double depth = -1.0, maximum_penetration = 0.0;  ///< of the table at the depth seen last
    double in_bed = 0.0, outside_speed = 0.0, outside_depth = 0.0, outside_penetration = 0.0, outside = 0.0;  ///< s
  };
  const Model& model_;
  const Plant& plant_;
  double interval_;
  int rows_every_;
  long instants_ = 0;
  std::vector<aircraft::LoadLimits> limits_;
  std::vector<GearWatch> gears_;
  Peak deceleration_, mean_100ms_, pitch_up_, pitch_down_;
  std::vector<std::array<double, 2>> speeds_;  ///< {time, speed}, all instants
  std::size_t window_ = 0;                     ///< the last of them at least 0.1 s ago
  double last_distance_ = 0.0, last_time_ = 0.0;
  History history_;
};

/// Sum over the rows of a group of what the tires do to the axles, wheel inertia left out: {drag, vertical}, N.
std::array<double, 2> group_load(const Plant&, std::size_t group, const Moment&);

}  // namespace apc::simulation
