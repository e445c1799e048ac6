/// The noise of readings along a measured motion, and the sizes of highest evidence.
#pragma once

#include "apc/learning/along_unknowns.h"

namespace apc::learning {

/// Lower Cholesky factor of the covariance of one run's readings: instruments, errors of deceleration, loads and ruts.
Eigen::MatrixXd noise_factor(const Run&, const AlongRun&, const AlongNoise&);

/// Finds `noise` by coordinate search on the evidence in so many passes, then fills factors and precision. Returns the
/// unknowns that are likeliest without any effect.
Eigen::VectorXd fit_noise(Along&, const Case&, const Layout&, const AlongPrior&, int passes, unsigned threads);

}  // namespace apc::learning
