#include "apc/design/windows.h"

#include <algorithm>
#include <cmath>

namespace apc::design {
namespace {

constexpr double before_rest = 0.05;  // m
constexpr double fall = 0.02;         // 1/m

/// The parabola through three samples around i: value + slope s + curvature s², s = place − at.
struct Parabola {
  double at, value, slope, curvature;
  bool smooth;  // false: a place is there twice, a corner
  double operator()(double place) const {
    const double s = place - at;
    return value + s * (slope + s * curvature);
  }
};

Parabola around(const std::vector<double>& place, const std::vector<double>& value, std::size_t i) {
  i = std::clamp<std::size_t>(i, 1, place.size() - 2);
  const double a = place[i - 1] - place[i], b = place[i + 1] - place[i];
  if (a >= 0 || b <= 0) return {place[i], value[i], 0.0, 0.0, false};
  const double before = (value[i - 1] - value[i]) / a, after = (value[i + 1] - value[i]) / b;
  const double curvature = (after - before) / (b - a);
  return {place[i], value[i], after - curvature * b, curvature, true};
}

}  // namespace

std::vector<double> window_peaks(const std::vector<double>& place, const std::vector<double>& value,
                                 const std::vector<double>& edges) {
  std::vector<double> peaks(edges.size() - 1, -1.0);
  if (place.size() < 3) return std::vector<double>(2 * edges.size(), -1.0);
  const double end = std::max(place.front(), place.back() - before_rest);
  const auto see = [&](double at, double peak) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), at);
    if (above == edges.begin() || above == edges.end()) return;  // outside of all windows
    auto& window = peaks[static_cast<std::size_t>(above - edges.begin()) - 1];
    window = std::max(window, peak);
  };
  const auto at = [&](double where) {
    const auto above = std::upper_bound(place.begin(), place.end(), where);
    const auto i = static_cast<std::size_t>(above - place.begin());
    if (i == 0) return value.front();
    if (i == place.size()) return value.back();
    const double share = (where - place[i - 1]) / (place[i] - place[i - 1]);
    const auto bent = around(place, value, share < 0.5 ? i - 1 : i);
    return bent.smooth ? bent(where) : value[i - 1] + share * (value[i] - value[i - 1]);
  };
  for (std::size_t i = 1; i + 1 < place.size() && place[i] <= end; ++i) {
    see(place[i], value[i]);
    if (value[i] < value[i - 1] || value[i] < value[i + 1]) continue;
    const auto parabola = around(place, value, i);
    if (parabola.curvature >= 0) continue;
    const double shift = -0.5 * parabola.slope / parabola.curvature, vertex = place[i] + shift;
    if (vertex > place[i - 1] && vertex < place[i + 1] && vertex <= end) see(vertex, parabola(vertex));
  }
  const double last = at(end);
  std::vector<double> values;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double here = edges[e] <= end ? at(edges[e]) : last - fall * (edges[e] - end);
    values.push_back(here);
    if (e > 0) peaks[e - 1] = std::max(peaks[e - 1], here);
    if (e + 1 < edges.size()) peaks[e] = std::max(peaks[e], here);
  }
  peaks.insert(peaks.end(), values.begin(), values.end());
  peaks.push_back(last);
  return peaks;
}

}  // namespace apc::design
