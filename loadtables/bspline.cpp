#include "loadtables/bspline.h"

#include <Eigen/LU>

#include "apc/base/require.h"

namespace apc::loadtables {

Axis axis(double low, double high, int nodes) {
  expect(nodes >= 4 && high > low, "a spline axis from ", low, " to ", high, " with ", nodes, " nodes");
  return {low, (high - low) / (nodes - 1), nodes};
}

Eigen::MatrixXd interpolation(const Axis& axis, LowerEnd lower) {
  const int nodes = axis.nodes, count = axis.coefficients();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count, count), data = Eigen::MatrixXd::Zero(count, nodes);
  const auto second_derivative = [&](int row, int at) {
    system(row, at) = 1.0, system(row, at + 1) = -2.0, system(row, at + 2) = 1.0;
  };
  int row = 0, first = 0;
  switch (lower) {
    case LowerEnd::linear:
      second_derivative(row++, 0);
      break;
    case LowerEnd::level:
      system(row, 0) = -1.0, system(row, 2) = 1.0;
      ++row;
      break;
    case LowerEnd::rest:
      for (int k = 0; k < 3; ++k, ++row) system(row, k) = 1.0;
      first = 2;
      break;
  }
  for (int node = first; node < nodes; ++node, ++row) {
    system(row, node) = 1.0 / 6.0, system(row, node + 1) = 4.0 / 6.0, system(row, node + 2) = 1.0 / 6.0;
    data(row, node) = 1.0;
  }
  second_derivative(row, count - 3);
  return system.partialPivLu().solve(data);
}

}  // namespace apc::loadtables
