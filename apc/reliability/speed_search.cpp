#include "apc/reliability/speed_search.h"

#include <algorithm>
#include <cmath>

namespace apc::reliability {

SpeedSearch::SpeedSearch(double guess, double exponent, const SearchRange& range)
    : range_(range),
      expected_(exponent),
      exponent_(exponent),
      next_(std::clamp(guess, range.low, std::max(range.low, range.high))),
      doubt_(range.doubt),
      foretold_(std::nan("")) {}

void SpeedSearch::ask(double speed) {
  const double low = low_.known ? std::exp(low_.x) : range_.low, high = high_.known ? std::exp(high_.x) : range_.high;
  if (!done_) next_ = std::clamp(speed, low, std::max(low, high)), foretold_ = std::nan("");
}

void SpeedSearch::tell(double speed, double ratio) {
  if (done_) return;
  const Point now{std::log(speed), std::log(std::clamp(ratio, 1e-3, 1e3)), true};
  if (std::isfinite(foretold_) && speed == next_)
    doubt_ = std::clamp(std::abs(now.y - foretold_) / std::max(1e-3, std::abs(last_.y - foretold_)), 0.5 * range_.doubt,
                        1.0);
  const bool two = last_.known && std::abs(now.x - last_.x) > 1e-6;
  if (two) {
    if (!std::isfinite(foretold_)) doubt_ = 0.5 * range_.doubt;
    const double slope = (now.y - last_.y) / (now.x - last_.x);
    exponent_ = std::clamp(slope, expected_ / 4, expected_ * 4);
  }
  last_ = now, foretold_ = std::nan("");
  if (++rounds_ > 40) {  // only a ratio that jumps to and fro gets here
    next_ = low_.known ? std::exp(low_.x) : range_.low, done_ = true;
    return;
  }
  if (now.y <= 0 && speed >= range_.high - 1e-9) {
    next_ = range_.high, done_ = true;
    return;
  }
  if (now.y > 0 && speed <= range_.low + 1e-9) {
    next_ = 0.0, done_ = true;
    return;
  }
  // Where a ratio falls back below 1 at a higher speed, the lowest crossing counts.
  if (now.y > 0) {
    if (!high_.known || now.x < high_.x) high_ = now;
    if (low_.known && low_.x >= high_.x) low_.known = false;
  } else if ((!high_.known || now.x < high_.x) && (!low_.known || now.x > low_.x)) {
    low_ = now;
  }
  if (low_.known && high_.known)
    step_within();
  else
    step_outwards(high_.known ? high_ : low_);
  if (done_ || !two) return;
  const Point& from = high_.known ? high_ : low_;
  const double slope = low_.known && high_.known ? (high_.y - low_.y) / (high_.x - low_.x) : exponent_;
  foretold_ = from.y + slope * (std::log(next_) - from.x);
}

/// Between the two: the straight line through them, or the middle when that line closes in too slowly.
void SpeedSearch::step_within() {
  const double gap = high_.x - low_.x;
  slow_ = gap <= 0.5 * gap_ || gap_ == 0.0 ? 0 : slow_ + 1;
  if (slow_ == 0) gap_ = gap;
  const double between = low_.x + gap * low_.y / (low_.y - high_.y);
  if (slow_ >= 2) {
    slow_ = 0, gap_ = gap;
    next_ = std::exp(0.5 * (low_.x + high_.x));
    done_ = std::exp(high_.x) - std::exp(low_.x) <= range_.tolerance;
    return;
  }
  const double nearest = between - low_.x < high_.x - between ? low_.x : high_.x;
  accept_or_go(nearest, between - nearest);
  if (done_) return;
  // A little beyond the line's root, towards the far side: the next point then closes the gap from there.
  const double push = 0.1 * (between - nearest);
  next_ = std::exp(std::clamp(between + push, low_.x + 1e-3 * gap, high_.x - 1e-3 * gap));
}

void SpeedSearch::step_outwards(const Point& from) {
  // A load hardly grows with speed now and then: no step goes farther than this.
  constexpr double farthest = 0.5;
  const double step = std::clamp(-from.y / exponent_, -farthest, farthest);
  accept_or_go(from.x, step);
  if (!done_) next_ = std::clamp(std::exp(from.x + 1.1 * step), range_.low, range_.high);
}

void SpeedSearch::accept_or_go(double x, double step) {
  const double from = std::exp(x), to = std::exp(x + step);
  if (doubt_ * std::abs(to - from) > range_.tolerance) return;
  next_ = to >= range_.high ? range_.high : to < range_.low ? 0.0 : to;
  done_ = true;
}

}  // namespace apc::reliability
