#include "loadtables/radial_basis.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace apc::loadtables {
namespace {

/// φ(r), signed so that Φ is positive definite on the complement of the tail.
double kernel_value(const RadialBasisShape& shape, double squared_distance) {
  const double scaled = shape.shape * shape.shape * squared_distance;
  switch (shape.kernel) {
    case Kernel::multiquadric:
      return -std::sqrt(1.0 + scaled);
    case Kernel::gaussian:
      return std::exp(-scaled);
    case Kernel::thin_plate:
      return squared_distance > 0.0 ? 0.5 * squared_distance * std::log(squared_distance) : 0.0;
    case Kernel::cubic:
      return squared_distance * std::sqrt(squared_distance);
  }
  return 0.0;
}

Eigen::MatrixXd weighted(const Eigen::MatrixXd& inputs, double first_weight) {
  Eigen::MatrixXd result = inputs;
  result.col(0) *= first_weight;
  return result;
}

/// Tail columns: 1 and every input that varies.
Eigen::MatrixXd tail_columns(const Eigen::MatrixXd& inputs) {
  Eigen::MatrixXd tail = Eigen::MatrixXd::Ones(inputs.rows(), 1);
  for (Eigen::Index column = 0; column < inputs.cols(); ++column) {
    if (inputs.col(column).maxCoeff() - inputs.col(column).minCoeff() < 1e-9) continue;
    tail.conservativeResize(Eigen::NoChange, tail.cols() + 1);
    tail.rightCols(1) = inputs.col(column);
  }
  return tail;
}

Eigen::MatrixXd inverse_system(const Eigen::MatrixXd& centres, const Eigen::VectorXd& trust,
                               const RadialBasisShape& shape) {
  const auto tail = tail_columns(centres);
  const Eigen::Index count = centres.rows(), extra = tail.cols();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + extra, count + extra);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      system(i, j) = system(j, i) = kernel_value(shape, (centres.row(i) - centres.row(j)).squaredNorm());
  system.topLeftCorner(count, count).diagonal().array() += shape.regularisation / trust.array();
  system.topRightCorner(count, extra) = tail;
  system.bottomLeftCorner(extra, count) = tail.transpose();
  return system.partialPivLu().inverse();
}

/// Residuals of all columns, NaN when the system was singular.
Eigen::MatrixXd leave_one_out_of(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& values) {
  const Eigen::Index count = values.rows();
  const Eigen::VectorXd diagonal = inverse.diagonal().head(count);
  return (inverse.topLeftCorner(count, count) * values).array().colwise() / diagonal.array();
}

/// Groups of rows that share their last input; samples on a grid come in such layers.
std::vector<std::vector<Eigen::Index>> layers(const Eigen::MatrixXd& inputs) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(inputs.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto last = inputs.col(inputs.cols() - 1);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return last(a) < last(b); });
  std::vector<std::vector<Eigen::Index>> groups;
  for (const auto row : order)
    if (groups.empty() || last(row) - last(groups.back().back()) > 4e-3)
      groups.push_back({row});
    else
      groups.back().push_back(row);
  return groups;
}

/// Mean square errors of leaving out one sample at a time, plus those of leaving out one layer at a time, the outermost
/// two kept: a grid's layers hide ripples between them from plain leave-one-out, whose neighbours lie in the same
/// layer.
Eigen::VectorXd left_out_errors(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& values,
                                const Eigen::VectorXd& trust, const std::vector<std::vector<Eigen::Index>>& groups) {
  const Eigen::Index count = values.rows();
  const Eigen::MatrixXd coefficients = inverse.topLeftCorner(count, count) * values;
  Eigen::VectorXd squares =
      (leave_one_out_of(inverse, values).array().square().colwise() * trust.array()).colwise().sum().transpose();
  for (std::size_t g = 1; g + 1 < groups.size(); ++g) {
    const Eigen::MatrixXd block = inverse(groups[g], groups[g]);
    const Eigen::MatrixXd residual = block.partialPivLu().solve(coefficients(groups[g], Eigen::all));
    squares += (residual.array().square().colwise() * trust(groups[g]).array()).colwise().sum().matrix().transpose();
  }
  return squares / static_cast<double>(count);
}

