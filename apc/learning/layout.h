/// The unknowns of a case without any missing effect: which there are, how wide their priors are, and how a vector of
/// them becomes a simulation. All entries are deviations from the nominal model, in the unit given below.
///
///   per case: ln bed strength, cg offset (m), ln drag coefficient, cg height (m),
///             response to sinking: vertical, drag (simulation::Sinking), 12 table-error numbers per table
///   per run:  entry speed (m/s), ln mass, cg (m), ln pitch inertia, wind (m/s), clock (s),
///             shift (m) and stretch of its way along the bed (only where fine effects are fitted),
///             per channel bias, scale, lag (s); block strengths (ln) under the nose and under the other gears
#pragma once

#include <Eigen/Dense>

#include "apc/learning/measured.h"

namespace apc::learning {

/// How scattered the bed is; starts from the maker's figures.
struct Scatter {
  double strength = 0.08;    ///< standard deviation of the logarithm
  double correlation = 2.4;  ///< m along the runway
  double shared = 0.6;       ///< share of the variance that comes back in every run of a lane
  double lateral = 0.3;      ///< correlation between the tracks of nose and main gears
  double run_to_run = 0.02;
};

/// Table errors are linear in speed: at each of three relative penetrations the mean and the change from 17.5 to 36
/// m/s, for drag, then for vertical load.
inline constexpr Eigen::Index table_numbers = 12;

/// A delay is half-normal: its mean and its deviation, in units of its root mean square.
inline constexpr double mean_lag = 0.798, lag_deviation = 0.603;

struct RunLayout {
  Eigen::Index entry_speed = 0, mass = 0, cg = 0, inertia = 0, wind = 0, clock = 0, shift = 0, stretch = 0;
  std::vector<Eigen::Index> bias, scale, lag;                 ///< per channel
  Eigen::Index nose_blocks = 0, main_blocks = 0, blocks = 0;  ///< first index; number of knots each
};

struct Layout {
  Eigen::Index size = 0;
  Eigen::Index bed_strength = 0, cg = 0, drag = 0, cg_height = 0, sinking = 0, sinking_drag = 0,
               table = 0;                  ///< table: first of 12 per distinct table
  std::vector<std::size_t> table_of_gear;  ///< index of the distinct table each gear uses
  std::size_t tables = 1;
  double spacing = 1.22;  ///< of block knots, m
  std::vector<RunLayout> runs;
  /// Indices that need a simulation to differentiate, for one run.
  std::vector<Eigen::Index> simulated(std::size_t run) const;
};

/// `runs`: training runs first, then runs to predict; channels of the latter carry no samples.
Layout make_layout(const Case&, const std::vector<Run>& runs);

/// Prior mean (lags are not zero on average) and precision.
Eigen::VectorXd prior_mean(const Layout&, const std::vector<Run>&);
struct Prior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd precision;
  double log_determinant = 0.0;  ///< ln |precision|
};
Prior make_prior(const Layout&, const Case&, const std::vector<Run>&, const Scatter&);

/// Standard deviations alone, for step sizes.
Eigen::VectorXd prior_deviation(const Layout&, const Case&, const std::vector<Run>&, const Scatter&);

}  // namespace apc::learning
