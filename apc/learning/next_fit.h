/// Explanations fitted to the runs at hand on the few numbers of segments.h, and all that a prediction of one more run
/// then depends on: the linear Gaussian model between unknowns and numbers.
#pragma once

#include "apc/learning/feature_noise.h"
#include "apc/learning/next_run.h"

namespace apc::learning {

/// Numbers of one run and what they depend on.
struct Numbers {
  Segments segments;
  std::vector<Eigen::Index> columns;  ///< unknowns of the layout
  Eigen::MatrixXd by_unknown;         ///< numbers × columns
  Eigen::VectorXd value;
  Trace trace;
};

/// The runs at hand and one more that nobody has made, the last; unknowns of all of them in one layout.
struct Field {
  const Case& data;
  std::vector<Run> runs;
  Layout layout;
  Eigen::VectorXd deviation;  ///< of the unknowns' priors
  SegmentErrors errors;

  Eigen::Index globals() const { return layout.runs.front().entry_speed; }  ///< unknowns that all runs share come first
};

/// A run of this speed (m/s) and mass (kg) with every instrument a plan may ask for; other conditions as in the first.
Run candidate_run(const Case&, double speed, double mass);
Field field_with(const Case&, const Run& candidate);

/// Sensitivities of run `r` at `eta` by one-sided differences, half a deviation each. Blocks are left to the noise.
void differentiate(const Field&, std::size_t r, const Eigen::VectorXd& eta, const std::vector<effects::Applied>&,
                   Numbers&);
/// How the numbers change with the amplitude of effect `which`, by a step of this share of its usual size.
Eigen::VectorXd by_amplitude(const Field&, std::size_t r, const Segments&, const Eigen::VectorXd& value,
                             const Eigen::VectorXd& eta, std::vector<effects::Applied>, std::size_t which,
                             double share = 0.3);

/// Covariance of a run's numbers: instruments, blocks, model, and the unknowns of this run alone.
Eigen::MatrixXd own_covariance(const Field&, std::size_t r, const Numbers&);
/// Columns of the unknowns all runs share, then of `amplitudes`.
Eigen::MatrixXd joint_columns(const Field&, const Numbers&, const std::vector<Eigen::VectorXd>& amplitudes);

/// The runs at hand, linear around one state; numbers that were not measured are dropped from all.
struct Training {
  std::vector<Numbers> runs;
  std::vector<Eigen::VectorXd> measured;
  std::vector<std::vector<Eigen::Index>> kept;
  std::vector<Eigen::LLT<Eigen::MatrixXd>> factor;  ///< of the kept numbers' covariance
};
Training train(const Field&, const std::vector<effects::Applied>&, unsigned threads);

/// A contender fitted, and the covariance of what all runs share and of its amplitudes, in this order.
struct Fitted {
  Contender contender;
  Eigen::MatrixXd covariance;
};
/// `rounds` − 1 Gauss–Newton steps; the last round is for the covariance. With one round, amplitudes count
/// by what their usual size does.
Fitted fit(const Field&, const Training&, const std::vector<effects::Applied>&, unsigned threads, int rounds);

/// What one deviation of the amplitudes, taken as the fit leaves them, does to the numbers of run `r`: a column per
/// independent direction, half the difference between the two ends. Unknowns that trade against the amplitudes move
/// along. Wide steps on purpose: sensitivities of nearly bistable runs depend on the step, and this is the one meant.
Eigen::MatrixXd amplitude_spread(const Field&, std::size_t r, const Segments&, const Eigen::VectorXd& value,
                                 const Fitted&);

}  // namespace apc::learning
