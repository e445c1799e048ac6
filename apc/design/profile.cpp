#include "apc/design/profile.h"

#include <algorithm>
#include <cmath>

namespace apc::design {

std::vector<double> Profile::stations() const {
  std::vector<double> out;
  for (std::size_t j = 0; j < depth.size(); ++j)
    out.push_back(ramp + static_cast<double>(j) * (reference - ramp) / static_cast<double>(depth.size()));
  return out;
}

double Profile::depth_at(double distance) const {
  if (distance <= 0) return 0.0;
  if (distance <= ramp) return depth.front() * distance / ramp;
  const auto at = stations();
  for (std::size_t j = 0; j + 1 < at.size(); ++j)
    if (distance <= at[j + 1]) return depth[j] + (depth[j + 1] - depth[j]) * (distance - at[j]) / (at[j + 1] - at[j]);
  return depth.back();
}

double Profile::section(double length) const {
  std::vector<double> corners{0.0};
  for (const double at : stations())
    if (at < length) corners.push_back(at);
  corners.push_back(length);
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    area += 0.5 * (depth_at(corners[i]) + depth_at(corners[i + 1])) * (corners[i + 1] - corners[i]);
  return area;
}

std::vector<double> window_edges(const Profile& profile, double width) {
  auto corners = profile.stations();
  corners.insert(corners.begin(), 0.0);
  corners.push_back(profile.reference);
  // The number of windows must not change with the design, so the ramp's length does not count.
  const auto pieces = static_cast<double>(corners.size() - 1);
  const int each = std::max(1, static_cast<int>(std::ceil(profile.reference / pieces / width)));
  std::vector<double> out{0.0};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    for (int part = 1; part <= each; ++part) out.push_back(corners[i] + (corners[i + 1] - corners[i]) * part / each);
  return out;
}

bed::Bed bed_of(const BedSpace& space, const Profile& profile, double length) {
  bed::Bed bed;
  bed.name = "design";
  bed.source = "apc design";
  bed.material = space.material;
  bed.setback = space.setback;
  bed.width = space.width;
  bed.flush = space.flush;
  bed.grade = space.grade;
  bed.block_length = space.block_length;
  bed.block_width = space.block_width;
  bed.distance = {0.0};
  bed.depth = {0.0};
  const auto add = [&](double at) {
    if (at - bed.distance.back() < 1e-6) return;
    bed.distance.push_back(at);
    bed.depth.push_back(profile.depth_at(at));
  };
  for (const double at : profile.stations())
    if (at < length) add(at);
  add(length);
  return bed;
}

std::vector<double> slope_use(const BedSpace& space, const Profile& profile) {
  std::vector<double> use{profile.depth.front() / profile.ramp / space.maximum_slope};
  const auto at = profile.stations();
  for (std::size_t j = 0; j + 1 < at.size(); ++j)
    use.push_back(std::abs(profile.depth[j + 1] - profile.depth[j]) / (at[j + 1] - at[j]) / space.maximum_slope);
  return use;
}

}  // namespace apc::design
