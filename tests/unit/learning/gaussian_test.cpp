#include "apc/learning/gaussian.h"

#include <gtest/gtest.h>

#include <random>

#include "apc/learning/whiten.h"

namespace apc::learning {
namespace {

Eigen::MatrixXd random(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

TEST(Gaussian, IntegratesNuisancesOutLikeTheDenseCovariance) {
  const Eigen::MatrixXd S = random(300, 20, 1), F = random(300, 3, 2), A = random(20, 20, 3);
  const Eigen::VectorXd r = random(300, 1, 4);
  const Eigen::MatrixXd P = A * A.transpose() + 0.1 * Eigen::MatrixXd::Identity(20, 20);
  const Scores scores = marginal_scores(S.transpose() * S, P.inverse(), S.transpose() * F, S.transpose() * r,
                                        F.transpose() * F, F.transpose() * r, r.squaredNorm());
  const Eigen::MatrixXd Sigma = Eigen::MatrixXd::Identity(300, 300) + S * P * S.transpose();
  const Eigen::LDLT<Eigen::MatrixXd> factor(Sigma);
  const Eigen::MatrixXd gram = F.transpose() * factor.solve(F);
  EXPECT_LT((scores.gram - gram).norm(), 1e-9 * gram.norm());
  EXPECT_LT((scores.score - F.transpose() * factor.solve(r)).norm(), 1e-9 * scores.score.norm());
  EXPECT_NEAR(scores.misfit, r.dot(factor.solve(r)), 1e-8 * scores.misfit);
}

Scores one_column(double gram, double score) {
  return {Eigen::MatrixXd::Constant(1, 1, gram), Eigen::VectorXd::Constant(1, score), 0.0};
}

TEST(Gaussian, EvidenceOfOneColumnIsTheClosedForm) {
  const double G = 50.0, g = 30.0, s = 0.4, lambda = 1.0 / (s * s);
  const Evidence e = evidence_of(one_column(G, g), {{0}, {s}, {false}});
  EXPECT_NEAR(e.amplitude[0], g / (G + lambda), 1e-12);
  EXPECT_NEAR(e.log_evidence, 0.5 * g * g / (G + lambda) - 0.5 * std::log(1.0 + G / lambda), 1e-12);
}

TEST(Gaussian, AnAmplitudeThatMayNotBeNegativeStaysAtZero) {
  const Evidence e = evidence_of(one_column(50.0, -30.0), {{0}, {0.4}, {true}});
  EXPECT_EQ(e.amplitude[0], 0.0);
  EXPECT_LT(e.log_evidence, 0.0);
}

TEST(Gaussian, ACopyOfAColumnSharesItsEvidence) {
  Scores s{Eigen::MatrixXd::Constant(2, 2, 40.0), Eigen::VectorXd::Constant(2, 25.0), 0.0};
  const Evidence a = evidence_of(s, {{0}, {0.5}, {true}}), b = evidence_of(s, {{1}, {0.5}, {true}});
  EXPECT_DOUBLE_EQ(a.log_evidence, b.log_evidence);
  EXPECT_DOUBLE_EQ(correlation_of(s, 0, 1), 1.0);
  EXPECT_TRUE(std::isfinite(evidence_of(s, {{0, 1}, {0.5, 0.5}, {true, true}}).log_evidence));
}

TEST(Gaussian, FamilyWiseErrorOfManyColumnsIsAboveThatOfOne) {
  Scores s{Eigen::MatrixXd::Identity(50, 50), Eigen::VectorXd::Zero(50), 0.0};
  std::vector<Candidate> one = {{{0}, {1.0}, {false}}}, all;
  for (Eigen::Index k = 0; k < 50; ++k) all.push_back({{k}, {1.0}, {false}});
  const double p_one = family_wise(s, one, 4000, 1).p_of(3.84), p_all = family_wise(s, all, 4000, 1).p_of(3.84);
  EXPECT_NEAR(p_one, 0.05, 0.012);
  EXPECT_NEAR(p_all, 1.0 - std::pow(0.95, 50), 0.03);
}

TEST(Whitener, TurnsSlowNoiseIntoIndependentUnits) {
  const NoiseModel noise{0.5, 1.2, 0.7};
  std::vector<double> place;
  for (int i = 0; i < 60; ++i) place.push_back(0.1 * i + (i % 7 == 0 ? 0.03 : 0.0));
  Eigen::MatrixXd covariance(60, 60);
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j)
      covariance(i, j) =
          1.44 * std::exp(-std::abs(place[std::size_t(i)] - place[std::size_t(j)]) / 0.7) + (i == j ? 0.25 : 0.0);
  const Whitener whitener(place, noise);
  Eigen::MatrixXd root = Eigen::MatrixXd(Eigen::LLT<Eigen::MatrixXd>(covariance).matrixL());
  const double log_determinant = 2.0 * root.diagonal().array().log().sum();
  whitener.apply(root);
  EXPECT_LT((root * root.transpose() - Eigen::MatrixXd::Identity(60, 60)).norm(), 1e-9);
  EXPECT_NEAR(whitener.log_determinant(), log_determinant, 1e-9);
}

}  // namespace
}  // namespace apc::learning
