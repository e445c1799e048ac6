#include "apc/base/quantity.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc {
namespace {

struct NamedUnit {
  const char* name;
  double factor;
  Dimension dimension;
  double offset = 0.0;
};

namespace u = units;
namespace d = dimension;

const std::vector<NamedUnit>& known_units() {
  static const std::vector<NamedUnit> table{
      {"m", 1, d::length},
      {"mm", u::mm, d::length},
      {"cm", u::cm, d::length},
      {"km", u::km, d::length},
      {"ft", u::ft, d::length},
      {"in", u::in, d::length},
      {"nmi", u::nmi, d::length},
      {"s", 1, d::time},
      {"ms", u::ms, d::time},
      {"min", u::min, d::time},
      {"h", u::hour, d::time},
      {"day", u::day, d::time},
      {"year", u::year, d::time},
      {"kg", 1, d::mass},
      {"t", u::t, d::mass},
      {"lb", u::lb, d::mass},
      {"lbs", u::lb, d::mass},
      {"lbm", u::lb, d::mass},
      {"N", 1, d::force},
      {"kN", u::kN, d::force},
      {"MN", u::MN, d::force},
      {"lbf", u::lbf, d::force},
      {"kip", u::kip, d::force},
      {"Pa", 1, d::pressure},
      {"kPa", u::kPa, d::pressure},
      {"MPa", u::MPa, d::pressure},
      {"psi", u::psi, d::pressure},
      {"psf", u::psf, d::pressure},
      {"kt", u::kt, d::speed},
      {"mph", u::mph, d::speed},
      {"g", u::g0, d::acceleration},
      {"deg", u::deg, d::angle},
      {"rad", 1, d::angle},
      {"rpm", u::rpm, d::angular_speed},
      {"K", 1, d::temperature},
      {"degC", 1, d::temperature, 273.15},
      {"degF", 5.0 / 9.0, d::temperature, 459.67 * 5.0 / 9.0},
      {"pcf", u::pcf, d::density},
      {"J", 1, d::energy},
      {"kJ", u::kJ, d::energy},
      {"MJ", u::MJ, d::energy},
      {"W", 1, {{1, 2, -3, 0}}},
      {"kW", 1e3, {{1, 2, -3, 0}}},
      {"Hz", 1, d::frequency},
  };
  return table;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

const NamedUnit& find_unit(std::string_view name, std::string_view whole) {
  for (const auto& unit : known_units())
    if (name == unit.name) return unit;
  std::vector<std::string> names;
  for (const auto& unit : known_units()) names.emplace_back(unit.name);
  const auto near = nearest(name, names.data(), names.size());
  throw InputError(concat("unknown unit \"", name, "\"", name == whole ? "" : concat(" in \"", whole, "\""),
                          near.empty() ? std::string() : concat(". Did you mean \"", near, "\"?")));
}

void multiply(Unit& unit, const NamedUnit& factor, int power) {
  unit.factor *= std::pow(factor.factor, power);
  for (std::size_t i = 0; i < 4; ++i) unit.dimension.exponents[i] += power * factor.dimension.exponents[i];
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

}  // namespace

std::string nearest(std::string_view word, const std::string* candidates, std::size_t count) {
  std::string best;
  std::size_t least = word.size() / 3 + 2;
  for (std::size_t i = 0; i < count; ++i) {
    const auto distance = edit_distance(word, candidates[i]);
    if (distance < least && distance < std::max(word.size(), candidates[i].size()))
      least = distance, best = candidates[i];
  }
  return best;
}

DimensionName name_of(const Dimension& wanted) {
  const std::vector<std::pair<Dimension, DimensionName>> names{
      {d::none, {"a number or an angle", "2 deg"}},
      {d::mass, {"a mass", "65000 kg"}},
      {d::length, {"a length", "24 in"}},
      {d::time, {"a time", "0.1 s"}},
      {d::temperature, {"a temperature", "15 degC"}},
      {d::speed, {"a speed", "70 kt"}},
      {d::acceleration, {"an acceleration", "0.5 g"}},
      {d::force, {"a force", "44700 lbf"}},
      {d::pressure, {"a pressure", "50 psi"}},
      {d::energy, {"an energy", "1.2 MJ"}},
      {d::area, {"an area", "124.6 m^2"}},
      {d::volume, {"a volume", "0.0041 m^3"}},
      {d::density, {"a density", "320 kg/m^3"}},
      {d::inertia, {"a moment of inertia", "3.0e6 kg m^2"}},
      {d::stiffness, {"a stiffness", "78 MN/m"}},
      {d::square_damping, {"a square-law damping", "9.0e4 N s^2/m^2"}},
      {d::damping, {"a damping", "2.0e4 N s/m"}},
      {d::frequency, {"an angular speed or a frequency", "10 rad/s"}},
      {d::angular_damping, {"an angular damping", "1e4 kg m^2/s"}},
      {d::per_length, {"a reciprocal length", "0.5 1/m"}}};
  for (const auto& [dimension, name] : names)
    if (dimension == wanted) return name;
  return {"another dimension", "1"};
}

Unit parse_unit(std::string_view text) {
  text = trimmed(text);
  Unit unit;
  int sign = 1;
  std::size_t at = 0, factors = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '/') {
      sign = -1;
      ++at;
    } else if (c == ' ' || c == '*' || c == '-' || c == '(' || c == ')') {
      ++at;
    } else if (c == '1') {  // "1/m"
      ++at, ++factors;
    } else {
      std::size_t end = at;
      while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
      require(end > at, "cannot read the unit \"", text, "\" at \"", text.substr(at), "\"");
      const auto& named = find_unit(text.substr(at, end - at), text);
      int power = 1;
      if (end < text.size() && (text[end] == '^' || std::isdigit(static_cast<unsigned char>(text[end])))) {
        if (text[end] == '^') ++end;
        const auto [next, error] = std::from_chars(text.data() + end, text.data() + text.size(), power);
        require(error == std::errc(), "cannot read the power in the unit \"", text, "\"");
        end = static_cast<std::size_t>(next - text.data());
      }
      multiply(unit, named, sign * power);
      if (named.offset != 0.0 && end - at == text.size() && power == 1) unit.offset = named.offset;
      at = end, ++factors;
    }
  }
  require(factors > 0, "the unit is missing");
  return unit;
}

