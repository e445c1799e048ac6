#include "apc/learning/gaussian.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

double log_normal_share(double z) {  // ln Φ(z)
  return z > -8.0 ? std::log(0.5 * std::erfc(-z / std::sqrt(2.0))) : -0.5 * z * z - std::log(-z * 2.5066282746310002);
}

}  // namespace

Scores marginal_scores(const Eigen::MatrixXd& information, const Eigen::MatrixXd& precision,
                       const Eigen::MatrixXd& cross, const Eigen::VectorXd& right, const Eigen::MatrixXd& plain,
                       const Eigen::VectorXd& plain_score, double square) {
  const Eigen::LLT<Eigen::MatrixXd> factor(information + precision);
  expect(factor.info() == Eigen::Success, "normal matrix is not positive");
  const Eigen::MatrixXd half = factor.matrixL().solve(cross);
  const Eigen::VectorXd half_right = factor.matrixL().solve(right);
  return {plain - half.transpose() * half, plain_score - half.transpose() * half_right,
          square - half_right.squaredNorm()};
}

Evidence evidence_of(const Scores& scores, const Candidate& candidate) {
  const auto n = static_cast<Eigen::Index>(candidate.columns.size());
  Evidence result;
  result.amplitude = Eigen::VectorXd::Zero(n);
  result.covariance = Eigen::MatrixXd::Zero(n, n);
  if (n == 0) return result;
  Eigen::MatrixXd G(n, n);
  Eigen::VectorXd g(n), lambda(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto ci = candidate.columns[static_cast<std::size_t>(i)];
    g[i] = scores.score[ci];
    lambda[i] = 1.0 / std::pow(candidate.deviation[static_cast<std::size_t>(i)], 2);
    for (Eigen::Index j = 0; j < n; ++j) G(i, j) = scores.gram(ci, candidate.columns[static_cast<std::size_t>(j)]);
  }
  const Eigen::MatrixXd A = G + Eigen::MatrixXd(lambda.asDiagonal());
  const Eigen::LDLT<Eigen::MatrixXd> factor(A);
  result.covariance = factor.solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd mode = factor.solve(g);
  // Mode under A ≥ 0 by an active set over the few amplitudes: drop the worst violator until none is left.
  std::vector<bool> active(static_cast<std::size_t>(n), true);
  for (;;) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)]) free.push_back(i);
    result.amplitude.setZero();
    if (free.empty()) break;
    const Eigen::VectorXd part = A(free, free).ldlt().solve(g(free));
    Eigen::Index worst = -1;
    for (Eigen::Index i = 0; i < part.size(); ++i)
      if (candidate.positive[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] && part[i] < 0.0 &&
          (worst < 0 || part[i] < part[worst]))
        worst = i;
    if (worst < 0) {
      result.amplitude(free) = part;
      break;
    }
    active[static_cast<std::size_t>(free[static_cast<std::size_t>(worst)])] = false;
  }
  result.gain = 2.0 * g.dot(result.amplitude) - result.amplitude.dot(G * result.amplitude);
  double value = 0.5 * g.dot(mode);
  const Eigen::VectorXd pivots = factor.vectorD();
  for (Eigen::Index i = 0; i < n; ++i) value -= 0.5 * std::log(std::max(pivots[i], 1e-300)) - 0.5 * std::log(lambda[i]);
  for (Eigen::Index i = 0; i < n; ++i)
    if (candidate.positive[static_cast<std::size_t>(i)])
      value += std::log(2.0) + log_normal_share(mode[i] / std::sqrt(std::max(result.covariance(i, i), 1e-300)));
  result.log_evidence = value + candidate.log_weight;
  return result;
}

double FamilyWise::p_of(double gain) const {
  const auto above = largest.end() - std::lower_bound(largest.begin(), largest.end(), gain);
  return (1.0 + static_cast<double>(above)) / (1.0 + static_cast<double>(largest.size()));
}

double FamilyWise::quantile(double share) const {
  if (largest.empty()) return 0.0;
  return largest[std::min(largest.size() - 1, static_cast<std::size_t>(share * static_cast<double>(largest.size())))];
}

FamilyWise family_wise(const Scores& scores, const std::vector<Candidate>& singles, int draws, unsigned seed) {
  std::vector<Eigen::Index> columns;
  std::vector<bool> positive;
  for (const Candidate& c : singles)
    if (c.columns.size() == 1 && scores.gram(c.columns[0], c.columns[0]) > 0.0)
      columns.push_back(c.columns[0]), positive.push_back(c.positive[0]);
  FamilyWise result;
  if (columns.empty()) return result;
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd correlation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      correlation(i, j) =
          correlation_of(scores, columns[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation);
  const Eigen::MatrixXd root = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < draws; ++draw) {
    const Eigen::VectorXd z = root * Eigen::VectorXd::NullaryExpr(n, [&] { return normal(generator); });
    double largest = 0.0;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!positive[static_cast<std::size_t>(i)] || z[i] > 0.0) largest = std::max(largest, z[i] * z[i]);
    result.largest.push_back(largest);
  }
  std::sort(result.largest.begin(), result.largest.end());
  return result;
}

double correlation_of(const Scores& scores, Eigen::Index j, Eigen::Index k) {
  const double product = scores.gram(j, j) * scores.gram(k, k);
  return product > 0.0 ? scores.gram(j, k) / std::sqrt(product) : 0.0;
}

}  // namespace apc::learning
