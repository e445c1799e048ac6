/// What is calibrated on free runs: one strength for the whole bed, as its certificate allows, and the sizes of
/// effects. Nothing else goes into a prediction. Beside them every run has a level, a strength of its own as narrow as
/// runs of one bed scatter (run_level.h): what raises or lowers whole runs must gain more than that scatter does.
///
/// The scale of the errors is not known beforehand — blocks, tables and the bounce leave two to five times the noise —
/// so S, the sum of squares of all R runs, counts by its logarithm. Minimised is
///     O = n ln S + (ln strength / σ)² + Σ (level_r / σ_r)² + Σ ((A − neutral) / σ_A)²,   n = 3 per run:
/// how drag is spread over the way and over speeds. Below S = R, where errors are their uncertainties, the scale is
/// known: n (ln R + S/R − 1). Gauss–Newton, steps halved until O falls.
#pragma once

#include "apc/learning/free_run.h"

namespace apc::learning {

/// Numbers that one run tells beside its level; chosen on measured cases with known truth. Squared errors of their
/// effect-free runs scatter as if there were about six; effects are smooth and fall on the largest of them.
inline constexpr double told_by_a_run = 3.0;

/// What some runs tell: numbers (a run of which only a stop is known tells one), and how many runs they are.
struct Told {
  double numbers = 0.0, runs = 0.0;
  double objective(double square) const;  ///< their part of O
  double weight(double square) const;     ///< its derivative by S
};
Told told_by(const FreeRuns&, const std::vector<char>& use = {});

struct FreeFit {
  double strength = 0.0;  ///< ln of the bed's strength over its data sheet's
  std::vector<effects::Applied> effects;
  std::vector<double> levels;           ///< per run; 0 for runs that are not used
  double square = 0.0;                  ///< S
  double objective = 0.0;               ///< O
  Eigen::MatrixXd covariance;           ///< strength, the amplitudes that were fitted, levels
  std::vector<Eigen::VectorXd> misfit;  ///< per run; empty: not used
};

/// Fits strength and amplitudes from a start; shapes stay, and fine effects (joints) stay whole: free runs do not see
/// them. `use` as in free_misfits. SolveError when the start cannot be simulated.
FreeFit fit_free(const FreeRuns&, const std::vector<effects::Applied>& start, double strength,
                 const std::vector<char>& use = {});
/// A fit with what a search around it finds lower: strength and amplitudes by their deviations, every level by half of
/// its own, ever shorter. Each stop of a bounce makes S rough, so Gauss–Newton ends up to a few units of O above.
FreeFit searched(const FreeRuns&, FreeFit, const std::vector<char>& use = {});
/// The likeliest strength without any effect, wherever it is: beds that are nearly crushed through have two.
FreeFit fit_strength(const FreeRuns&, const std::vector<char>& use = {});

/// ln (evidence of `with` / evidence of `without`), both fitted to the same runs (Laplace).
double log_evidence_of(const FreeFit& with, const FreeFit& without);

}  // namespace apc::learning
