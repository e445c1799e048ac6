/// Means of instrument readings over short windows, and what a balance of forces makes of them: speed,
/// acceleration_x, acceleration_z, changes of the pitch rate, and the stop.
#pragma once

#include "apc/learning/rut_balance.h"

namespace apc::learning {

/// One mean. `channel` is npos for the stop; a pitch-rate reading is the difference of the means of two windows.
struct Reading {
  static constexpr std::size_t no_channel = static_cast<std::size_t>(-1);
  std::size_t channel = no_channel;
  Quantity quantity = Quantity::speed;
  double from = 0.0, to = 0.0;          ///< s
  double value = 0.0, deviation = 1.0;  ///< of independent noise
  bool is_stop() const { return channel == no_channel; }
};

/// Windows of 0.1 s of the whole motion; vertical channels from where the main gear is in the full depth of the bed.
std::vector<Reading> readings_of(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&);

/// What the instruments would have read, mean lags included, when the balance held and the entry speed was this.
Eigen::VectorXd read_off(const std::vector<Reading>&, const Run&, const Motion&, const Balance&, double entry_speed);

/// Mean delay of a channel, s.
double mean_delay(const Run&, const Reading&);

}  // namespace apc::learning
