/// The background of a case: everything that is uncertain before any effect is asked for, fitted to all runs at once
/// through the simulator (Gauss–Newton with priors), and the linear model around that fit on which effects are weighed.
#pragma once

#include <functional>

#include "apc/learning/forward.h"
#include "apc/learning/gaussian.h"
#include "apc/learning/whiten.h"

namespace apc::learning {

/// Sensitivities and misfit of one run, whitened.
struct RunLinear {
  std::vector<Eigen::Index> columns;  ///< which unknowns the columns of S belong to
  Eigen::MatrixXd plain;              ///< sensitivities as they are; S is whitened
  Eigen::MatrixXd S;
  Eigen::VectorXd misfit;  ///< y − h at the fit, whitened
};

struct Background {
  const Case* data = nullptr;
  std::vector<Run> runs;     ///< training runs, then runs to predict
  std::size_t training = 0;  ///< how many of `runs` carry data
  Layout layout;
  Scatter scatter;
  Prior prior;
  std::vector<effects::Applied> added;  ///< effects already in the model
  std::vector<Rows> rows;
  std::vector<Eigen::VectorXd> measured;
  std::map<Quantity, NoiseModel> noise;
  NoiseModel rut_noise;
  std::vector<std::vector<Whitener>> whiteners;               ///< per run: channels, then nose rut, main rut
  std::vector<std::shared_ptr<const effects::Guide>> guides;  ///< per training run: its measured speed
  Eigen::VectorXd eta;
  std::vector<Trace> traces;  ///< at eta
  std::vector<RunLinear> linear;
  Eigen::MatrixXd information;  ///< Σ SᵀS
  Eigen::VectorXd right;        ///< Σ Sᵀ(misfit + S(η − η₀)): as seen from the prior mean
  double objective = 0.0;       ///< |misfit|² + (η − η₀)ᵀP⁻¹(η − η₀)
  unsigned threads = 0;

  Eigen::VectorXd offset() const { return eta - prior.mean; }
};

using Report = std::function<void(double share, const std::string& what)>;

struct BackgroundOptions {
  int iterations = 4;  ///< at most; renewals of the sensitivities after the first
  unsigned threads = 0;
  Report report;
};

/// Fits nuisances, then the channels' noise, then both again. The case must outlive the result.
Background fit_background(const Case&, const BackgroundOptions&);
/// Starts over from a fitted one with effects added: nuisances and noise are fitted again.
Background refit_background(const Background&, const std::vector<effects::Applied>&, int iterations, const Report&);

/// Whitened residual of one run at given unknowns and effects; the trace is kept when asked for.
Eigen::VectorXd whitened_misfit(const Background&, std::size_t run, const Eigen::VectorXd& eta,
                                const std::vector<effects::Applied>&, Trace* trace = nullptr);
void whiten_rows(const Background&, std::size_t run, Eigen::Ref<Eigen::MatrixXd> columns);
double prior_term(const Background&, const Eigen::VectorXd& eta);

/// Guides of all runs made anew from what `eta` says about their instruments.
void renew_guides(Background&);
/// Recomputes all sensitivities at `eta` (about a hundred simulations per run).
void linearise(Background&);
/// Misfits at `eta` and all products, under the present noise, with the sensitivities at hand.
void assemble(Background&);
/// Log evidence of the case under its present noise, scatter and effects (Laplace), up to a constant.
double log_evidence(const Background&);

}  // namespace apc::learning
