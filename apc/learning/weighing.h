/// From evidence to probability: explanations (no effect, one, two, an instrument, a learned force) and what is held
/// against each before the data speak.
#pragma once

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// The best shape of each effect, most evident first.
struct Single {
  const Hypothesis* hypothesis;
  Evidence evidence;
  double log_evidence;  ///< averaged over the shapes
};
std::vector<Single> best_shapes(const Screen&);

/// Logarithm of the mean of evidences given by their logarithms.
double mean_evidence(const std::vector<double>&);

/// The effect at the hypothesis' shape with this amplitude, kept inside its range.
effects::Applied started(const Hypothesis&, double amplitude);
/// Sorted.
std::vector<std::string> ids_of(const std::vector<effects::Applied>&);

/// A set fitted through the simulator.
Explanation explained(const Background&, const NuisanceFactor&, const std::vector<effects::Applied>& start,
                      const std::vector<std::array<double, 2>>& places);
/// One or two effects with the amplitudes of the linear model.
Explanation weighed(const Background&, const std::vector<const Hypothesis*>& set, const Evidence&, double log_evidence);

/// What evidence through the simulator counts beside evidence along the measured motion: the ratio of their tempers.
double simulated_share(const Screen& along);

/// The screen along the measured motion, with the joints of the simulated one: they act between surveyed places and far
/// faster than the balance is read, so the two share nothing.
Screen joined(Screen along, const Screen& simulated);

/// Sensors and learned forces: linear, so the screen's evidence is already theirs.
void add_linear(const Screen&, std::vector<Explanation>&, std::vector<SensorClaim>&);

/// Probabilities, most probable first. `along`: weighed along the measured motion.
void weigh(std::vector<Explanation>&, bool along, std::size_t effects, double temper);

}  // namespace apc::learning
