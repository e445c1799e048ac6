#include "apc/simulation/carried_peak.h"

#include <algorithm>

namespace apc::simulation {

void CarriedPeak::offer(double value, double slope) {
  if (value > value_) value_ = value, slope_ = slope;
}

void CarriedPeak::offer_between(double value, const Sample& before, const Sample& after) {
  if (before.rate > 0.0 && after.rate < 0.0)
    offer(value, (before.slope * after.rate - after.slope * before.rate) / (after.rate - before.rate));
  else
    offer(value, 0.5 * (before.slope + after.slope));
}

/// A signal that rises before and falls after the corner, or jumps there to its lower side, peaks at the corner.
void CarriedPeak::offer_corner(const Side& before, const Side& after) {
  const bool rises = before.rate > 0.0, falls = after.rate < 0.0;
  if (rises && (falls || after.value < before.value)) offer(before.value, before.moving);
  if (falls && (rises || after.value > before.value)) offer(after.value, after.moving);
}

/// The slope at the vertex is taken between its neighbours: it changes fast where p moves the peak in time.
void CarriedPeak::see(double time, double value, double slope) {
  offer(value, slope);
  if (count_ > 1 && last_.value >= before_.value && last_.value >= value && last_.value >= value_) {
    const double t0 = before_.time - last_.time, t1 = time - last_.time;
    const double y0 = before_.value - last_.value, y1 = value - last_.value;
    const double curvature = (y1 / t1 - y0 / t0) / (t1 - t0), tilt = y1 / t1 - curvature * t1;
    if (curvature < 0.0) {
      const double shift = std::clamp(-0.5 * tilt / curvature, t0, t1);
      const double share = shift < 0.0 ? shift / t0 : shift / t1;
      value_ = last_.value + (tilt + curvature * shift) * shift;
      slope_ = last_.slope + share * ((shift < 0.0 ? before_.slope : slope) - last_.slope);
    }
  }
  before_ = last_;
  last_ = {time, value, slope};
  ++count_;
}

}  // namespace apc::simulation
