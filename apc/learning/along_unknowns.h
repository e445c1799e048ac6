/// Sensitivities of a run's readings to everything unknown but no effect, and the prior of those unknowns.
#pragma once

#include "apc/learning/along.h"

namespace apc::learning {

/// Unknowns beyond the layout's, appended in this order, with the standard deviations of their priors. `rate`: a foam
/// that seems stronger at speed because loads are smoothed. Without it effect-free pairs of runs of our own were told
/// to have c = 0.006 to 0.030; its deviation is the smallest tried that leaves none of ten with evidence for it.
struct Extra {
  static constexpr Eigen::Index pavement = 0, drag = 1, rolling = 2, depth = 3, thin_drag = 4, thin_vertical = 5,
                                swing_nose = 6, swing_main = 7, stiffening = 8, rate = 9, count = 10;
  static constexpr double deviation[count] = {0.0015, 0.03, 0.012, 0.012, 0.08, 0.08, 0.3, 0.3, 0.7, 0.005};
};

/// Response to sinking, × that of a rigid wheel, before the data speak (± 0.4): flexible tires in SPH have 1.5 to 1.9
/// (simulation::Sinking).
inline constexpr double expected_sinking = 1.7;

/// Prior of the layout's unknowns and the extra ones; bed strength as a certificate allows it (8 %). `vertical_table`
/// multiplies the deviations of the tables' vertical numbers.
struct AlongPrior {
  Eigen::MatrixXd precision;
  double log_determinant = 0.0;
};
AlongPrior along_prior(const Case&, const Layout&);
AlongPrior with_vertical_error(const AlongPrior&, const Layout&, double vertical_table);

/// 1 for what the bed is linearised at (strength, blocks, tables, depth, swings of the loads), else 0.
Eigen::VectorXd bed_unknowns(const Layout&);

/// Everything of an AlongRun that depends on the bed: alterations, response, read-off, sensitivities.
void linearise_at(const Case&, const Layout&, const std::vector<GearFacts>&, std::size_t run,
                  const Eigen::VectorXd& bed, AlongRun&);

/// Spacing of the knots of the errors of deceleration and carried load, s.
inline constexpr double noise_knots = 0.1;

}  // namespace apc::learning
