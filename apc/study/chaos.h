/// Which scattering input moves a quantity: a polynomial chaos expansion of second order in Legendre polynomials of
/// uniform inputs (Sudret, Reliab. Eng. Syst. Saf. 93, 2008, 964–979), fitted by least squares. Its coefficients give
/// Sobol's indices directly; what it leaves unexplained is reported, not hidden.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace apc::study {

struct SobolIndex {
  double first = 0.0;  ///< share of the variance due to this input alone
  double total = 0.0;  ///< with its interactions
};

class Chaos {
 public:
  /// Rows of `u` in (0, 1), one value each. Needs more rows than terms: 1 + 2 d + d (d − 1)/2.
  Chaos(const std::vector<std::vector<double>>& u, const std::vector<double>& values);
  double operator()(const std::vector<double>& u) const;
  std::vector<SobolIndex> indices() const;
  double unexplained() const { return unexplained_; }  ///< 1 − R²: higher orders, and scatter that is no input

 private:
  Eigen::RowVectorXd terms(const std::vector<double>& u) const;
  std::size_t inputs_;
  Eigen::VectorXd coefficients_;
  double unexplained_ = 0.0, variance_ = 0.0;
};

}  // namespace apc::study
