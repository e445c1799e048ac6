#include "apc/learning/quantity_json.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "apc/base/quantity.h"

namespace apc::learning {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

nlohmann::ordered_json quantity(double value, const std::string& unit) {
  if (unit.empty()) return std::stod(short_number(value));
  const Unit u = parse_unit(unit);
  return short_number(value / u.factor) + " " + unit;
}

}  // namespace apc::learning
