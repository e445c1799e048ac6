/// Means of measured readings over short windows, and what a balance of forces makes of them: speed, acceleration_x,
/// the stop, and the surveyed ruts.
#pragma once

#include "apc/learning/load_balance.h"

namespace apc::learning {

/// One mean: over 0.1 s of a channel, over 2 m of a surveyed rut, or the stop alone.
struct Reading {
  enum class Kind { signal, stop, rut };
  Kind kind = Kind::signal;
  std::size_t channel = 0;  ///< signals
  Quantity quantity = Quantity::speed;
  std::size_t gear = 0;                 ///< ruts: which group's
  double from = 0.0, to = 0.0;          ///< s; ruts: m from the leading edge
  double value = 0.0, deviation = 1.0;  ///< of independent noise
  bool is(Quantity q) const { return kind == Kind::signal && quantity == q; }
};

/// Of the whole motion, and of the ruts along the bed.
std::vector<Reading> readings_of(const Case&, const std::vector<GearFacts>&, const Run&, const Motion&);

/// What would have been read, mean lags included, when the balance held and the entry speed was this.
Eigen::VectorXd read_off(const std::vector<Reading>&, const std::vector<GearFacts>&, const Run&, const Motion&,
                         const Balance&, double entry_speed);

/// Mean delay of a reading, s.
double mean_delay(const Run&, const Reading&);

}  // namespace apc::learning
