#include "apc/study/result_text.h"

#include <cstdio>
#include <cstdlib>

#include "apc/base/require.h"

namespace apc::study {
namespace {

/// Writes fields one after the other; `Reader` meets them in the same order, so one function describes both ways.
struct Writer {
  std::string text;
  void field(double value) {
    char out[40];
    std::snprintf(out, sizeof out, "%a", value);
    text += out;
    text += '|';
  }
  void field(const std::string& value) {
    for (const char letter : value) text += letter == '|' || letter == '\n' || letter == '\t' ? ' ' : letter;
    text += '|';
  }
  void field(int value) { field(static_cast<double>(value)); }
  void field(long value) { field(static_cast<double>(value)); }
  void field(bool value) { field(value ? 1.0 : 0.0); }
  std::size_t count(std::size_t size) {
    field(static_cast<double>(size));
    return size;
  }
};

struct Reader {
  const std::string& text;
  std::size_t at = 0;
  std::string next() {
    const auto end = text.find('|', at);
    require(end != std::string::npos, "a stored case is incomplete. Remove the store and run the study again");
    const auto out = text.substr(at, end - at);
    at = end + 1;
    return out;
  }
  void field(double& value) { value = std::strtod(next().c_str(), nullptr); }
  void field(std::string& value) { value = next(); }
  void field(int& value) { value = static_cast<int>(std::strtod(next().c_str(), nullptr)); }
  void field(long& value) { value = static_cast<long>(std::strtod(next().c_str(), nullptr)); }
  void field(bool& value) { value = std::strtod(next().c_str(), nullptr) != 0.0; }
  std::size_t count(std::size_t) {
    double size = 0.0;
    field(size);
    require(size >= 0 && size < 1000, "a stored case is damaged. Remove the store and run the study again");
    return static_cast<std::size_t>(size);
  }
};

template <class Way, class Gear>
void gear_fields(Way& way, Gear& gear) {
  way.field(gear.name), way.field(gear.struts), way.field(gear.wheels);
  way.field(gear.peak_drag), way.field(gear.peak_drag_distance);
  way.field(gear.peak_vertical), way.field(gear.peak_vertical_distance), way.field(gear.mean_drag);
  way.field(gear.drag_limit), way.field(gear.drag_ultimate), way.field(gear.vertical_limit);
  way.field(gear.vertical_ultimate), way.field(gear.failed_by), way.field(gear.failed_at), way.field(gear.failed_time);
  way.field(gear.airborne), way.field(gear.lifted_at), way.field(gear.tire), way.field(gear.peak_tire_load);
  way.field(gear.tire_bottoming_load), way.field(gear.tire_bottomed);
  way.field(gear.drag_rule), way.field(gear.vertical_rule);
  way.field(gear.drag_margin), way.field(gear.ultimate_margin), way.field(gear.vertical_margin);
  way.field(gear.peak_stroke), way.field(gear.stroke), way.field(gear.bottomed);
  way.field(gear.peak_rut), way.field(gear.peak_penetration), way.field(gear.static_vertical);
}

template <class Way, class Result>
void scalar_fields(Way& way, Result& r) {
  way.field(r.message), way.field(r.entry_speed), way.field(r.stop_distance), way.field(r.runway_distance);
  way.field(r.exit_speed), way.field(r.stop_time), way.field(r.peak_deceleration), way.field(r.mean_deceleration);
  way.field(r.peak_deceleration_100ms), way.field(r.peak_pitch), way.field(r.lowest_pitch), way.field(r.mass);
  way.field(r.cg_behind_nose_gear), way.field(r.solver.method), way.field(r.solver.steps),
      way.field(r.solver.rhs_calls);
  way.field(r.solver.jacobians), way.field(r.solver.error_test_failures), way.field(r.solver.newton_failures);
  way.field(r.solver.wall_s), way.field(r.solver.rtol), way.field(r.airborne), way.field(r.lifted_at);
}

template <class Way, class Coverage>
void coverage_fields(Way& way, Coverage& c) {
  way.field(c.gear), way.field(c.tire), way.field(c.inside), way.field(c.speed_below), way.field(c.speed_above);
  way.field(c.depth_outside);
  way.field(c.penetration_outside);
}

}  // namespace

std::string to_text(const simulation::Result& result) {
  Writer way;
  way.field(static_cast<int>(result.outcome));
  scalar_fields(way, result);
  way.count(result.gears.size());
  for (const auto& gear : result.gears) gear_fields(way, gear);
  way.count(result.coverage.size());
  for (const auto& each : result.coverage) coverage_fields(way, each);
  way.count(result.energy.size());
  for (const auto& [sink, energy] : result.energy) way.field(sink), way.field(energy);
  way.count(result.warnings.size());
  for (const auto& warning : result.warnings) way.field(warning);
  return way.text;
}

simulation::Result result_from(const std::string& text) {
  Reader way{text};
  simulation::Result result;
  int outcome = 0;
  way.field(outcome);
  result.outcome = static_cast<simulation::Outcome>(outcome);
  scalar_fields(way, result);
  result.gears.resize(way.count(0));
  for (auto& gear : result.gears) gear_fields(way, gear);
  result.coverage.resize(way.count(0));
  for (auto& each : result.coverage) coverage_fields(way, each);
  for (std::size_t left = way.count(0); left > 0; --left) {
    const auto sink = way.next();
    way.field(result.energy[sink]);
  }
  result.warnings.resize(way.count(0));
  for (auto& warning : result.warnings) way.field(warning);
  return result;
}

std::string to_text(const std::vector<double>& values) {
  Writer way;
  for (const double value : values) way.field(value);
  return way.text;
}

std::vector<double> numbers_from(const std::string& text) {
  Reader way{text};
  std::vector<double> values;
  while (way.at < text.size()) {
    values.emplace_back();
    way.field(values.back());
  }
  return values;
}

}  // namespace apc::study
