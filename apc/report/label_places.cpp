#include "apc/report/label_places.h"

#include <algorithm>
#include <cmath>

namespace apc::report {
namespace {

// Of the text of a chart, 12 px high on a desk and 14 px on a phone: the larger.
constexpr double letter = 7.2, ascent = 11.0, descent = 3.0;

Box box_of(const LabelPlace& place, std::size_t letters) {
  const double wide = letter * static_cast<double>(letters);
  const double left = place.anchor == "start" ? place.x : place.anchor == "end" ? place.x - wide : place.x - 0.5 * wide;
  return {left, place.y - ascent, left + wide, place.y + descent};
}

/// Length of a segment inside a box (Liang and Barsky's clipping).
double inside(const Box& box, double x0, double y0, double x1, double y1) {
  double from = 0.0, to = 1.0;
  const auto clip = [&](double direction, double room) {
    if (direction == 0.0) return room >= 0;
    const double at = room / direction;
    if (direction < 0)
      from = std::max(from, at);
    else
      to = std::min(to, at);
    return from <= to;
  };
  const double dx = x1 - x0, dy = y1 - y0;
  const bool crosses =
      clip(-dx, x0 - box.left) && clip(dx, box.right - x0) && clip(-dy, y0 - box.top) && clip(dy, box.bottom - y0);
  return crosses ? (to - from) * std::hypot(dx, dy) : 0.0;
}

}  // namespace

void LabelPlaces::avoid_curve(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t i = 0; i + 1 < x.size() && i + 1 < y.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i]) && std::isfinite(x[i + 1]) && std::isfinite(y[i + 1]))
      segments_.push_back({x[i], y[i], x[i + 1], y[i + 1]});
}

double LabelPlaces::hidden(const Box& box) const {
  double sum = 0.0;
  for (const auto& each : segments_) sum += inside(box, each.x0, each.y0, each.x1, each.y1);
  for (const double y : levels_)
    if (y > box.top && y < box.bottom) sum += box.right - box.left;
  for (const auto& each : taken_) {
    const double wide = std::min(each.right, box.right) - std::max(each.left, box.left);
    const double tall = std::min(each.bottom, box.bottom) - std::max(each.top, box.top);
    if (wide > 0 && tall > 0) sum += 20.0 * wide;
  }
  const double out = std::max({0.0, frame_.left - box.left, box.right - frame_.right}) +
                     std::max({0.0, frame_.top - box.top, box.bottom - frame_.bottom});
  return sum + 100.0 * out;
}

LabelPlace LabelPlaces::best(const std::vector<LabelPlace>& places, std::size_t letters) {
  const LabelPlace* best = nullptr;
  double least = 0.0;
  for (const auto& each : places)
    if (const double sum = hidden(box_of(each, letters)); !best || sum < least - 1.0) best = &each, least = sum;
  taken_.push_back(box_of(*best, letters));
  return *best;
}

LabelPlace LabelPlaces::at_level(double y, std::size_t letters) {
  std::vector<LabelPlace> places;
  const double middle = 0.5 * (frame_.left + frame_.right);
  for (const double baseline : {y - 5, y + 13, y - 17, y + 26})
    for (const auto& [x, anchor] : {std::pair{frame_.right - 3, "end"},
                                    {frame_.left + 4, "start"},
                                    {middle, "middle"},
                                    {0.5 * (middle + frame_.right), "middle"},
                                    {0.5 * (middle + frame_.left), "middle"}})
      places.push_back({x, baseline, anchor});
  return best(places, letters);
}

LabelPlace LabelPlaces::at_vertical(double x, std::size_t letters) {
  std::vector<LabelPlace> places;
  const bool leftward = x > frame_.left + 0.6 * (frame_.right - frame_.left);
  for (const double baseline :
       {frame_.top + 12, frame_.top + 26, frame_.top + 40, frame_.bottom - 6, frame_.bottom - 20})
    for (const bool left : {leftward, !leftward})
      places.push_back({left ? x - 4 : x + 4, baseline, left ? "end" : "start"});
  return best(places, letters);
}

std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

}  // namespace apc::report
