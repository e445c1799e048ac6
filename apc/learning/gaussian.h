/// The linear Gaussian model behind every statement about effects. Whitened data r = y − h, nuisances η ~ N(η₀, P) with
/// whitened sensitivities S, effect columns Φ:
///     r = S (η − η₀) + Φ A + ε,  ε ~ N(0, 1)
/// Nuisances are integrated out with M = P⁻¹ + SᵀS (Woodbury); the covariance of the data is never formed:
///     uᵀΣ⁻¹w = uᵀw − (Sᵀu)ᵀ M⁻¹ (Sᵀw)
/// Only the products SᵀS, SᵀΦ, ΦᵀΦ, … are kept, so thousands of candidates cost nothing.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace apc::learning {

/// Gram matrix and scores of candidate columns after the nuisances: G = ΦᵀΣ⁻¹Φ, g = ΦᵀΣ⁻¹r, and rᵀΣ⁻¹r.
struct Scores {
  Eigen::MatrixXd gram;
  Eigen::VectorXd score;
  double misfit = 0.0;
};

/// `information` = SᵀS, `cross` = SᵀΦ, `right` = Sᵀr, `plain` = ΦᵀΦ, `plain_score` = Φᵀr, `square` = rᵀr.
Scores marginal_scores(const Eigen::MatrixXd& information, const Eigen::MatrixXd& precision,
                       const Eigen::MatrixXd& cross, const Eigen::VectorXd& right, const Eigen::MatrixXd& plain,
                       const Eigen::VectorXd& plain_score, double square);

/// One candidate: a set of columns with Gaussian priors on their amplitudes, some confined to A ≥ 0.
struct Candidate {
  std::vector<Eigen::Index> columns;
  std::vector<double> deviation;  ///< prior standard deviation of each amplitude
  std::vector<bool> positive;     ///< amplitude may not be negative (half-normal prior)
  double log_weight = 0.0;        ///< added to its evidence: what choosing these columns among their like costs
};

struct Evidence {
  double log_evidence = 0.0;  ///< over the model without the columns
  Eigen::VectorXd amplitude;  ///< posterior mode
  Eigen::MatrixXd covariance;
  double gain = 0.0;  ///< 2 ln likelihood ratio at the mode
};

/// Laplace (exact without signs): ½ gᵀ(G+Λ)⁻¹g − ½ ln|1 + Λ⁻¹G| plus the share of the posterior on the allowed side.
Evidence evidence_of(const Scores&, const Candidate&);

/// Family-wise p of the largest single gain: shares of `draws` null data sets (g ~ N(0, G)) whose best candidate gains
/// at least as much as each given one. `single` lists candidates of one column each.
struct FamilyWise {
  std::vector<double> largest;  ///< sorted null distribution of the largest gain
  double p_of(double gain) const;
  double quantile(double share) const;
};
FamilyWise family_wise(const Scores&, const std::vector<Candidate>& singles, int draws, unsigned seed);

/// G_jk / √(G_jj G_kk), and how far j stays visible when k is free: d'_j √(1 − ρ²).
double correlation_of(const Scores&, Eigen::Index j, Eigen::Index k);

}  // namespace apc::learning
