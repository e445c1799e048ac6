#include "sph_backend/rut_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace apc::sph {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Smallest place at which the surface passes `level` upwards, from strip `first` on.
double passes(const Surface& s, double level, std::size_t first = 0) {
  for (std::size_t k = first; k < s.height.size(); ++k) {
    if (s.height[k] < level) continue;
    if (k == 0) return s.centre(0);
    const double below = s.height[k - 1], above = s.height[k];
    const double share = above > below ? std::clamp((level - below) / (above - below), 0.0, 1.0) : 1.0;
    return s.centre(k - 1) + share * s.strip;
  }
  return none;
}

double median(std::vector<double> values) {
  if (values.empty()) return none;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

Surface surface_of(std::vector<Grain> grains, double start, double end, double strip) {
  Surface s{start, strip, std::vector<double>(static_cast<std::size_t>(std::lround((end - start) / strip)), 0.0)};
  std::sort(grains.begin(), grains.end(), [](const Grain& a, const Grain& b) { return a.bottom < b.bottom; });
  for (const Grain& g : grains) {
    const double place = (g.place - start) / strip;
    if (place < 0.0 || place >= static_cast<double>(s.height.size())) continue;
    double& height = s.height[static_cast<std::size_t>(place)];
    if (g.bottom <= height + strip) height = std::max(height, g.top);
  }
  return s;
}

double FurrowWheel::flank(double height) const {
  const double down = axle_height - height - outline.centre;  // below the circle of the widest points
  if (down <= 0.0) return outline.lateral;
  return down >= outline.radial ? 0.0 : outline.lateral * std::sqrt(1.0 - std::pow(down / outline.radial, 2));
}

RutShape rut_shape(const Surface& s, const FurrowWheel& wheel, double bed_depth, double penetration) {
  RutShape shape;
  shape.floor_ideal = bed_depth - penetration;
  std::vector<double> middle;
  for (std::size_t k = 0; k < s.height.size() && s.centre(k) < std::max(0.5 * wheel.outline.lateral, s.strip); ++k)
    middle.push_back(s.height[k]);
  shape.floor = median(middle);
  const double rise = bed_depth - shape.floor;
  if (!(rise > 0.0)) {
    shape.wall = shape.flank = shape.wall_width = shape.flank_width = shape.berm = none;
    return shape;
  }
  const std::size_t beside = middle.size();  // a lump on the floor is not the wall
  const double half = shape.floor + 0.5 * rise;
  shape.wall = passes(s, half, beside);
  shape.flank = wheel.flank(half);
  shape.wall_width = passes(s, shape.floor + 0.9 * rise, beside) - passes(s, shape.floor + 0.1 * rise, beside);
  shape.flank_width = wheel.flank(shape.floor + 0.9 * rise) - wheel.flank(shape.floor + 0.1 * rise);
  shape.berm = none;
  for (std::size_t k = beside; k < s.height.size(); ++k)
    if (s.centre(k) > shape.wall) shape.berm = std::fmax(shape.berm, s.height[k] - bed_depth);
  return shape;
}

std::vector<ShapeLine> lines_of(const RutShape& shape) {
  return {{"section_behind", "measured behind the axle", shape.behind},
          {"floor", "floor above the rigid plane", shape.floor},
          {"floor_ideal", "bed depth less penetration", shape.floor_ideal},
          {"wall", "wall at half depth, from the wheel's plane", shape.wall},
          {"wheel_flank", "flank of the wheel there", shape.flank},
          {"wall_width", "wall from 10 to 90 % of its height", shape.wall_width},
          {"flank_width", "the same of the wheel's flank", shape.flank_width},
          {"berm", "berm beside it, above the surface", shape.berm},
          {"bow_wave", "bow wave ahead, above the surface", shape.bow_wave}};
}

}  // namespace apc::sph
