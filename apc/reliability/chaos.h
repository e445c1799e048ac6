/// Which scattering input moves a quantity: a polynomial chaos expansion of second order in Legendre polynomials of
/// uniform inputs (Sudret, Reliab. Eng. Syst. Saf. 93, 2008, 964–979), fitted by least squares. Its coefficients give
/// Sobol's indices directly; what it leaves unexplained is reported, not hidden.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace apc::reliability {

struct SobolIndex {
  double first = 0.0;  ///< share of the variance due to this input alone
  double total = 0.0;  ///< with its interactions
};

class Chaos {
 public:
  /// Terms of an expansion in `inputs` inputs: 1 + 2 d + d (d − 1)/2.
  static constexpr std::size_t terms(std::size_t inputs) { return 1 + 2 * inputs + inputs * (inputs - 1) / 2; }
  /// Rows of `u` in (0, 1), one value each. Needs more rows than terms.
  Chaos(const std::vector<std::vector<double>>& u, const std::vector<double>& values);
  double operator()(const std::vector<double>& u) const;
  std::vector<SobolIndex> indices() const;
  double unexplained() const { return unexplained_; }  ///< 1 − R²: higher orders, and scatter that is no input

 private:
  Eigen::RowVectorXd row(const std::vector<double>& u) const;
  std::size_t inputs_;
  Eigen::VectorXd coefficients_;
  double unexplained_ = 0.0, variance_ = 0.0;
};

}  // namespace apc::reliability
