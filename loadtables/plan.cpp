#include "loadtables/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "apc/base/require.h"
#include "loadtables/penetration_scale.h"

namespace apc::loadtables {
namespace {

using Point = std::array<double, 3>;  // in the unit cube

/// SplitMix64: the standard distributions differ between libraries, plans must not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(unit() * static_cast<double>(count)); }

 private:
  std::uint64_t state_;
};

double squared_distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// One point's share of φ = Σ d⁻²⁰ over all pairs: small when the closest pairs are far apart.
double crowding(const std::vector<Point>& points, std::size_t at) {
  double sum = 0.0;
  for (std::size_t j = 0; j < points.size(); ++j)
    if (j != at) sum += std::pow(squared_distance(points[at], points[j]) + 1e-6, -10.0);
  return sum;
}

std::vector<Point> latin_hypercube(std::size_t count, const std::vector<Point>& fixed, Random& random) {
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<std::size_t> level(count);
    std::iota(level.begin(), level.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(level[i - 1], level[random.below(i)]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][k] = (static_cast<double>(level[i]) + 0.5) / static_cast<double>(count);
  }
  points.insert(points.end(), fixed.begin(), fixed.end());
  if (count < 2) return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count)};
  // A swap costs as much as there are points; beyond some eighty, random swaps gain little more.
  const int swaps = static_cast<int>(std::min<std::size_t>(40000, 3200000 / count));
  for (int swap = 0; swap < swaps; ++swap) {
    const auto a = random.below(count), b = random.below(count), k = random.below(3);
    if (a == b) continue;
    const double before = crowding(points, a) + crowding(points, b);
    std::swap(points[a][k], points[b][k]);
    if (crowding(points, a) + crowding(points, b) > before) std::swap(points[a][k], points[b][k]);
  }
  points.resize(count);
  return points;
}

/// Farthest point first, from the centre: any first part of the list covers the box.
std::vector<Point> spread(std::vector<Point> points) {
  std::vector<Point> ordered;
  std::vector<double> nearest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)  // the most central point has the largest key and comes first
    nearest[i] = 10.0 - squared_distance(points[i], {0.5, 0.5, 0.5});
  while (!points.empty()) {
    const auto next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    const auto chosen = points[next];
    ordered.push_back(chosen);
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(next));
    nearest.erase(nearest.begin() + static_cast<std::ptrdiff_t>(next));
    for (std::size_t i = 0; i < points.size(); ++i)
      nearest[i] = std::min(ordered.size() == 1 ? 10.0 : nearest[i], squared_distance(points[i], chosen));
  }
  return ordered;
}

double between(const std::array<double, 2>& range, double share) { return range[0] + share * (range[1] - range[0]); }

/// 85 % of the runs lie above r = 0.3, as far as the range reaches there.
double relative_penetration(const std::array<double, 2>& range, double share) {
  constexpr double few = 0.15, knee = 0.3;
  if (range[0] >= knee || range[1] <= knee) return between(range, share);
  return share < few ? between({range[0], knee}, share / few) : between({knee, range[1]}, (share - few) / (1.0 - few));
}

void check(const PlanOptions& options) {
  require(options.runs >= 12 && options.runs <= 10000, "a plan of ", options.runs,
          " runs. Between 12 and 10000 are needed");
  require(options.speed[0] > 0.0 && options.speed[1] > options.speed[0], "the speed range ", options.speed[0], " to ",
          options.speed[1], " m/s is empty or starts at rest. Runs need travel; slower speeds are extrapolated");
  require(options.bed_depth[0] >= 0.02 && options.bed_depth[1] > options.bed_depth[0] && options.bed_depth[1] <= 3.0,
          "the depth range ", options.bed_depth[0], " to ", options.bed_depth[1],
          " m. Between 0.02 and 3 m are possible");
  require(options.relative_penetration[0] > 0.0 && options.relative_penetration[1] > options.relative_penetration[0] &&
              options.relative_penetration[1] <= 1.2,
          "the range of relative penetration ", options.relative_penetration[0], " to ",
          options.relative_penetration[1], ". It is a part of (0, 1.2]");
  require(options.depth_increment >= 0.0 && options.depth_increment < options.bed_depth[1], "the depth increment ",
          options.depth_increment, " m does not fit the depth range");
}

}  // namespace

Plan make_plan(const TableTire& tire, const std::string& material, const PlanOptions& options) {
  check(options);
  const auto scale = penetration_scale(tire);
  std::vector<Point> corners;
  for (const double v : {0.0, 1.0})
    for (const double h : {0.0, 1.0})
      for (const double r : {0.0, 1.0}) corners.push_back({v, h, r});
  Random random(options.seed);
  auto points = latin_hypercube(static_cast<std::size_t>(options.runs) - corners.size(), corners, random);
  points.insert(points.end(), corners.begin(), corners.end());

  Plan plan{material, tire, options, {}};
  for (const auto& point : spread(points)) {
    double depth = options.bed_depth[0] * std::pow(options.bed_depth[1] / options.bed_depth[0], point[1]);
    if (options.depth_increment > 0.0)
      depth = std::clamp(std::round(depth / options.depth_increment) * options.depth_increment, options.bed_depth[0],
                         options.bed_depth[1]);
    const double ratio = relative_penetration(options.relative_penetration, point[2]);
    plan.runs.push_back({static_cast<int>(plan.runs.size()) + 1,
                         {between(options.speed, point[0]), depth, ratio * scale.at(depth)},
                         ratio});
  }
  return plan;
}

}  // namespace apc::loadtables
