#include "loadtables/load_table.h"

#include <cmath>

#include "loadtables/load_table_data.h"
#include "loadtables/spline_sum.h"

namespace apc::loadtables {
namespace {

/// Place of a contact on the table's axes.
struct Place {
  double speed, u, ratio, scale;  ///< scale = P_max
};

Place place(const LoadTable::Data& data, const TireContact& contact) {
  const double depth = contact.bed_depth > 0.0 ? contact.bed_depth : 0.0;
  const double scale = data.penetration.at(depth);
  return {std::abs(contact.speed), DepthScale::at(depth), contact.penetration / scale, scale};
}

const double* line(const LoadTable::Data& data, const Weights& v, int i, const Weights& u, int j, const Weights& r) {
  const std::size_t depth = static_cast<std::size_t>(data.depth.coefficients()),
                    ratio = static_cast<std::size_t>(data.ratio.coefficients());
  return data.coefficients.data() +
         ((static_cast<std::size_t>(v.first + i) * depth + static_cast<std::size_t>(u.first + j)) * ratio +
          static_cast<std::size_t>(r.first)) *
             responses;
}

SplineCell cell(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r) {
  const std::size_t by_j = static_cast<std::size_t>(data.ratio.coefficients()) * responses;
  return {line(data, v, 0, u, 0, r),
          static_cast<std::size_t>(data.depth.coefficients()) * by_j,
          by_j,
          v.value,
          u.value,
          r.value,
          v.slope,
          u.slope,
          r.slope};
}

void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r,
              double (&value)[responses]) {
  spline_kernels().value(cell(data, v, u, r), value);
}

void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r, SplineSums& point) {
  spline_kernels().slopes(cell(data, v, u, r), point);
}

/// Continuation z → φ(z) of value/edge value that stays positive: z down to ½, an exponential below; C¹.
double positive(double z) { return z >= 0.5 ? z : 0.5 * std::exp(2.0 * z - 1.0); }
double positive_slope(double z) { return z >= 0.5 ? 1.0 : std::exp(2.0 * z - 1.0); }

bool beyond(const Axis& axis, double x) { return x < axis.low || x > axis.high(); }

bool outside(const LoadTable::Data& data, const Place& at) {
  return beyond(data.speed, at.speed) || beyond(data.depth, at.u) || beyond(data.ratio, at.ratio);
}

Place nearest_inside(const LoadTable::Data& data, Place at) {
  at.speed = std::clamp(at.speed, data.speed.low, data.speed.high());
  at.u = std::clamp(at.u, data.depth.low, data.depth.high());
  at.ratio = std::clamp(at.ratio, data.ratio.low, data.ratio.high());
  return at;
}

/// Keeps drag, vertical and rut positive where a linear continuation would not.
void keep_positive(const LoadTable::Data& data, const Place& at, double (&value)[responses]) {
  const auto edge = nearest_inside(data, at);
  double inside[responses];
  evaluate(data, weights(data.speed, edge.speed), weights(data.depth, edge.u), weights(data.ratio, edge.ratio), inside);
  for (std::size_t m = drag; m <= rut_depth; ++m)
    if (value[m] < 0.5 * inside[m]) value[m] = inside[m] * positive(value[m] / inside[m]);
}

void keep_positive(const LoadTable::Data& data, const Place& at, SplineSums& point) {
  const auto edge = nearest_inside(data, at);
  SplineSums inside;
  evaluate(data, weights(data.speed, edge.speed), weights(data.depth, edge.u), weights(data.ratio, edge.ratio), inside);
  if (edge.speed != at.speed)
    for (auto& slope : inside.by_v) slope = 0.0;
  if (edge.u != at.u)
    for (auto& slope : inside.by_u) slope = 0.0;
  if (edge.ratio != at.ratio)
    for (auto& slope : inside.by_r) slope = 0.0;
  for (std::size_t m = drag; m <= rut_depth; ++m) {
    if (point.value[m] >= 0.5 * inside.value[m] || inside.value[m] <= 0.0) continue;
    const double z = point.value[m] / inside.value[m], of_line = positive_slope(z), of_edge = positive(z) - z * of_line;
    point.value[m] = inside.value[m] * positive(z);
    point.by_v[m] = of_line * point.by_v[m] + of_edge * inside.by_v[m];
    point.by_u[m] = of_line * point.by_u[m] + of_edge * inside.by_u[m];
    point.by_r[m] = of_line * point.by_r[m] + of_edge * inside.by_r[m];
  }
}

}  // namespace

