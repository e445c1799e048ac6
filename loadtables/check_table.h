/// What must hold for a table whatever its samples were: loads are never negative, the vertical load grows with
/// penetration as long as the tire is in no deeper than its axle (an aircraft's rest in the bed depends on it), and the
/// samples come back within the stated error.
#pragma once

#include <string>
#include <vector>

#include "loadtables/load_table.h"

namespace apc::loadtables {

struct TableCheck {
  int points = 0;           ///< looked at: a grid over speed × depth × relative penetration up to 1.2
  double least_drag = 0.0;  ///< N over the grid; below 0 is a failure
  double least_vertical = 0.0;
  // Up to the axle's height:
  double falling_share = 0.0;  ///< share of points where the vertical load falls with penetration
  double steepest_fall = 0.0;  ///< N/m there, ≥ 0 …
  TireContact steepest_at;     ///< … and where
  double largest_fall = 0.0;   ///< largest drop of the vertical load below an earlier value, relative to that value
  TireContact largest_fall_at;
  // For a tire in deeper than its axle, where wheels do plough:
  double largest_fall_beyond = 0.0;
  TireContact largest_fall_beyond_at;
  /// Rms of table minus samples relative to the mean response, for drag and vertical, and the worst single sample.
  double drag_rms = 0.0, vertical_rms = 0.0, worst_drag = 0.0, worst_vertical = 0.0;
  std::vector<std::string> failures;  ///< one sentence each; empty = good
};

/// The vertical load may fall by at most `allowed_fall` below an earlier value (relative).
TableCheck check_table(const LoadTable&, double allowed_fall = 0.05);

}  // namespace apc::loadtables
