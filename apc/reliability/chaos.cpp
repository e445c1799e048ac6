#include "apc/reliability/chaos.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "apc/base/require.h"

namespace apc::reliability {

Chaos::Chaos(const std::vector<std::vector<double>>& u, const std::vector<double>& values) : inputs_(u.front().size()) {
  const auto rows = static_cast<Eigen::Index>(u.size());
  const auto columns = static_cast<Eigen::Index>(terms(inputs_));
  expect(rows > columns, "a chaos expansion needs more samples than terms");
  Eigen::MatrixXd A(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) A.row(i) = row(u[static_cast<std::size_t>(i)]);
  const Eigen::Map<const Eigen::VectorXd> y(values.data(), rows);
  coefficients_ = (A.transpose() * A).ldlt().solve(A.transpose() * y);
  variance_ = (y.array() - y.mean()).square().sum();
  unexplained_ = variance_ > 0 ? (y - A * coefficients_).squaredNorm() / variance_ : 0.0;
}

Eigen::RowVectorXd Chaos::row(const std::vector<double>& u) const {
  std::vector<double> p1, p2, out{1.0};
  for (const double each : u) {
    const double x = 2 * each - 1;
    p1.push_back(std::sqrt(3.0) * x), p2.push_back(std::sqrt(5.0) * 0.5 * (3 * x * x - 1));  // orthonormal
  }
  out.insert(out.end(), p1.begin(), p1.end());
  out.insert(out.end(), p2.begin(), p2.end());
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = i + 1; j < u.size(); ++j) out.push_back(p1[i] * p1[j]);
  return Eigen::Map<Eigen::RowVectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

double Chaos::operator()(const std::vector<double>& u) const { return row(u).dot(coefficients_); }

std::vector<SobolIndex> Chaos::indices() const {
  const double total = coefficients_.tail(coefficients_.size() - 1).squaredNorm();
  const double explained = 1 - unexplained_;
  std::vector<SobolIndex> out(inputs_);
  if (total <= 0) return out;
  const auto square = [&](std::size_t i) {
    return explained * std::pow(coefficients_[static_cast<Eigen::Index>(i)], 2) / total;
  };
  for (std::size_t i = 0; i < inputs_; ++i) out[i].first = out[i].total = square(1 + i) + square(1 + inputs_ + i);
  std::size_t pair = 1 + 2 * inputs_;
  for (std::size_t i = 0; i < inputs_; ++i)
    for (std::size_t j = i + 1; j < inputs_; ++j, ++pair) out[i].total += square(pair), out[j].total += square(pair);
  return out;
}

}  // namespace apc::reliability
