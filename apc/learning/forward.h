/// From unknowns to what the instruments should have read: one simulation per run.
#pragma once

#include "apc/learning/layout.h"

namespace apc::learning {

/// Which samples of a run take part. Signals after the speed has fallen below 3 m/s are left out.
struct Rows {
  std::vector<std::size_t> samples;             ///< per channel: number of leading samples used
  std::vector<std::size_t> nose_rut, main_rut;  ///< indices into the survey
  bool stop = false, exit = false;
  Eigen::Index size = 0;
  std::vector<Eigen::Index> channel_start;                        ///< first row of each channel
  Eigen::Index nose_rut_start = 0, main_rut_start = 0, last = 0;  ///< last: row of stop or exit
};
Rows make_rows(const Run&, const Case&);
Eigen::VectorXd measured(const Run&, const Rows&);

/// One simulated run. When it was led along the measured speed, speed and acceleration_x of the history are what the
/// model's own forces would have made of it (the guiding force taken out again), along the measured way.
struct Trace {
  simulation::Result result;
  double stop = 0.0;        ///< m; continued smoothly beyond the far end when it left the bed
  double exit_speed = 0.0;  ///< m/s; negative (continued) when it stopped before
};

/// Simulates `run` with the unknowns of `eta` and the given effects. SolveError when the solver gives up.
Trace simulate_run(const Case&, const Layout&, std::size_t r, const Run&, const Eigen::VectorXd& eta,
                   const std::vector<effects::Applied>&, std::shared_ptr<const effects::Guide> guide = nullptr);

/// The measured speed, smoothed and freed of the instrument errors in `eta`; null without a usable speed channel.
/// Smoothing: least squares with a white-noise prior on the jerk, 30 (m/s³)² s.
std::shared_ptr<const effects::Guide> make_guide(const Run&, const RunLayout&, const Eigen::VectorXd& eta);
simulation::Overrun overrun_of(const Case&, const Layout&, std::size_t r, const Run&, const Eigen::VectorXd& eta,
                               const std::vector<effects::Applied>&);
simulation::Model model_of(const Case&, const Layout&, const Eigen::VectorXd& eta);

/// y(x) by straight lines for a nearly increasing x, of at least one entry; ends held.
double at_place(const std::vector<double>& x, const std::vector<double>& y, double place);

/// A true signal at any time (no instrument): linear between history rows, continued with its last trend.
class Signal {
 public:
  Signal(const simulation::History&, const Channel&, const aircraft::Aircraft&);
  double operator()(double time) const;
  double slope(double time) const;

 private:
  std::vector<double> time_, value_;
  double last_slope_ = 0.0;
};

/// Predicted readings, instruments of `eta` included, in the order of `Rows`.
Eigen::VectorXd predict(const Run&, const Rows&, const Trace&, const RunLayout&, const Eigen::VectorXd& eta,
                        const aircraft::Aircraft&);

/// Columns of the instruments' unknowns (bias, scale, lag, clock), in the order clock, then per channel bias, scale,
/// lag.
Eigen::MatrixXd instrument_columns(const Run&, const Rows&, const Trace&, const RunLayout&, const Eigen::VectorXd& eta,
                                   const aircraft::Aircraft&);
std::vector<Eigen::Index> instrument_indices(const RunLayout&);

}  // namespace apc::learning
