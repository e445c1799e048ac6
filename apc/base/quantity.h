/// Quantities with units: `"70 kt"`, `"3.0e6 kg m^2"`, `"9e4 N s^2/m^2"`, `"3.75e-5 lbf-s^2/in^4"`.
///
/// A unit is a product, quotient or power of the names in `quantity.cpp`; a space, `*`, `-` between names multiply, `/`
/// divides everything that follows it up to the next `/` or the end (`N s^2/m^2`). Temperatures with an offset (degC,
/// degF) stand alone.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace apc {

/// Exponents of kg, m, s, K. Angles carry none: radians are 1.
struct Dimension {
  std::array<int, 4> exponents{};
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{}, mass{{1, 0, 0, 0}}, length{{0, 1, 0, 0}}, time{{0, 0, 1, 0}},
    temperature{{0, 0, 0, 1}}, speed{{0, 1, -1, 0}}, acceleration{{0, 1, -2, 0}}, force{{1, 1, -2, 0}},
    pressure{{1, -1, -2, 0}}, energy{{1, 2, -2, 0}}, area{{0, 2, 0, 0}}, volume{{0, 3, 0, 0}}, density{{1, -3, 0, 0}},
    inertia{{1, 2, 0, 0}}, stiffness{{1, 0, -2, 0}}, square_damping{{1, -1, 0, 0}}, angle{},
    angular_speed{{0, 0, -1, 0}}, angular_stiffness{{1, 2, -2, 0}}, damping{{1, 0, -1, 0}},
    angular_damping{{1, 2, -1, 0}}, frequency{{0, 0, -1, 0}}, per_length{{0, -1, 0, 0}};
}  // namespace dimension

/// What a dimension is called and an example of it, for messages: {"a speed", "70 kt"}.
struct DimensionName {
  std::string name, example;
};
DimensionName name_of(const Dimension&);

struct Unit {
  double factor = 1.0;  ///< SI = factor · value + offset
  double offset = 0.0;
  Dimension dimension{};
};

/// Throws InputError naming the unknown part and the nearest known unit.
Unit parse_unit(std::string_view text);

/// SI value of `"70 kt"`. Throws InputError (without a place: callers add file and path) when the number is missing or
/// not finite, the unit is missing or unknown, or the dimension is not `wanted`.
double parse_quantity(std::string_view text, const Dimension& wanted);

/// The candidate nearest to `word` by edit distance, or "" when none is near.
std::string nearest(std::string_view word, const std::string* candidates, std::size_t count);

}  // namespace apc