double DepthScale::at(double bed_depth) { return std::sqrt(1.0 + bed_depth / reference); }
double DepthScale::slope(double bed_depth) { return 0.5 / (reference * at(bed_depth)); }
double DepthScale::depth(double u) { return reference * (u * u - 1.0); }

LoadTable::LoadTable() = default;
LoadTable::~LoadTable() = default;
LoadTable::LoadTable(LoadTable&&) noexcept = default;
LoadTable& LoadTable::operator=(LoadTable&&) noexcept = default;
LoadTable::LoadTable(const LoadTable&) = default;
LoadTable& LoadTable::operator=(const LoadTable&) = default;
LoadTable::LoadTable(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

TireLoad LoadTable::load(const TireContact& contact) const {
  if (!(contact.penetration > 0.0)) return {};
  const auto at = place(*data_, contact);
  double value[responses];
  evaluate(*data_, weights(data_->speed, at.speed), weights(data_->depth, at.u), weights(data_->ratio, at.ratio),
           value);
  if (outside(*data_, at)) [[unlikely]]
    keep_positive(*data_, at, value);
  return {value[drag], value[vertical], value[rut_depth], 1.0 - value[slip]};
}

LoadWithSlopes LoadTable::load_with_slopes(const TireContact& contact) const {
  if (!(contact.penetration > 0.0)) return {};
  const auto at = place(*data_, contact);
  SplineSums point;
  evaluate(*data_, weights(data_->speed, at.speed), weights(data_->depth, at.u), weights(data_->ratio, at.ratio),
           point);
  if (outside(*data_, at)) [[unlikely]]
    keep_positive(*data_, at, point);
  // r = P / P_max(h): the depth moves both u and, at fixed penetration, r.
  const double depth = contact.bed_depth > 0.0 ? contact.bed_depth : 0.0;
  const double per_penetration = 1.0 / at.scale;
  const double u_by_depth = contact.bed_depth < 0.0 ? 0.0 : DepthScale::slope(depth);
  const double ratio_by_depth =
      contact.bed_depth < 0.0 ? 0.0 : -at.ratio * data_->penetration.slope(depth) * per_penetration;
  const double direction = contact.speed < 0.0 ? -1.0 : 1.0;
  const auto slopes = [&](std::size_t m, double sign) {
    return Slopes{sign * direction * point.by_v[m],
                  sign * (point.by_u[m] * u_by_depth + point.by_r[m] * ratio_by_depth),
                  sign * point.by_r[m] * per_penetration};
  };
  return {{point.value[drag], point.value[vertical], point.value[rut_depth], 1.0 - point.value[slip]},
          slopes(drag, 1.0),
          slopes(vertical, 1.0),
          slopes(rut_depth, 1.0),
          slopes(slip, -1.0)};
}

Coverage LoadTable::coverage(const TireContact& contact) const {
  if (!(contact.penetration > 0.0)) return {};
  const double depth = contact.bed_depth > 0.0 ? contact.bed_depth : 0.0, speed = std::abs(contact.speed);
  constexpr double slack = 1.0 + 1e-9;  // a contact made from the range's own limits is inside
  Coverage coverage;
  // On pavement the loads do not depend on speed.
  coverage.speed = depth == 0.0 || (speed * slack >= data_->speeds[0] && speed <= data_->speeds[1] * slack);
  coverage.bed_depth = depth <= data_->depths[1] * slack;
  coverage.penetration = contact.penetration / data_->penetration.at(depth) <= data_->ratios[1] * slack;
  return coverage;
}

double LoadTable::maximum_penetration(double bed_depth) const {
  return data_->penetration.at(bed_depth > 0.0 ? bed_depth : 0.0);
}

const TableTire& LoadTable::tire() const { return data_->tire; }
const Provenance& LoadTable::provenance() const { return data_->provenance; }
const std::vector<FitQuality>& LoadTable::quality() const { return data_->quality; }
std::array<double, 2> LoadTable::speed_range() const { return data_->speeds; }
std::array<double, 2> LoadTable::depth_range() const { return data_->depths; }
std::array<double, 2> LoadTable::ratio_range() const { return data_->ratios; }

}  // namespace apc::loadtables
