#include "apc/site/geodesy.h"

#include <cmath>
#include <numbers>

#include "apc/base/require.h"

namespace apc::site {

namespace {

constexpr double a = 6378137.0, f = 1 / 298.257223563, b = a * (1 - f);

/// Vincenty's series, eq. 3, 4, 6 and 10, of one geodesic with cos²α.
struct Series {
  double A, B, C;
  explicit Series(double cos2_alpha) {
    const double u2 = cos2_alpha * (a * a - b * b) / (b * b);
    A = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)));
    B = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)));
    C = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha));
  }
  double correction(double sin_s, double cos_s, double cos_m) const {
    return B * sin_s *
           (cos_m + B / 4 *
                        (cos_s * (-1 + 2 * cos_m * cos_m) -
                         B / 6 * cos_m * (-3 + 4 * sin_s * sin_s) * (-3 + 4 * cos_m * cos_m)));
  }
  /// Difference of the longitude on the sphere and on the ellipsoid, eq. 11.
  double swing(double sin_alpha, double sigma, double sin_s, double cos_s, double cos_m) const {
    return (1 - C) * f * sin_alpha * (sigma + C * sin_s * (cos_m + C * cos_s * (-1 + 2 * cos_m * cos_m)));
  }
};

double within_half_turn(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

Place away(const Place& from, double heading, double distance) {
  const double sin_h = std::sin(heading), cos_h = std::cos(heading);
  const double tan_u = (1 - f) * std::tan(from.latitude), cos_u = 1 / std::sqrt(1 + tan_u * tan_u),
               sin_u = tan_u * cos_u;
  const double sigma_1 = std::atan2(tan_u, cos_h), sin_alpha = cos_u * sin_h;
  const Series series(1 - sin_alpha * sin_alpha);
  double sigma = distance / (b * series.A), sin_s = 0.0, cos_s = 1.0, cos_m = 0.0;
  for (int round = 0; round < 50; ++round) {
    cos_m = std::cos(2 * sigma_1 + sigma), sin_s = std::sin(sigma), cos_s = std::cos(sigma);
    const double next = distance / (b * series.A) + series.correction(sin_s, cos_s, cos_m);
    const bool settled = std::abs(next - sigma) < 1e-15;
    sigma = next;
    if (settled) break;
  }
  sin_s = std::sin(sigma), cos_s = std::cos(sigma), cos_m = std::cos(2 * sigma_1 + sigma);
  const double x = sin_u * sin_s - cos_u * cos_s * cos_h;
  const double latitude = std::atan2(sin_u * cos_s + cos_u * sin_s * cos_h, (1 - f) * std::hypot(sin_alpha, x));
  const double lambda = std::atan2(sin_s * sin_h, cos_u * cos_s - sin_u * sin_s * cos_h);
  const double swing = series.swing(sin_alpha, sigma, sin_s, cos_s, cos_m);
  return {latitude, within_half_turn(from.longitude + lambda - swing)};
}

Way way(const Place& from, const Place& to) {
  const double u1 = std::atan((1 - f) * std::tan(from.latitude)), u2 = std::atan((1 - f) * std::tan(to.latitude));
  const double sin_1 = std::sin(u1), cos_1 = std::cos(u1), sin_2 = std::sin(u2), cos_2 = std::cos(u2);
  const double apart = within_half_turn(to.longitude - from.longitude);
  double lambda = apart;
  for (int round = 0; round < 200; ++round) {
    const double sin_l = std::sin(lambda), cos_l = std::cos(lambda);
    const double sin_s = std::hypot(cos_2 * sin_l, cos_1 * sin_2 - sin_1 * cos_2 * cos_l);
    if (sin_s == 0.0) return {};  // one and the same place
    const double cos_s = sin_1 * sin_2 + cos_1 * cos_2 * cos_l, sigma = std::atan2(sin_s, cos_s);
    const double sin_alpha = cos_1 * cos_2 * sin_l / sin_s, cos2_alpha = 1 - sin_alpha * sin_alpha;
    const double cos_m = cos2_alpha > 1e-15 ? cos_s - 2 * sin_1 * sin_2 / cos2_alpha : 0.0;  // 0 along the equator
    const Series series(cos2_alpha);
    const double next = apart + series.swing(sin_alpha, sigma, sin_s, cos_s, cos_m);
    if (std::abs(next - lambda) > 1e-14) {
      lambda = next;
      continue;
    }
    const double heading = std::atan2(cos_2 * sin_l, cos_1 * sin_2 - sin_1 * cos_2 * cos_l);
    return {b * series.A * (sigma - series.correction(sin_s, cos_s, cos_m)),
            heading < 0 ? heading + 2 * std::numbers::pi : heading};
  }
  throw SolveError("the shortest way between two places nearly opposite on the earth does not settle");
}

}  // namespace apc::site
