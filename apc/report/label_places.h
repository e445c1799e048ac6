/// Where the name of a line across a chart may stand: near its line, inside the frame, and on nothing else that is
/// drawn there. The first of a list of places that hides least is taken.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace apc::report {

/// Pixels; y grows downwards.
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct LabelPlace {
  double x = 0.0, y = 0.0;  ///< of the text's anchor and baseline
  std::string anchor;       ///< "start", "middle" or "end"
};

class LabelPlaces {
 public:
  explicit LabelPlaces(const Box& frame) : frame_(frame) {}
  /// A curve as drawn; points that are not finite break it.
  void avoid_curve(const std::vector<double>& x, const std::vector<double>& y);
  void avoid_level(double y) { levels_.push_back(y); }
  /// For a text of `letters` letters at a line across at `y`. The place is then taken.
  LabelPlace at_level(double y, std::size_t letters);
  /// For a text beside an upright line at `x`, near the top.
  LabelPlace at_vertical(double x, std::size_t letters);

 private:
  struct Segment {
    double x0, y0, x1, y1;
  };
  LabelPlace best(const std::vector<LabelPlace>&, std::size_t letters);
  double hidden(const Box&) const;

  Box frame_;
  std::vector<Segment> segments_;
  std::vector<double> levels_;
  std::vector<Box> taken_;
};

/// Letters of a UTF-8 text.
std::size_t letters_of(const std::string& text);

}  // namespace apc::report
