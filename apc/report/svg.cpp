#include "apc/report/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace apc::report {

std::vector<Tick> ticks(double low, double high, const Scale& scale, int count) {
  const double from = low / scale.factor, to = high / scale.factor;
  const double raw = (to - from) / std::max(1, count);
  if (!(raw > 0) || !std::isfinite(raw)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double step = raw / power < 1.5   ? power
                      : raw / power < 3.5 ? 2 * power
                      : raw / power < 7.5 ? 5 * power
                                          : 10 * power;
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> out;
  for (double at = std::ceil(from / step - 1e-9); at * step <= to + 1e-9 * step; at += 1.0)
    out.push_back({at * step * scale.factor, number(at * step, digits)});
  return out;
}

std::string pixel(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  std::string out = text;
  if (out.ends_with(".0")) out.erase(out.size() - 2);
  return out == "-0" ? "0" : out;
}

std::string path(const std::vector<double>& x, const std::vector<double>& y, const Axis& across, const Axis& up) {
  std::string out;
  bool drawing = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      drawing = false;
      continue;
    }
    out += drawing ? 'L' : 'M';
    out += pixel(across(x[i]));
    out += ',';
    out += pixel(up(y[i]));
    drawing = true;
  }
  return out;
}

std::string either(const std::string& tag, const std::string& for_field, const std::string& for_si) {
  return "<" + tag + " class=\"field\">" + for_field + "</" + tag + "><" + tag + " class=\"si\">" + for_si + "</" +
         tag + ">";
}

std::string both(double value, const Measure& measure) {
  return either("span", shown(value, measure, UnitSystem::field), shown(value, measure, UnitSystem::si));
}

std::string both_numbers(double value, const Measure& measure) {
  return either("span", number(value / measure.field.factor, measure.field.digits),
                number(value / measure.si.factor, measure.si.digits));
}

std::string both_units(const Measure& measure) { return either("span", measure.field.unit, measure.si.unit); }

}  // namespace apc::report
