/// Effects, instruments and learned forces weighed along the measured motion: at the loads the wheels carried the
/// balance of forces is nearly linear in everything unknown, so one Gaussian model says what the run-through-the-
/// simulator cannot — its bounce, kept by no model for long, is an input here and not compared at all.
///
/// Unknowns besides those of the layout: rolling resistance on pavement and in the bed, a common factor on drag, depth
/// as surveyed, errors of the tables in beds thinner than their samples, how much of a swing of the load reaches the
/// tire, a foam that locks up gradually or seems stronger at speed. On the plateau of a foam a few percent of load
/// are a quarter of the depth, so the model is linearised again where strength, blocks, tables and depth are likeliest.
/// What is left is noise of known form: an error of the deceleration proportional to it and one of the load carried
/// (correlated in time, and they move the speed, too), one of the ruts (correlated along the bed); their sizes are
/// those of highest evidence without any effect.
#pragma once

#include "apc/learning/readings.h"
#include "apc/learning/screen.h"

namespace apc::learning {

/// Sizes of what the balance leaves unexplained.
struct AlongNoise {
  double drag = 0.06;           ///< share of the deceleration
  double load = 0.06;           ///< share of the load carried
  double memory = 0.4;          ///< s, of both
  double rut = 0.01;            ///< m
  double accelerometer = 1.0;   ///< × quoted noise
  double vertical_table = 1.0;  ///< × quoted error of the tables' vertical loads
};

/// One run along its measured motion.
struct AlongRun {
  Motion motion;
  std::vector<Reading> readings;
  Eigen::VectorXd measured;
  Balance nominal;                       ///< of the plain tables
  effects::Alterations here;             ///< the bed the model is linearised at
  Response response;                     ///< at `here`
  Eigen::VectorXd plain, predicted;      ///< read-off of `nominal`; at `here`
  Eigen::VectorXd difference;            ///< measured − predicted, as seen from the prior mean
  Eigen::MatrixXd unknowns;              ///< sensitivities, columns as in the extended layout
  std::vector<Eigen::Index> touched;     ///< columns that are not zero
  std::vector<Eigen::MatrixXd> carried;  ///< per gear: sensitivities to the load carried, knots of 0.1 s
  Eigen::MatrixXd factor;                ///< lower Cholesky factor of the noise
};

struct Along {
  std::vector<GearFacts> gears;
  std::vector<AlongRun> runs;
  Eigen::MatrixXd precision;  ///< prior of all unknowns
  Eigen::VectorXd bed;        ///< strength, blocks, tables and depth the model is linearised at; else 0
  AlongNoise noise;
  double log_evidence = 0.0;  ///< without any effect
};

/// Null where a run has no usable speed, the aircraft other than a nose and one main gear group, or the model cannot be
/// solved.
std::optional<Along> balance_along(const Case&, const Layout&, unsigned threads);

/// Hypotheses about effects (fine ones left out: they act faster than the balance is read), instruments of speed and
/// acceleration_x, and learned forces, scored along the motion.
Screen weigh_along(const Along&, const Case&, const Layout&, const std::vector<effects::Effect>&, unsigned threads);

}  // namespace apc::learning
