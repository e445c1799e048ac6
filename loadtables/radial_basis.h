/// Radial-basis metamodel with a linear tail, ŷ(x) = Σ_i c_i φ(‖x − x_i‖) + b·(1, x), regularised by λ on the diagonal.
///
/// Kernel, shape, λ and the weight of the first input are chosen by the error of leaving samples out, which needs no
/// refit: with A = [Φ + λI, P; Pᵀ, 0],  y_i − ŷ₋ᵢ(x_i) = (A⁻¹ y)_i / (A⁻¹)_ii  (Rippa 1999, Adv. Comput. Math. 11,
/// 193–210, for λ = 0; the same identity holds with λ and tail: Dubrule 1983, Math. Geology 15, 687–699); a group G
/// left out at once has the residuals ((A⁻¹)_GG)⁻¹ (A⁻¹ y)_G. Samples with the same last input are left out together.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace apc::loadtables {

enum class Kernel { multiquadric, gaussian, thin_plate, cubic };
const char* text(Kernel);

/// Settings of a metamodel. Distances are between inputs scaled to [0, 1], the first one weighted.
struct RadialBasisShape {
  Kernel kernel = Kernel::cubic;
  double shape = 1.0;         ///< ε in φ(ε r); unused by thin plate and cubic
  double regularisation = 0;  ///< λ
  double first_weight = 1.0;  ///< < 1: the response varies slowly with the first input
};

class RadialBasis {
 public:
  /// `inputs` N × d in [0, 1], `values` N, `trust` N in (0, 1]: sample i is regularised by λ/trust_i. Columns of
  /// `inputs` that do not vary carry no tail.
  RadialBasis(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& values, const Eigen::VectorXd& trust,
              const RadialBasisShape&);
  double operator()(const Eigen::RowVectorXd& input) const;
  const RadialBasisShape& shape() const { return shape_; }
  /// y_i − ŷ₋ᵢ(x_i) for every sample.
  const Eigen::VectorXd& leave_one_out() const { return leave_one_out_; }

 private:
  RadialBasisShape shape_;
  Eigen::MatrixXd centres_;  // N × d, first column weighted
  Eigen::VectorXd coefficients_, tail_, leave_one_out_;
};

/// One model per column of `values`, each with its own best shape; errors count by the trust in their sample. Above 150
/// samples the shape is searched on a subset.
std::vector<RadialBasis> fit_radial_basis(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& values,
                                          const Eigen::VectorXd& trust);

}  // namespace apc::loadtables
