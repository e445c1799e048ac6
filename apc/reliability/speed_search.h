/// The speed at which a growing ratio reaches 1, asked for in as few runs as its accuracy needs. Ratios of an overrun
/// are nearly powers of the speed (a stop distance about v², a peak load v^0.1 to v^0.5), so the search moves along
/// straight lines of ln(ratio) over ln(v): from one point with the exponent expected, from two with their own.
///
/// It stops when what the last step may be wrong by, a share of its length, is below `tolerance`: the answer is then
/// the end of that step, at which no run was made. The share is `doubt` along the exponent expected, half of it along a
/// line through two points, and more, up to all of it, after a line through two points has missed (a load that jumps).
/// Between a speed that can be handled and one that cannot, steps that do not halve the gap in two rounds give way to
/// bisection.
#pragma once

namespace apc::reliability {

struct SearchRange {
  double low = 5.0, high = 60.0;  ///< m/s; the answer is `high` when even that can be handled, 0 when `low` cannot
  double tolerance = 0.1;         ///< m/s
  double doubt = 0.15;            ///< relative, of a step along the straight line
};

class SpeedSearch {
 public:
  /// `guess` within the range; `exponent` expected of the ratio.
  SpeedSearch(double guess, double exponent, const SearchRange&);
  bool done() const { return done_; }
  /// To be tried next, m/s; the answer once it is done.
  double speed() const { return next_; }
  /// What came out at `speed()`: ≤ 1 = can be handled.
  void tell(double ratio) { tell(next_, ratio); }
  /// What is known at any speed, say from a run made for another question.
  void tell(double speed, double ratio);
  /// Puts another speed in place of the next one, when the caller knows a better one.
  void ask(double speed);
  /// Exponent between the two points nearest to the answer; the expected one while there is only one.
  double exponent() const { return exponent_; }

 private:
  struct Point {
    double x = 0.0, y = 0.0;  ///< ln v, ln ratio
    bool known = false;
  };
  void step_within();
  void step_outwards(const Point& from);
  void accept_or_go(double x, double step);

  SearchRange range_;
  double expected_, exponent_, next_;
  Point low_, high_, last_;  ///< the highest speed that can be handled, the lowest that cannot, the latest
  double doubt_;             ///< now
  double foretold_;          ///< ln ratio at the next speed by a line through two points; NaN = no such line
  double gap_ = 0.0;         ///< ln of the speeds' ratio when it was last halved
  int slow_ = 0;             ///< rounds since
  int rounds_ = 0;
  bool done_ = false;
};

}  // namespace apc::reliability