double parse_quantity(std::string_view text, const Dimension& wanted) {
  const auto whole = trimmed(text);
  const auto expected = name_of(wanted);
  double number = 0.0;
  const char* const begin = whole.data() + (!whole.empty() && whole.front() == '+' ? 1 : 0);
  const auto [rest, error] = std::from_chars(begin, whole.data() + whole.size(), number);
  require(error == std::errc(), "\"", text, "\" does not start with a number. Write ", expected.name, " such as \"",
          expected.example, "\"");
  require(std::isfinite(number), "\"", text, "\" is not a finite number. Write ", expected.name, " such as \"",
          expected.example, "\"");
  const auto unit_text = trimmed({rest, static_cast<std::size_t>(whole.data() + whole.size() - rest)});
  if (unit_text.empty()) {
    require(wanted == dimension::none, "\"", whole, "\" has no unit (", expected.name,
            " is needed). Write for example \"", expected.example, "\"");
    return number;
  }
  Unit unit;
  try {
    unit = parse_unit(unit_text);
  } catch (const InputError& reason) {
    throw InputError(concat("\"", whole, "\": ", reason.what(), " (", expected.name, " is needed, such as \"",
                            expected.example, "\")"));
  }
  require(unit.dimension == wanted, "\"", whole, "\" is ", name_of(unit.dimension).name, ", but ", expected.name,
          " is needed. Write for example \"", expected.example, "\"");
  return unit.factor * number + unit.offset;
}

}  // namespace apc
