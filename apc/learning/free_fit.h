/// What is calibrated on free runs: one strength for the whole bed, as its certificate allows, and the sizes of
/// effects. Nothing else is moved, so that what a model gains here is what it gains in a prediction.
///
/// The scale of the errors is not known beforehand — blocks, tables and the bounce leave two to five times the noise —
/// so S, the sum of squares of all runs, counts by its logarithm. Minimised is
///     O = n ln S + (ln strength / σ)² + Σ ((A − neutral) / σ_A)²,   n = 2 per run:
/// a run tells how much drag there is and how it is spread over the way. Gauss–Newton, steps halved until O falls.
#pragma once

#include "apc/learning/free_run.h"

namespace apc::learning {

/// Numbers that one run tells.
inline constexpr double told_by_a_run = 2.0;

struct FreeFit {
  double strength = 0.0;  ///< ln of the bed's strength over its data sheet's
  std::vector<effects::Applied> effects;
  double square = 0.0;                  ///< S
  double objective = 0.0;               ///< O
  Eigen::MatrixXd covariance;           ///< strength, then the amplitudes that were fitted
  std::vector<Eigen::VectorXd> misfit;  ///< per run; empty: not used
};

/// Fits strength and amplitudes from a start; shapes stay, and fine effects (joints) stay whole: free runs do not see
/// them. `use` as in free_misfits. SolveError when the start cannot be simulated.
FreeFit fit_free(const FreeRuns&, const std::vector<effects::Applied>& start, double strength,
                 const std::vector<char>& use = {});
/// The likeliest strength without any effect, wherever it is: beds that are nearly crushed through have two.
FreeFit fit_strength(const FreeRuns&, const std::vector<char>& use = {});

/// ln (evidence of `with` / evidence of `without`), both fitted to the same runs (Laplace).
double log_evidence_of(const FreeFit& with, const FreeFit& without);

}  // namespace apc::learning
