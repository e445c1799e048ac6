#include "apc/site/geodesy.h"

#include <cmath>
#include <numbers>

namespace apc::site {

Place away(const Place& from, double heading, double distance) {
  constexpr double a = 6378137.0, f = 1 / 298.257223563, b = a * (1 - f);
  const double sin_h = std::sin(heading), cos_h = std::cos(heading);
  const double tan_u = (1 - f) * std::tan(from.latitude), cos_u = 1 / std::sqrt(1 + tan_u * tan_u),
               sin_u = tan_u * cos_u;
  const double sigma_1 = std::atan2(tan_u, cos_h), sin_alpha = cos_u * sin_h, cos2_alpha = 1 - sin_alpha * sin_alpha;
  const double u2 = cos2_alpha * (a * a - b * b) / (b * b);
  const double A = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)));
  const double B = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)));
  double sigma = distance / (b * A), sin_s = 0.0, cos_s = 1.0, cos_m = 0.0;
  for (int round = 0; round < 50; ++round) {
    cos_m = std::cos(2 * sigma_1 + sigma), sin_s = std::sin(sigma), cos_s = std::cos(sigma);
    const double change = B * sin_s *
                          (cos_m + B / 4 *
                                       (cos_s * (-1 + 2 * cos_m * cos_m) -
                                        B / 6 * cos_m * (-3 + 4 * sin_s * sin_s) * (-3 + 4 * cos_m * cos_m)));
    const double next = distance / (b * A) + change;
    const bool settled = std::abs(next - sigma) < 1e-15;
    sigma = next;
    if (settled) break;
  }
  sin_s = std::sin(sigma), cos_s = std::cos(sigma), cos_m = std::cos(2 * sigma_1 + sigma);
  const double x = sin_u * sin_s - cos_u * cos_s * cos_h;
  const double latitude = std::atan2(sin_u * cos_s + cos_u * sin_s * cos_h, (1 - f) * std::hypot(sin_alpha, x));
  const double lambda = std::atan2(sin_s * sin_h, cos_u * cos_s - sin_u * sin_s * cos_h);
  const double C = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha));
  const double L =
      lambda - (1 - C) * f * sin_alpha * (sigma + C * sin_s * (cos_m + C * cos_s * (-1 + 2 * cos_m * cos_m)));
  double longitude = from.longitude + L;
  if (longitude > std::numbers::pi) longitude -= 2 * std::numbers::pi;
  if (longitude < -std::numbers::pi) longitude += 2 * std::numbers::pi;
  return {latitude, longitude};
}

}  // namespace apc::site