/// λ never vanishes: flat kernels without it lose ten digits, and with them the same answer on every machine.
std::vector<RadialBasisShape> candidates() {
  std::vector<RadialBasisShape> list;
  for (const double weight : {0.15, 0.4, 1.0})
    for (const double regularisation : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
      for (const double shape : {0.5, 1.0, 2.0, 4.0}) {
        list.push_back({Kernel::multiquadric, shape, regularisation, weight});
        list.push_back({Kernel::gaussian, shape, regularisation, weight});
      }
      list.push_back({Kernel::thin_plate, 1.0, regularisation, weight});
      list.push_back({Kernel::cubic, 1.0, regularisation, weight});
    }
  return list;
}

}  // namespace

const char* text(Kernel kernel) {
  switch (kernel) {
    case Kernel::multiquadric:
      return "multiquadric";
    case Kernel::gaussian:
      return "Gaussian";
    case Kernel::thin_plate:
      return "thin plate";
    case Kernel::cubic:
      return "cubic";
  }
  return "";
}

RadialBasis::RadialBasis(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& values, const Eigen::VectorXd& trust,
                         const RadialBasisShape& shape)
    : shape_(shape), centres_(weighted(inputs, shape.first_weight)) {
  const auto inverse = inverse_system(centres_, trust, shape_);
  const Eigen::Index count = values.size();
  leave_one_out_ = leave_one_out_of(inverse, values);
  coefficients_ = inverse.topLeftCorner(count, count) * values;
  const Eigen::VectorXd beta = inverse.bottomLeftCorner(inverse.rows() - count, count) * values;
  tail_ = Eigen::VectorXd::Zero(inputs.cols() + 1);
  tail_(0) = beta(0);
  for (Eigen::Index column = 0, next = 1; column < inputs.cols(); ++column)
    if (centres_.col(column).maxCoeff() - centres_.col(column).minCoeff() >= 1e-9) tail_(column + 1) = beta(next++);
}

double RadialBasis::operator()(const Eigen::RowVectorXd& input) const {
  Eigen::RowVectorXd at = input;
  at(0) *= shape_.first_weight;
  double sum = tail_(0) + at.dot(tail_.tail(at.size()));
  for (Eigen::Index i = 0; i < centres_.rows(); ++i)
    sum += coefficients_(i) * kernel_value(shape_, (centres_.row(i) - at).squaredNorm());
  return sum;
}

std::vector<RadialBasis> fit_radial_basis(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& values,
                                          const Eigen::VectorXd& trust) {
  constexpr Eigen::Index most = 150;
  const Eigen::Index stride = (inputs.rows() + most - 1) / most, used = (inputs.rows() + stride - 1) / stride;
  Eigen::MatrixXd search_inputs(used, inputs.cols()), search_values(used, values.cols());
  Eigen::VectorXd search_trust(used);
  for (Eigen::Index i = 0; i < used; ++i) {
    search_inputs.row(i) = inputs.row(i * stride);
    search_values.row(i) = values.row(i * stride);
    search_trust(i) = trust(i * stride);
  }
  const auto groups = layers(search_inputs);
  std::vector<RadialBasisShape> best(static_cast<std::size_t>(values.cols()));
  std::vector<double> least(best.size(), std::numeric_limits<double>::infinity());
  for (const auto& candidate : candidates()) {
    const auto inverse = inverse_system(weighted(search_inputs, candidate.first_weight), search_trust, candidate);
    const auto errors = left_out_errors(inverse, search_values, search_trust, groups);
    for (std::size_t k = 0; k < best.size(); ++k) {
      const double error = errors(static_cast<Eigen::Index>(k));
      if (error < least[k]) least[k] = error, best[k] = candidate;
    }
  }
  std::vector<RadialBasis> models;
  for (std::size_t k = 0; k < best.size(); ++k)
    models.emplace_back(inputs, values.col(static_cast<Eigen::Index>(k)), trust, best[k]);
  return models;
}

}  // namespace apc::loadtables
