/// How far a model is from a measurement, in numbers engineers know.
#pragma once

#include <vector>

#include "apc/learning/forward.h"

namespace apc::learning {

/// Sprague and Geers: magnitude M = √(Σc²/Σm²) − 1, phase P = arccos(Σmc/√(Σm²Σc²))/π, both together C = √(M² + P²);
/// m measured, c computed. Zero = the same.
struct SpragueGeers {
  double magnitude = 0.0, phase = 0.0, combined = 0.0;
};
SpragueGeers sprague_geers(const std::vector<double>& measured, const std::vector<double>& computed);

/// ASME V&V 20: comparison error E = simulation − data against u_val = √(u_num² + u_input² + u_D²). |E| ≤ 2 u_val: what
/// is left of the model's error drowns in the uncertainty of the comparison.
struct Comparison {
  double error = 0.0, uncertainty = 0.0;
  bool within() const { return error <= 2.0 * uncertainty && error >= -2.0 * uncertainty; }
};

/// One channel of one run.
struct ChannelError {
  Quantity quantity = Quantity::speed;
  double rms = 0.0, mean = 0.0;  ///< SI, against time
  double normalised = 0.0;       ///< rms over the larger of noise and 2 % of the range, against distance
  double coverage = 0.0;         ///< share of samples within twice the noise
  SpragueGeers sprague_geers;
};
struct RunError {
  std::string run;
  std::vector<ChannelError> channels;
  std::optional<Comparison> stop;
  double total = 0.0;  ///< root mean square of the normalised errors of speed, acceleration_x and stop
};

/// A free run of the model against the data.
RunError compare(const Case&, const Layout&, std::size_t r, const Run&, const Eigen::VectorXd& eta,
                 const std::vector<effects::Applied>&);

}  // namespace apc::learning
