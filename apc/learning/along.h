/// Effects, instruments and learned forces weighed along the measured motion: at the surveyed ruts the balance of
/// forces is nearly linear in everything unknown, so one Gaussian model says what the run-through-the-simulator
/// cannot — its bounce, kept by no model for long, is not compared at all.
///
/// Unknowns besides those of the layout: rolling resistance on pavement and in the bed, a common factor on drag, depth
/// as surveyed, errors of the tables in beds thinner than their samples. What is left is noise of known form: an error
/// of the deceleration proportional to it (correlated in time, and it moves the speed, too), of the vertical and
/// pitching accelerations, and of the surveyed ruts; their sizes are those of highest evidence without any effect.
#pragma once

#include "apc/learning/readings.h"
#include "apc/learning/screen.h"

namespace apc::learning {

/// Sizes of what the balance leaves unexplained.
struct AlongNoise {
  double drag = 0.06;           ///< share of the deceleration
  double up = 0.10;             ///< share of g
  double pitching = 0.10;       ///< share of g × mass / inertia, rad/s² m
  double memory = 0.4;          ///< s
  double accelerometer = 1.0;   ///< × quoted noise
  double vertical_table = 1.0;  ///< × quoted error of the tables' vertical loads
  double rut = 0.006;           ///< m
};

/// One run along its measured motion.
struct AlongRun {
  Motion motion;
  Balance balance;
  std::vector<Reading> readings;
  Eigen::VectorXd predicted, difference;  ///< read-off of the plain balance; readings minus that
  Eigen::MatrixXd unknowns;               ///< sensitivities, columns as in the extended layout
  Eigen::MatrixXd ruts;                   ///< sensitivities to the surveyed ruts, knots of 2 m per gear group
  Eigen::MatrixXd factor;                 ///< lower Cholesky factor of the noise
};

struct Along {
  std::vector<GearFacts> gears;
  std::vector<AlongRun> runs;
  Eigen::MatrixXd precision;  ///< prior of all unknowns
  AlongNoise noise;
};

/// Null where a run has no survey or too few channels, or the aircraft more than two gear groups.
std::optional<Along> balance_along(const Case&, const Layout&, unsigned threads);

/// Hypotheses about effects (fine ones left out: they act between the surveyed places), instruments of speed and
/// acceleration_x, and learned forces, scored along the motion.
Screen weigh_along(const Along&, const Case&, const Layout&, const std::vector<effects::Effect>&, unsigned threads);

}  // namespace apc::learning
