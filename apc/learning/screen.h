/// Everything that might be missing, as columns of the linear model: each effect at each of its shapes, each instrument
/// fault, and force laws to be learned. Scored all at once against the fitted background.
#pragma once

#include <array>

#include "apc/learning/background.h"
#include "apc/learning/shapes.h"

namespace apc::learning {

struct Hypothesis {
  enum class Kind { effect, sensor, learned };
  Kind kind = Kind::effect;
  std::string id;            ///< effect id; "acceleration_x.scale"; "strength along the bed"
  std::string run;           ///< sensor faults of one run only
  effects::Applied applied;  ///< effects: with the shape of this entry; the amplitude is the unit of the column
  Candidate candidate;       ///< columns in `Screen::scores`, amplitude priors
  std::vector<std::array<double, 2>> places;  ///< fine effects: shift (m) and stretch of each run's way
};

struct Screen {
  std::vector<Hypothesis> hypotheses;
  Scores scores;
  double temper = 4.0;  ///< evidence is divided by this before it becomes probability; chosen on cases with known truth
};

/// `effects`: the catalogue and the user's own; simulates each effect column once per run. Forces are learned beside
/// them only where there are others than fine ones: joints alone are asked for beside a screen along the measured
/// motion.
Screen screen(const Background&, const std::vector<effects::Effect>& effects, const Report&);

/// Half the prior of an effect that is listed in other forms, too, goes to the catalogue's law, half to the others,
/// evenly over their shapes.
void share_shapes(std::vector<Hypothesis>&);

/// Lower factor of σ² exp(−|i − j| spacing / length): the prior of what is learned at evenly spaced knots.
Eigen::MatrixXd exponential_factor(Eigen::Index n, double spacing, double length, double deviation);

}  // namespace apc::learning
