#include "loadtables/load_table.h"

#include <Eigen/Core>
#include <cmath>

#include "loadtables/load_table_data.h"

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

/// Four responses and, per axis, their derivatives.
struct Point {
  double value[responses], by_speed[responses], by_u[responses], by_ratio[responses];
};

const double* line(const LoadTable::Data& data, const Weights& v, int i, const Weights& u, int j, const Weights& r) {
  const std::size_t depth = static_cast<std::size_t>(data.depth.coefficients()),
                    ratio = static_cast<std::size_t>(data.ratio.coefficients());
  return data.coefficients.data() +
         ((static_cast<std::size_t>(v.first + i) * depth + static_cast<std::size_t>(u.first + j)) * ratio +
          static_cast<std::size_t>(r.first)) *
             responses;
}

/// The 4 × 4 coefficients along r are neighbours in memory: they are summed over speed and depth first, as sixteen
/// independent sums that the compiler keeps in vector registers.
void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r,
              double (&value)[responses]) {
  using Run = Eigen::Array<double, 4 * int(responses), 1>;
  Run sum = Run::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) sum += v.value[i] * u.value[j] * Eigen::Map<const Run>(line(data, v, i, u, j, r));
  for (std::size_t m = 0; m < responses; ++m)
    value[m] = r.value[0] * sum[static_cast<Eigen::Index>(m)] + r.value[1] * sum[static_cast<Eigen::Index>(m) + 4] +
               r.value[2] * sum[static_cast<Eigen::Index>(m) + 8] + r.value[3] * sum[static_cast<Eigen::Index>(m) + 12];
}

void evaluate(const LoadTable::Data& data, const Weights& v, const Weights& u, const Weights& r, Point& point) {
  point = {};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double* c = line(data, v, i, u, j, r);
      const double vu = v.value[i] * u.value[j], dv = v.slope[i] * u.value[j], du = v.value[i] * u.slope[j];
      for (std::size_t m = 0; m < responses; ++m) {
        const double along = r.value[0] * c[m] + r.value[1] * c[4 + m] + r.value[2] * c[8 + m] + r.value[3] * c[12 + m];
        const double slope = r.slope[0] * c[m] + r.slope[1] * c[4 + m] + r.slope[2] * c[8 + m] + r.slope[3] * c[12 + m];
        point.value[m] += vu * along;
        point.by_speed[m] += dv * along;
        point.by_u[m] += du * along;
        point.by_ratio[m] += vu * slope;
      }
    }
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

void keep_positive(const LoadTable::Data& data, const Place& at, Point& point) {
  const auto edge = nearest_inside(data, at);
  Point inside;
  evaluate(data, weights(data.speed, edge.speed), weights(data.depth, edge.u), weights(data.ratio, edge.ratio), inside);
  if (edge.speed != at.speed)
    for (auto& slope : inside.by_speed) slope = 0.0;
  if (edge.u != at.u)
    for (auto& slope : inside.by_u) slope = 0.0;
  if (edge.ratio != at.ratio)
    for (auto& slope : inside.by_ratio) slope = 0.0;
  for (std::size_t m = drag; m <= rut_depth; ++m) {
    if (point.value[m] >= 0.5 * inside.value[m] || inside.value[m] <= 0.0) continue;
    const double z = point.value[m] / inside.value[m], of_line = positive_slope(z), of_edge = positive(z) - z * of_line;
    point.value[m] = inside.value[m] * positive(z);
    point.by_speed[m] = of_line * point.by_speed[m] + of_edge * inside.by_speed[m];
    point.by_u[m] = of_line * point.by_u[m] + of_edge * inside.by_u[m];
    point.by_ratio[m] = of_line * point.by_ratio[m] + of_edge * inside.by_ratio[m];
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
  Point point;
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
    return Slopes{sign * direction * point.by_speed[m],
                  sign * (point.by_u[m] * u_by_depth + point.by_ratio[m] * ratio_by_depth),
                  sign * point.by_ratio[m] * per_penetration};
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
