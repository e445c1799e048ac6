#include "loadtables/load_table.h"

#include <cmath>

#include "loadtables/out_of_range.h"
#include "loadtables/table_lanes.h"
#include "loadtables/table_point.h"

namespace apc::loadtables {

struct LoadTable::Derived {
  double per_speed, per_depth, per_ratio;  ///< 1/step of the axes
  double speeds, depths, ratios;           ///< intervals of the axes that the look-ups use
  std::size_t by_speed, by_depth;          ///< distances of neighbours among the coefficients
  const SplineKernels& kernels;
  Edge edge;                     ///< what the tire stands on beyond P_max
  double pavement_scale;         ///< P_max(0)
  std::vector<double> pavement;  ///< (ratio + 2) × responses
  std::vector<double> level;     ///< at no depth: (speed + 2) × (ratio + 2) × responses
};

namespace {

/// The four weights at s ≥ 0 intervals above the lower end, nothing else; returns the first coefficient.
inline int weights_inside(double s, int last, double* w) {
  const int first = std::min(static_cast<int>(s), last);
  const double t = s - first, q = 1.0 - t;
  w[0] = q * q * q * (1.0 / 6.0);
  w[1] = 2.0 / 3.0 - t * t * (1.0 - 0.5 * t);
  w[2] = 2.0 / 3.0 - q * q * (1.0 - 0.5 * q);
  w[3] = t * t * t * (1.0 / 6.0);
  return first;
}

LoadAlong along(const LoadWithSlopes& all) {
  return {all.load, all.drag.penetration, all.vertical.penetration, all.rut_depth.penetration,
          all.spin_ratio.penetration};
}

/// From four coefficients along r.
LoadAlong along(const double* c, const Weights& r, double per_penetration) {
  double value[responses], slope[responses];
  for (std::size_t m = 0; m < responses; ++m) {
    value[m] = (r.value[0] * c[m] + r.value[1] * c[4 + m]) + (r.value[2] * c[8 + m] + r.value[3] * c[12 + m]);
    slope[m] = (r.slope[0] * c[m] + r.slope[1] * c[4 + m]) + (r.slope[2] * c[8 + m] + r.slope[3] * c[12 + m]);
  }
  return {{value[drag], value[vertical], value[rut_depth], 1.0 - value[slip]},
          slope[drag] * per_penetration,
          slope[vertical] * per_penetration,
          slope[rut_depth] * per_penetration,
          -slope[slip] * per_penetration};
}

}  // namespace

namespace {

/// In the order of the look-ups' own sums, so that one over the result has the same bits.
std::vector<double> sum_over_depth(const LoadTable::Data& data, double bed_depth) {
  const double steps = (DepthScale::at(bed_depth) - data.depth.low) * (1.0 / data.depth.step);
  if (!(bed_depth >= 0.0 && steps >= 0.0 && steps <= data.depth.nodes - 1.0)) return {};
  double u[4];
  const auto first = static_cast<std::size_t>(weights_inside(steps, data.depth.nodes - 2, u));
  const auto length = static_cast<std::size_t>(data.ratio.coefficients()) * responses;
  const auto speeds = static_cast<std::size_t>(data.speed.coefficients());
  std::vector<double> sum(speeds * length);
  for (std::size_t i = 0; i < speeds; ++i) {
    const double* c =
        data.coefficients.data() + (i * static_cast<std::size_t>(data.depth.coefficients()) + first) * length;
    double* line = sum.data() + i * length;
    for (std::size_t k = 0; k < length; ++k)
      line[k] = u[0] * c[k] + u[1] * c[length + k] + u[2] * c[2 * length + k] + u[3] * c[3 * length + k];
  }
  return sum;
}

}  // namespace

std::vector<double> level_coefficients(const LoadTable& table, double bed_depth) {
  return sum_over_depth(table.data(), bed_depth);
}

double DepthScale::at(double bed_depth) { return std::sqrt(1.0 + bed_depth * (1.0 / reference)); }
double DepthScale::slope(double bed_depth) { return 0.5 / (reference * at(bed_depth)); }
double DepthScale::depth(double u) { return reference * (u * u - 1.0); }

LoadTable::LoadTable() = default;
LoadTable::~LoadTable() = default;
LoadTable::LoadTable(LoadTable&&) noexcept = default;
LoadTable& LoadTable::operator=(LoadTable&&) noexcept = default;
LoadTable::LoadTable(const LoadTable&) = default;
LoadTable& LoadTable::operator=(const LoadTable&) = default;

LoadTable::LoadTable(std::shared_ptr<const Data> data) : data_(std::move(data)) {
  const auto u = weights(data_->depth, DepthScale::at(0.0));
  const auto length = static_cast<std::size_t>(data_->ratio.coefficients()) * responses;
  std::vector<double> line(length);
  for (int i = 1; i <= data_->speed.nodes; ++i)
    for (int j = 0; j < 4; ++j) {
      const double* c =
          data_->coefficients.data() + static_cast<std::size_t>(i * data_->depth.coefficients() + u.first + j) * length;
      for (std::size_t k = 0; k < length; ++k) line[k] += u.value[j] / data_->speed.nodes * c[k];
    }
  const double last = last_ratio(data_->ratio);
  const auto r = weights(data_->ratio, last);
  const auto pavement = along(line.data() + 4 * r.first, r, 1.0).load;
  Edge edge{EdgeSheet(*data_, last),
            HardBase(data_->tire, data_->penetration.deflection, pavement.drag / pavement.vertical)};
  derived_ = std::make_shared<const Derived>(
      Derived{1.0 / data_->speed.step, 1.0 / data_->depth.step, 1.0 / data_->ratio.step, data_->speed.nodes - 1.0,
              data_->depth.nodes - 1.0, last_ratio_steps(data_->ratio),
              length * static_cast<std::size_t>(data_->depth.coefficients()), length, spline_kernels(), std::move(edge),
              data_->penetration.at(0.0), std::move(line), sum_over_depth(*data_, 0.0)});
}

TireLoad LoadTable::load(const TireContact& contact) const {
  if (!(contact.penetration > 0.0)) return {};
  const auto& data = *data_;
  const auto at = place(data, contact);
  const double v = (at.speed - data.speed.low) * derived_->per_speed, u = (at.u - data.depth.low) * derived_->per_depth,
               r = (at.ratio - data.ratio.low) * derived_->per_ratio;
  double value[responses];
  if (v >= 0.0 && u >= 0.0 && r >= 0.0 && v <= derived_->speeds && u <= derived_->depths && r <= derived_->ratios)
      [[likely]] {
    double weight[12];
    const int i = weights_inside(v, data.speed.nodes - 2, weight),
              j = weights_inside(u, data.depth.nodes - 2, weight + 4),
              k = weights_inside(r, data.ratio.nodes - 2, weight + 8);
    const double* first = data.coefficients.data() + static_cast<std::size_t>(i) * derived_->by_speed +
                          static_cast<std::size_t>(j) * derived_->by_depth + static_cast<std::size_t>(k) * responses;
    derived_->kernels.value(
        {first, derived_->by_speed, derived_->by_depth, weight, weight + 4, weight + 8, nullptr, nullptr, nullptr},
        value);
  } else {
    return plain_load_out_of_range(data, derived_->edge, contact);
  }
  return {value[drag], value[vertical], value[rut_depth], 1.0 - value[slip]};
}

LoadWithSlopes LoadTable::load_with_slopes(const TireContact& contact) const {
  if (!(contact.penetration > 0.0)) return {};
  if (out_of_range(*data_, contact)) [[unlikely]]
    return load_out_of_range(*data_, derived_->edge, contact);
  const auto at = place(*data_, contact);
  SplineSums point;
  evaluate(*data_, weights(data_->speed, derived_->per_speed, at.speed),
           weights(data_->depth, derived_->per_depth, at.u), weights(data_->ratio, derived_->per_ratio, at.ratio),
           point);
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

LoadAlong LoadTable::load_on_pavement(double penetration) const {
  if (!(penetration > 0.0)) return {};
  const double per_scale = 1.0 / derived_->pavement_scale, ratio = penetration * per_scale;
  if (beyond_ratio(data_->ratio, ratio)) [[unlikely]]
    return along(load_with_slopes({data_->speed.low, 0.0, penetration}));
  const auto r = weights(data_->ratio, derived_->per_ratio, ratio);
  return along(derived_->pavement.data() + 4 * r.first, r, per_scale);
}

PenetrationLine::PenetrationLine(const LoadTable& table, double speed, double bed_depth)
    : table_(table), speed_(speed), depth_(bed_depth) {
  const auto at = place(table.data(), {speed, bed_depth, 0.0});
  outside_ = out_of_range(table.data(), {speed, bed_depth, 0.0}) || table.data().ratio.coefficients() < window;
  scale_ = at.scale;
  const auto v = weights(table.data().speed, at.speed), u = weights(table.data().depth, at.u);
  speed_first_ = v.first;
  depth_first_ = u.first;
  std::copy(v.value, v.value + 4, speed_weight_);
  std::copy(u.value, u.value + 4, depth_weight_);
}

LoadAlong PenetrationLine::at(double penetration) {
  if (!(penetration > 0.0)) return {};
  const auto& data = table_.data();
  const double per_penetration = 1.0 / scale_, ratio = penetration * per_penetration;
  if (outside_ || beyond_ratio(data.ratio, ratio)) [[unlikely]]
    return along(table_.load_with_slopes({speed_, depth_, penetration}));
  const auto r = weights(data.ratio, ratio);
  if (first_ < 0 || r.first < first_ || r.first > first_ + window - 4) {
    first_ = std::clamp(r.first - 1, 0, data.ratio.coefficients() - window);
    const std::size_t by_j = static_cast<std::size_t>(data.ratio.coefficients()) * responses,
                      by_i = static_cast<std::size_t>(data.depth.coefficients()) * by_j;
    const double* first = data.coefficients.data() + static_cast<std::size_t>(speed_first_) * by_i +
                          static_cast<std::size_t>(depth_first_) * by_j + static_cast<std::size_t>(first_) * responses;
    spline_kernels().line({first, by_i, by_j, speed_weight_, depth_weight_, nullptr, nullptr, nullptr, nullptr}, sum_);
  }
  return along(sum_ + 4 * (r.first - first_), r, per_penetration);
}

static_assert(depth_reference == DepthScale::reference);

TableNumbers LoadTable::numbers() const {
  const auto& data = *data_;
  const double by_depth = static_cast<double>(data.ratio.coefficients()) * static_cast<double>(responses);
  return {data.coefficients.data(),
          this,
          data.speed.low,
          data.depth.low,
          data.ratio.low,
          1.0 / data.speed.step,
          1.0 / data.depth.step,
          1.0 / data.ratio.step,
          data.speed.nodes - 1.0,
          data.depth.nodes - 1.0,
          data.ratio.nodes - 1.0,
          last_ratio_steps(data.ratio),
          by_depth * static_cast<double>(data.depth.coefficients()),
          by_depth,
          data.penetration.compaction,
          data.penetration.deflection,
          data.penetration.diameter,
          data.penetration.rounding(),
          derived_->pavement.data(),
          derived_->level.empty() ? nullptr : derived_->level.data(),
          1.0 / derived_->pavement_scale};
}

void load_at(const LoadTable& table, double speed, double depth, double penetration, double* out, int stride) {
  const auto load = table.load({speed, depth, penetration});
  out[0] = load.drag, out[stride] = load.vertical, out[2 * stride] = load.rut_depth, out[3 * stride] = load.spin_ratio;
}

void load_with_slopes_at(const LoadTable& table, double speed, double depth, double penetration, double* out,
                         int stride) {
  const auto all = table.load_with_slopes({speed, depth, penetration});
  for (const double value : {all.load.drag, all.load.vertical, all.load.rut_depth, all.load.spin_ratio})
    *out = value, out += stride;
  for (const auto& slopes : {all.drag, all.vertical, all.rut_depth, all.spin_ratio})
    for (const double slope : {slopes.speed, slopes.bed_depth, slopes.penetration}) *out = slope, out += stride;
}

Coverage LoadTable::coverage(const TireContact& contact) const {
  return coverage(contact, maximum_penetration(contact.bed_depth));
}

Coverage LoadTable::coverage(const TireContact& contact, double maximum) const {
  if (!(contact.penetration > 0.0)) return {};
  const double depth = contact.bed_depth > 0.0 ? contact.bed_depth : 0.0, speed = std::abs(contact.speed);
  constexpr double slack = 1.0 + 1e-9;  // a contact made from the range's own limits is inside
  Coverage coverage;
  // On pavement the loads do not depend on speed.
  coverage.speed = depth == 0.0 || (speed * slack >= data_->speeds[0] && speed <= data_->speeds[1] * slack);
  coverage.bed_depth = depth <= data_->depths[1] * slack;
  coverage.penetration = contact.penetration / maximum <= data_->ratios[1] * slack;
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
