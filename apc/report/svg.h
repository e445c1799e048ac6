/// Small parts that every drawing of a page is made of: axes, ticks, coordinates, text in both systems of units.
#pragma once

#include <string>
#include <vector>

#include "apc/base/markup.h"
#include "apc/report/unit_system.h"

namespace apc::report {

/// A linear map from values (SI) to pixels.
struct Axis {
  double low = 0.0, high = 1.0;              ///< values
  double pixel_low = 0.0, pixel_high = 1.0;  ///< where they lie
  double operator()(double value) const { return pixel_low + (value - low) / (high - low) * (pixel_high - pixel_low); }
};

/// A tick: its value in SI and its label in the unit of the axis.
struct Tick {
  double value = 0.0;
  std::string label;
};

/// About `count` round numbers (1, 2 or 5 times a power of ten, in the scale's unit) within [low, high] (SI).
std::vector<Tick> ticks(double low, double high, const Scale&, int count);

/// A coordinate with one decimal, enough for a pixel.
std::string pixel(double value);

/// "M x,y L x,y …" through the points with finite values; breaks where one is not.
std::string path(const std::vector<double>& x, const std::vector<double>& y, const Axis& across, const Axis& up);

/// HTML: the value in either system, the page shows one of them.
std::string both(double value, const Measure&);
/// HTML: the same without its unit, for tables that name it in their heading.
std::string both_numbers(double value, const Measure&);
/// HTML: the unit's name alone in either system.
std::string both_units(const Measure&);
/// `for_field` and `for_si` wrapped so that the page shows one of them; `tag` is "span" in HTML, "g" or "tspan" in SVG.
std::string either(const std::string& tag, const std::string& for_field, const std::string& for_si);

}  // namespace apc::report
