#include "loadtables/metamodel.h"

#include <cmath>

#include "apc/base/units.h"

namespace apc::loadtables {
namespace {

/// Follows x down to `low`, then bends within `width` to a constant; C¹.
double settled_below(double x, double low, double width) {
  const double under = low - x;
  if (under <= 0.0 || width <= 0.0) return std::max(x, low);
  return under >= width ? low - 0.5 * width : low - under + 0.5 * under * under / width;
}

double settled_above(double x, double high, double width) { return -settled_below(-x, -high, width); }

/// 0 → 1 with two vanishing derivatives at both ends.
double fade(double x) {
  if (x <= 0.0) return 0.0;
  return x >= 1.0 ? 1.0 : x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

double scaled(double x, double low, double high) { return high > low ? (x - low) / (high - low) : 0.0; }

Eigen::RowVectorXd input(const Metamodel& model, double speed, double depth, double ratio) {
  Eigen::RowVectorXd x(3);
  x << scaled(speed, model.speeds[0], model.speeds[1]),
      scaled(DepthScale::at(depth), DepthScale::at(model.depths[0]), DepthScale::at(model.depths[1])),
      scaled(ratio, model.ratios[0], model.ratios[1]);
  return x;
}

std::array<double, responses> as_responses(const TireLoad& load) {
  return {load.drag, load.vertical, load.rut_depth, 1.0 - load.spin_ratio};
}

/// Smallest response whose logarithm still means something: 1 % of the largest.
std::array<double, responses> floors(const std::vector<Sample>& samples) {
  std::array<double, responses> largest{};
  for (const auto& sample : samples) {
    const auto values = as_responses(sample.load);
    for (std::size_t m = 0; m < responses; ++m) largest[m] = std::max(largest[m], 0.01 * values[m]);
  }
  return largest;
}

/// Beyond the axle's height a wheel ploughs and its loads scatter: such samples are followed less closely, so that they
/// do not roughen the fit where tires ride.
double trust_in(const TireContact& contact, double radius) {
  const double beyond = std::max(contact.penetration / radius - 1.0, 0.0) / 0.25;
  return 1.0 / (1.0 + beyond * beyond);
}

std::array<double, 2> widened(std::array<double, 2> range, double value) {
  return {std::min(range[0], value), std::max(range[1], value)};
}

}  // namespace

std::vector<Sample> usable(const SampleSet& set) {
  std::vector<Sample> samples;
  for (const auto& sample : set.samples)
    if (sample.contact.bed_depth >= 2.0 * units::cm && sample.contact.penetration > 0.0) samples.push_back(sample);
  return samples;
}

std::array<double, responses> Metamodel::operator()(double speed, double bed_depth, double relative_penetration) const {
  const auto reference =
      as_responses(balance.load({speed, bed_depth, relative_penetration * penetration.at(bed_depth)}));
  const double share = fade(bed_depth / depths[0]);
  if (share == 0.0) return reference;
  const auto at =
      input(*this, settled_below(speed, speeds[0], speeds[0]), settled_below(bed_depth, depths[0], depths[0]),
            settled_above(settled_below(relative_penetration, ratios[0], ratios[0]), ratios[1], 0.05));
  std::array<double, responses> result{};
  for (std::size_t m = drag; m <= rut_depth; ++m) result[m] = reference[m] * std::exp(share * ratio[m](at));
  result[slip] = reference[slip] + share * ratio[slip](at);
  return result;
}

Metamodel learn(const std::vector<Sample>& samples, const TableTire& tire, double strength, double rolling_resistance) {
  Metamodel model;
  CrushBalance start;
  start.tire = MonotoneCurve(tire.curve_deflection, tire.curve_load);
  start.radius = 0.5 * tire.diameter;
  start.width = tire.width;
  start.strength = strength > 0.0 ? strength : 50.0 * units::psi;  // k_v and k_d take up the difference
  start.rolling_resistance = rolling_resistance;
  model.balance = calibrate(start, samples);
  model.penetration = penetration_scale(tire);

  const auto relative = [&](const TireContact& contact) {
    return contact.penetration / model.penetration.at(contact.bed_depth);
  };
  const auto& first = samples.front().contact;
  model.speeds = {first.speed, first.speed};
  model.depths = {first.bed_depth, first.bed_depth};
  model.ratios = {relative(first), relative(first)};
  for (const auto& sample : samples) {
    model.speeds = widened(model.speeds, sample.contact.speed);
    model.depths = widened(model.depths, sample.contact.bed_depth);
    model.ratios = widened(model.ratios, relative(sample.contact));
  }

  const auto count = static_cast<Eigen::Index>(samples.size());
  const auto floor = floors(samples);
  Eigen::VectorXd trust(count);
  Eigen::MatrixXd inputs(count, 3), values(count, static_cast<Eigen::Index>(responses));
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [contact, load] = samples[static_cast<std::size_t>(i)];
    trust(i) = trust_in(contact, 0.5 * tire.diameter);
    inputs.row(i) = input(model, contact.speed, contact.bed_depth, relative(contact));
    const auto reference = as_responses(model.balance.load(contact)), sampled = as_responses(load);
    for (std::size_t m = drag; m <= rut_depth; ++m)
      values(i, static_cast<Eigen::Index>(m)) =
          std::log(std::max(sampled[m], floor[m]) / std::max(reference[m], floor[m]));
    values(i, static_cast<Eigen::Index>(slip)) = sampled[slip] - reference[slip];
  }
  model.ratio = fit_radial_basis(inputs, values, trust);
  return model;
}

std::array<double, responses> leave_one_out_errors(const Metamodel& model, const std::vector<Sample>& samples,
                                                   double deepest) {
  std::array<double, responses> squares{}, means{};
  double count = 0.0;
  for (const auto& sample : samples) count += sample.contact.penetration <= deepest;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& [contact, load] = samples[i];
    if (contact.penetration > deepest) continue;
    const auto sampled = as_responses(load);
    for (std::size_t m = 0; m < responses; ++m) {
      const double residual = model.ratio[m].leave_one_out()(static_cast<Eigen::Index>(i));
      const double error = m == slip ? residual : sampled[m] * (1.0 - std::exp(-residual));
      squares[m] += error * error / count;
      means[m] += std::abs(m == slip ? load.spin_ratio : sampled[m]) / count;
    }
  }
  std::array<double, responses> errors{};
  for (std::size_t m = 0; m < responses; ++m) errors[m] = means[m] > 0.0 ? std::sqrt(squares[m]) / means[m] : 0.0;
  return errors;
}

}  // namespace apc::loadtables
