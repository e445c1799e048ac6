/// The bed as the wheels meet it: depth along the way and the slope of its base under a contact patch.
#pragma once

#include <vector>

#include "apc/bed/bed.h"

namespace apc::simulation {

template <class V>
struct ValueAndSlopeOf {
  V value = 0.0, slope = 0.0;
};
using ValueAndSlope = ValueAndSlopeOf<double>;

/// Depth and inclination at one place; `V` as in motion.h.
template <class V>
struct GroundUnder {
  ValueAndSlopeOf<V> depth, inclination;
};

/// Piecewise linear depth over bed distance, continued level beyond both ends: whether a wheel is in the bed at all is
/// decided by its row, so that a step at the leading edge stays outside the equations.
class Profile {
 public:
  Profile() = default;
  /// `depth_factor` multiplies every depth.
  Profile(const bed::Bed&, double depth_factor);
  ValueAndSlope depth(double distance) const;
  /// Mean of d depth / d distance over ±`half_patch`: the inclination of the base a tire feels, continuous in distance.
  ValueAndSlope inclination(double distance, double half_patch) const;
  /// Both at once.
  using Ground = GroundUnder<double>;
  Ground under(double distance, double half_patch) const {
    const std::size_t last = slope_.size() - 1;
    if (distance - half_patch >= distance_[last] && distance + half_patch <= distance_[last + 1]) [[likely]]
      return {{depth_[last] + slope_[last] * (distance - distance_[last]), slope_[last]}, {slope_[last], 0.0}};
    return {depth(distance), inclination(distance, half_patch)};
  }
  double length() const { return distance_.back(); }
  double shortest_piece() const;
  /// Where what under() returns has a kink, in order: changes of the slope, and where a patch begins and ends to feel
  /// one.
  std::vector<double> corners(double half_patch) const;
  /// Between `from` and `to` the depth is `depth` + `slope` · (distance − from).
  struct Piece {
    double from, to, depth, slope;
  };
  Piece first_piece() const { return piece_at(0); }
  Piece last_piece() const { return piece_at(slope_.size() - 1); }
  /// The bed begins with a step: depth jumps from 0 at the leading edge.
  bool steps_in() const { return depth_.front() > 1e-6; }

 private:
  std::size_t piece(double distance) const;
  Piece piece_at(std::size_t i) const { return {distance_[i], distance_[i + 1], depth_[i], slope_[i]}; }
  std::vector<double> distance_, depth_, slope_;
};

}  // namespace apc::simulation
