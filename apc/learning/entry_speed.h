/// How fast a run crossed the leading edge. The speed recorded for the entry is one reading; a speed signal that began
/// on the pavement tells it anew, and where the two do not contradict each other the mean by their precisions is taken.
/// Half a percent of entry speed is one percent of the way to rest.
#pragma once

#include "apc/learning/measured.h"

namespace apc::learning {

struct EntrySpeed {
  double value = 0.0, deviation = 0.0;  ///< m/s
};

/// The straight line through the readings of the last 2 s before entry, at entry, its mean delay taken off; noise, bias
/// and scale make up the deviation. Null: fewer than five readings.
std::optional<EntrySpeed> entry_speed_of_signal(const Run&);

/// Recorded and signal together. The recorded one alone where there is no signal, or where they lie more than four
/// deviations apart: one of them is at fault, and it is not known which.
EntrySpeed entry_speed(const Run&);

}  // namespace apc::learning
