#include "loadtables/radial_basis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apc::loadtables {
namespace {

/// Halton points: spread, the same everywhere.
Eigen::MatrixXd points(Eigen::Index count) {
  Eigen::MatrixXd result(count, 3);
  const int bases[3] = {2, 3, 5};
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) {
      double value = 0.0, share = 1.0;
      for (Eigen::Index n = i + 1; n > 0; n /= bases[k]) {
        share /= bases[k];
        value += share * static_cast<double>(n % bases[k]);
      }
      result(i, k) = value;
    }
  return result;
}

double smooth(const Eigen::RowVectorXd& x) { return std::sin(3.0 * x(0)) + x(1) * x(1) * x(2); }

Eigen::VectorXd values(const Eigen::MatrixXd& at, double (*function)(const Eigen::RowVectorXd&)) {
  Eigen::VectorXd result(at.rows());
  for (Eigen::Index i = 0; i < at.rows(); ++i) result(i) = function(at.row(i));
  return result;
}

Eigen::VectorXd ones(const Eigen::MatrixXd& at) { return Eigen::VectorXd::Ones(at.rows()); }

TEST(RadialBasis, ReproducesLinearFunctionsExactly) {
  const auto at = points(25);
  const auto linear = +[](const Eigen::RowVectorXd& x) { return 2.0 - x(0) + 3.0 * x(1) - 0.5 * x(2); };
  for (const auto kernel : {Kernel::multiquadric, Kernel::gaussian, Kernel::thin_plate, Kernel::cubic}) {
    const RadialBasis model(at, values(at, linear), ones(at), {kernel, 1.0, 1e-3, 0.4});
    Eigen::RowVectorXd x(3);
    x << 0.31, 0.77, 1.4;
    EXPECT_NEAR(model(x), linear(x), 1e-8) << text(kernel);
    EXPECT_LT(model.leave_one_out().cwiseAbs().maxCoeff(), 1e-7) << text(kernel);
  }
}

TEST(RadialBasis, PassesThroughItsSamplesWithoutRegularisation) {
  const auto at = points(30);
  const auto y = values(at, smooth);
  const RadialBasis model(at, y, ones(at), {Kernel::cubic, 1.0, 0.0, 1.0});
  for (Eigen::Index i = 0; i < at.rows(); ++i) EXPECT_NEAR(model(at.row(i)), y(i), 1e-9);
}

TEST(RadialBasis, LeaveOneOutEqualsRefittingWithoutTheSample) {
  const auto at = points(24);
  const auto y = values(at, smooth);
  for (const auto kernel : {Kernel::multiquadric, Kernel::gaussian, Kernel::thin_plate, Kernel::cubic})
    for (const double regularisation : {0.0, 1e-2}) {
      const RadialBasisShape shape{kernel, 2.0, regularisation, 0.7};
      const RadialBasis all(at, y, ones(at), shape);
      for (const Eigen::Index left_out : {0, 7, 23}) {
        Eigen::MatrixXd others(at.rows() - 1, 3);
        Eigen::VectorXd other_values(at.rows() - 1);
        for (Eigen::Index i = 0, next = 0; i < at.rows(); ++i)
          if (i != left_out) others.row(next) = at.row(i), other_values(next++) = y(i);
        const RadialBasis without(others, other_values, ones(others), shape);
        EXPECT_NEAR(all.leave_one_out()(left_out), y(left_out) - without(at.row(left_out)), 1e-7)
            << text(kernel) << ", regularisation " << regularisation << ", sample " << left_out;
      }
    }
}

TEST(RadialBasis, ChoosesAShapeThatPredictsUnseenPoints) {
  const auto at = points(60);
  const auto model = fit_radial_basis(at, values(at, smooth), ones(at)).front();
  const auto unseen = points(200).bottomRows(140);
  double worst = 0.0;
  for (Eigen::Index i = 0; i < unseen.rows(); ++i)
    worst = std::max(worst, std::abs(model(unseen.row(i)) - smooth(unseen.row(i))));
  EXPECT_LT(worst, 0.05);  // of a range of 2; at the rim, where no sample lies
}

TEST(RadialBasis, SmoothsNoiseInsteadOfFollowingIt) {
  const auto at = points(80);
  auto y = values(at, smooth);
  for (Eigen::Index i = 0; i < y.size(); ++i) y(i) += 0.05 * std::sin(1e3 * static_cast<double>(i * i));
  const auto model = fit_radial_basis(at, y, ones(at)).front();
  double error = 0.0;
  for (Eigen::Index i = 0; i < at.rows(); ++i) error += std::pow(model(at.row(i)) - smooth(at.row(i)), 2);
  EXPECT_LT(std::sqrt(error / 80.0), 0.03);  // the noise has 0.035
  EXPECT_GT(model.shape().regularisation, 1e-6);
}

TEST(RadialBasis, FollowsSamplesOfLittleTrustLess) {
  const auto at = points(40);
  auto y = values(at, smooth);
  y(7) += 0.5;
  auto trust = ones(at);
  const RadialBasis believing(at, y, trust, {Kernel::cubic, 1.0, 1e-3, 1.0});
  trust(7) = 1e-3;
  const RadialBasis doubting(at, y, trust, {Kernel::cubic, 1.0, 1e-3, 1.0});
  EXPECT_NEAR(believing(at.row(7)), y(7), 0.1);
  EXPECT_NEAR(doubting(at.row(7)), smooth(at.row(7)), 0.1);
}

TEST(RadialBasis, AnInputThatNeverVariesIsNoObstacle) {
  auto at = points(20);
  at.col(1).setConstant(0.0);
  const auto y = values(
      at, +[](const Eigen::RowVectorXd& x) { return x(0) + 2.0 * x(2); });
  const auto model = fit_radial_basis(at, y, ones(at)).front();
  EXPECT_NEAR(model(at.row(4)), y(4), 1e-4);
}

}  // namespace
}  // namespace apc::loadtables
