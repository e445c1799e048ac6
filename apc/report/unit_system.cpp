#include "apc/report/unit_system.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "apc/base/units.h"

namespace apc::report {

namespace u = units;

namespace measure {
const Measure speed{{"kt", u::kt, 1}, {"m/s", 1.0, 2}};
const Measure distance{{"ft", u::ft, 1}, {"m", 1.0, 2}};
const Measure depth{{"in", u::in, 1}, {"mm", u::mm, 0}};
const Measure force{{"lbf", u::lbf, 0}, {"kN", u::kN, 1}};
const Measure mass{{"lb", u::lb, 0}, {"kg", 1.0, 0}};
const Measure acceleration{{"g", u::g0, 3}, {"m/s²", 1.0, 2}};
const Measure angle{{"deg", u::deg, 2}, {"deg", u::deg, 2}};
const Measure time{{"s", 1.0, 2}, {"s", 1.0, 2}};
const Measure energy{{"10⁶ ft·lbf", 1e6 * u::lbf* u::ft, 3}, {"MJ", u::MJ, 3}};
const Measure pressure{{"psi", u::psi, 0}, {"kPa", u::kPa, 0}};
const Measure density{{"pcf", u::pcf, 1}, {"kg/m³", 1.0, 0}};
const Measure ratio{{"", 1.0, 3}, {"", 1.0, 3}};
const Measure volume{{"cu yd", 27.0 * u::ft* u::ft* u::ft, 0}, {"m³", 1.0, 0}};
}  // namespace measure

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  char plain[64];
  std::snprintf(plain, sizeof plain, "%.*f", digits, value);
  std::string_view digits_left = plain;
  const bool negative = digits_left.front() == '-';
  if (negative) digits_left.remove_prefix(1);
  const auto point = std::min(digits_left.find('.'), digits_left.size());
  std::string text;
  if (negative && digits_left.find_first_not_of("0.") != std::string_view::npos) text += '-';  // no "-0.0"
  for (std::size_t at = 0; at < digits_left.size(); ++at) {
    if (at > 0 && at < point && (point - at) % 3 == 0) text += ',';
    text += digits_left[at];
  }
  return text;
}

std::string shown(double value, const Measure& measure, UnitSystem system) {
  const auto& scale = measure.in(system);
  return number(value / scale.factor, scale.digits) + (*scale.unit ? " " : "") + scale.unit;
}

std::string percent(double share, int digits) { return number(100.0 * share, digits) + " %"; }

}  // namespace apc::report
