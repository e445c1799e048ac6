#include "apc/simulation/profile.h"

#include <algorithm>

namespace apc::simulation {

Profile::Profile(const bed::Bed& bed, double depth_factor) : distance_(bed.distance), depth_(bed.depth) {
  for (auto& depth : depth_) depth *= depth_factor;
  slope_.resize(distance_.size() - 1);
  for (std::size_t i = 0; i < slope_.size(); ++i)
    slope_[i] = (depth_[i + 1] - depth_[i]) / (distance_[i + 1] - distance_[i]);
}

std::vector<double> Profile::corners(double half_patch) const {
  std::vector<double> found;
  double before = 0.0;
  for (std::size_t i = 0; i <= slope_.size(); ++i) {
    const double after = i < slope_.size() ? slope_[i] : 0.0;
    if (after != before)
      for (const double side : {-1.0, 0.0, 1.0})
        if (side == 0.0 || half_patch > 0.0) found.push_back(distance_[i] + side * half_patch);
    before = after;
  }
  std::sort(found.begin(), found.end());
  return found;
}

double Profile::shortest_piece() const {
  double shortest = length();
  for (std::size_t i = 0; i < slope_.size(); ++i) shortest = std::min(shortest, distance_[i + 1] - distance_[i]);
  return shortest;
}

std::size_t Profile::piece(double distance) const {
  std::size_t i = 0;
  while (i + 2 < distance_.size() && distance >= distance_[i + 1]) ++i;
  return i;
}

ValueAndSlope Profile::depth(double distance) const {
  if (distance <= distance_.front()) return {depth_.front(), 0.0};
  if (distance >= distance_.back()) return {depth_.back(), 0.0};
  const auto i = piece(distance);
  return {depth_[i] + slope_[i] * (distance - distance_[i]), slope_[i]};
}

ValueAndSlope Profile::inclination(double distance, double half_patch) const {
  const auto ahead = depth(distance + half_patch), behind = depth(distance - half_patch);
  const double per_patch = 0.5 / half_patch;
  return {(ahead.value - behind.value) * per_patch, (ahead.slope - behind.slope) * per_patch};
}

}  // namespace apc::simulation
