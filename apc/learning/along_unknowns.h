/// Sensitivities of a run's readings to everything unknown but no effect, and the prior of those unknowns.
#pragma once

#include "apc/learning/along.h"

namespace apc::learning {

/// Unknowns beyond the layout's, appended in this order, with the standard deviations of their priors.
struct Extra {
  static constexpr Eigen::Index pavement = 0, drag = 1, rolling = 2, depth = 3, thin_drag = 4, thin_vertical = 5,
                                count = 6;
  static constexpr double deviation[count] = {0.0015, 0.03, 0.012, 0.012, 0.08, 0.08};
};

/// Prior of the layout's unknowns and the extra ones; bed strength as a certificate allows it (8 %). `vertical_table`
/// multiplies the deviations of the tables' vertical numbers.
struct AlongPrior {
  Eigen::MatrixXd precision;
  double log_determinant = 0.0;
};
AlongPrior along_prior(const Case&, const Layout&);
AlongPrior with_vertical_error(const AlongPrior&, const Layout&, double vertical_table);

Eigen::MatrixXd sensitivities(const Case&, const Layout&, const std::vector<GearFacts>&, std::size_t run,
                              const AlongRun&);
/// By ruts at knots of `rut_knots` m of each gear group's way.
inline constexpr double rut_knots = 2.0;
Eigen::MatrixXd rut_sensitivities(const Case&, const std::vector<GearFacts>&, const Run&, const AlongRun&);

}  // namespace apc::learning
