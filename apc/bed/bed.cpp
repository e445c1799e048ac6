#include "apc/bed/bed.h"

#include <algorithm>

namespace apc::bed {
namespace {

/// Index of the piece [distance[i], distance[i + 1]) that holds `at`; pieces belong to their left end.
std::size_t piece(const std::vector<double>& distance, double at) {
  const auto above = std::upper_bound(distance.begin() + 1, distance.end() - 1, at);
  return static_cast<std::size_t>(above - distance.begin()) - 1;
}

}  // namespace

double Bed::maximum_depth() const { return *std::max_element(depth.begin(), depth.end()); }

double Bed::volume() const {
  double section = 0.0;
  for (std::size_t i = 0; i + 1 < distance.size(); ++i)
    section += 0.5 * (depth[i] + depth[i + 1]) * (distance[i + 1] - distance[i]);
  return section * width;
}

double Bed::depth_at(double bed_distance) const {
  if (bed_distance < 0.0 || bed_distance > length()) return 0.0;
  const auto i = piece(distance, bed_distance);
  const double share = (bed_distance - distance[i]) / (distance[i + 1] - distance[i]);
  return depth[i] + share * (depth[i + 1] - depth[i]);
}

double Bed::depth_slope_at(double bed_distance) const {
  if (bed_distance < 0.0 || bed_distance >= length()) return 0.0;
  const auto i = piece(distance, bed_distance);
  return (depth[i + 1] - depth[i]) / (distance[i + 1] - distance[i]);
}

}  // namespace apc::bed
