#include "sph_backend/tire_shape.h"

#include <algorithm>
#include <cmath>

#include "apc/base/curve.h"

namespace apc::sph {
namespace {

MonotoneCurve catalogue(const TireShape& tire) {
  return MonotoneCurve({0.0, tire.rated_deflection, tire.bottoming_deflection},
                       {0.0, tire.rated_load, tire.bottoming_load});
}

constexpr double flange = 0.8;           // half-width at the rim over the greatest half-width
constexpr double side_axis = 1.0 / 0.6;  // √(1 − 0.8²) = 0.6: ellipse that reaches it at the rim

}  // namespace

double catalogue_load(const TireShape& tire, double deflection) { return catalogue(tire)(deflection); }
double catalogue_deflection(const TireShape& tire, double load) { return catalogue(tire).inverse(load); }

double maximum_penetration(const TireShape& tire, double bed_depth) {
  return std::min(0.85 * bed_depth + catalogue_deflection(tire, 0.8 * tire.bottoming_load), tire.diameter);
}

Section section(const TireShape& tire) {
  const double b = 0.25 * (tire.diameter - tire.rim_diameter);
  return {0.5 * tire.width, b, 0.5 * tire.diameter - b};
}

SectionPoint Section::at(double r, double y) const {
  if (r < -radial) return {y - flange * lateral, 0.0, 1.0};
  const double b = r < 0.0 ? radial * side_axis : radial;
  const double f = std::max(std::hypot(r / b, y / lateral), 1e-6);
  const double hr = r / (b * b), hy = y / (lateral * lateral), h = std::max(std::hypot(hr, hy), 1e-9);
  // d = f (f - 1)/h; with f' = (hr, hy)/f
  const double first = (2.0 * f - 1.0) / (f * h), second = f * (f - 1.0) / (h * h * h);
  return {f * (f - 1.0) / h, hr * (first - second / (b * b)), hy * (first - second / (lateral * lateral))};
}

}  // namespace apc::sph
